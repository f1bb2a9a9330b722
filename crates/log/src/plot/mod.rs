//! Line charts as SVG text.
//!
//! ```
//! use pelletflow_log::plot::{Axis, Chart, Series, SeriesStyle};
//!
//! let chart = Chart {
//!     title: "Free fall".into(),
//!     x: Axis::linear("time [s]"),
//!     y: Axis::linear("speed [m/s]"),
//!     series: vec![Series {
//!         label: "in vacuum".into(),
//!         points: vec![[0.0, 0.0], [1.0, 9.81]],
//!         style: SeriesStyle::Line,
//!     }],
//! };
//! assert!(chart.to_svg()?.starts_with("<svg"));
//! # Ok::<(), pelletflow_log::plot::ChartError>(())
//! ```

mod drawing;

pub(crate) use drawing::color_of;

use plotters::prelude::IntoLogRange;
use std::ops::Range;

/// Room left between the outermost points and the frame, as a share of the range [-].
const MARGIN: f64 = 0.04;

/// Size of a chart that is a file of its own, width and height [px].
const SIZE: [u32; 2] = [760, 460];

/// A chart of lines and markers over two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// What the chart shows; where it is empty, none is drawn.
    pub title: String,
    /// The axis to the right.
    pub x: Axis,
    /// The axis upward.
    pub y: Axis,
    /// What is drawn, in the order of the legend.
    pub series: Vec<Series>,
}

/// An axis of a chart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis {
    /// Quantity with its unit, such as `time [ms]`.
    pub label: String,
    /// How values are laid out along it.
    pub scale: Scale,
}

impl Axis {
    /// An axis of equal steps.
    pub fn linear(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            scale: Scale::Linear,
        }
    }

    /// An axis of equal ratios.
    pub fn logarithmic(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            scale: Scale::Logarithmic,
        }
    }
}

/// How values are laid out along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps are equally long.
    Linear,
    /// Equal ratios are equally long.
    Logarithmic,
}

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend; one that is empty is left out there.
    pub label: String,
    /// Points, x before y, in the units that the axes name [-].
    pub points: Vec<[f64; 2]>,
    /// How they are drawn.
    pub style: SeriesStyle,
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeriesStyle {
    /// A line from point to point.
    Line,
    /// A dashed line, as for a fit or a reference.
    Dashed,
    /// A marker on each point.
    Markers,
    /// A line with a marker on each point.
    LineWithMarkers,
}

impl SeriesStyle {
    fn has_line(self) -> bool {
        matches!(self, Self::Line | Self::LineWithMarkers)
    }

    fn has_markers(self) -> bool {
        matches!(self, Self::Markers | Self::LineWithMarkers)
    }
}

/// A chart as it was drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Drawing {
    /// The text of an SVG file.
    pub svg: String,
    /// Left, right, upper and lower end of what the axes enclose [px].
    pub frame: [i32; 4],
}

/// A chart that cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ChartError {
    /// There is nothing in it.
    #[error("chart `{title}` has no points; give at least one series with one point")]
    Empty {
        /// The chart.
        title: String,
    },
    /// A point has no place on an axis.
    #[error(
        "point {index} of series `{series}` in chart `{title}` is {value} along `{axis}`; expected {expected}"
    )]
    NoPlace {
        /// The chart.
        title: String,
        /// The series.
        series: String,
        /// Which point, counted from 0 [-].
        index: usize,
        /// Label of the axis.
        axis: String,
        /// The value, in the unit that the axis names [-].
        value: f64,
        /// The bound.
        expected: &'static str,
    },
    /// The drawing library refused.
    #[error("chart `{title}` cannot be drawn: {reason}")]
    Refused {
        /// The chart.
        title: String,
        /// Why.
        reason: String,
    },
}

impl Chart {
    /// The chart as the text of an SVG file.
    ///
    /// # Errors
    ///
    /// When there is no point, or one is not finite or not positive where the axis is logarithmic.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.drawing(SIZE).map(|drawing| drawing.svg)
    }

    /// The chart drawn with a width and a height [px].
    ///
    /// # Errors
    ///
    /// As for [`Chart::to_svg`].
    pub fn drawing(&self, size: [u32; 2]) -> Result<Drawing, ChartError> {
        let x = self.range(0)?;
        let y = self.range(1)?;
        match (self.x.scale, self.y.scale) {
            (Scale::Linear, Scale::Linear) => self.draw(size, x, y),
            (Scale::Linear, Scale::Logarithmic) => self.draw(size, x, y.log_scale()),
            (Scale::Logarithmic, Scale::Linear) => self.draw(size, x.log_scale(), y),
            (Scale::Logarithmic, Scale::Logarithmic) => {
                self.draw(size, x.log_scale(), y.log_scale())
            }
        }
    }

    /// What an axis spans: its points with some room, in the unit that it names [-].
    ///
    /// # Errors
    ///
    /// As for [`Chart::to_svg`].
    pub(crate) fn range(&self, direction: usize) -> Result<Range<f64>, ChartError> {
        let axis = [&self.x, &self.y][direction];
        let mut span = f64::INFINITY..f64::NEG_INFINITY;
        for series in &self.series {
            for (index, point) in series.points.iter().enumerate() {
                let value = point[direction];
                let expected = match axis.scale {
                    Scale::Logarithmic if value <= 0.0 => Some("more than 0 on a logarithmic axis"),
                    _ if !value.is_finite() => Some("a finite number"),
                    _ => None,
                };
                if let Some(expected) = expected {
                    return Err(ChartError::NoPlace {
                        title: self.title.clone(),
                        series: series.label.clone(),
                        index,
                        axis: axis.label.clone(),
                        value,
                        expected,
                    });
                }
                span = span.start.min(value)..span.end.max(value);
            }
        }
        if span.start > span.end {
            return Err(ChartError::Empty {
                title: self.title.clone(),
            });
        }
        Ok(match axis.scale {
            Scale::Linear => widened(span),
            Scale::Logarithmic => {
                let exponents = widened(span.start.log10()..span.end.log10());
                10.0_f64.powf(exponents.start)..10.0_f64.powf(exponents.end)
            }
        })
    }
}

/// A range with room at both ends; one of no length gets some.
fn widened(span: Range<f64>) -> Range<f64> {
    let length = span.end - span.start;
    let room = if length > 0.0 {
        MARGIN * length
    } else {
        0.5 * span.start.abs().max(MARGIN)
    };
    span.start - room..span.end + room
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(x: Axis, y: Axis, points: Vec<[f64; 2]>, style: SeriesStyle) -> Chart {
        Chart {
            title: "Force & time".into(),
            x,
            y,
            series: vec![Series {
                label: "a < b".into(),
                points,
                style,
            }],
        }
    }

    #[test]
    fn every_scale_and_style_makes_an_svg_with_title_labels_and_legend() {
        let axes = [Axis::linear("t [ms]"), Axis::logarithmic("t [ms]")];
        let styles = [
            SeriesStyle::Line,
            SeriesStyle::Dashed,
            SeriesStyle::Markers,
            SeriesStyle::LineWithMarkers,
        ];
        for x in &axes {
            for y in &axes {
                for style in styles {
                    let points = vec![[0.1, 2.0], [1.0, 30.0], [10.0, 4.0]];
                    let svg = chart(x.clone(), y.clone(), points, style)
                        .to_svg()
                        .expect("all points have a place");
                    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
                    for text in ["Force &amp; time", "t [ms]", "a &lt; b"] {
                        assert!(svg.contains(text), "{text} is not in the chart");
                    }
                }
            }
        }
    }

    #[test]
    fn points_without_a_place_are_named_with_series_and_axis() {
        let points = vec![[1.0, 1.0], [2.0, 0.0]];
        let chart = chart(
            Axis::linear("t"),
            Axis::logarithmic("error [-]"),
            points,
            SeriesStyle::Line,
        );
        let message = chart.to_svg().expect_err("log of 0").to_string();
        assert!(message.contains("point 1 of series `a < b`"), "{message}");
        assert!(
            message.contains("more than 0 on a logarithmic axis"),
            "{message}"
        );
    }

    #[test]
    fn a_chart_of_nothing_is_refused_and_one_point_is_drawn() {
        let empty = chart(
            Axis::linear("x"),
            Axis::linear("y"),
            vec![],
            SeriesStyle::Line,
        );
        assert!(matches!(empty.to_svg(), Err(ChartError::Empty { .. })));
        let single = chart(
            Axis::linear("x"),
            Axis::linear("y"),
            vec![[0.0, 5.0]],
            SeriesStyle::Markers,
        );
        assert!(single.to_svg().is_ok());
    }
}
