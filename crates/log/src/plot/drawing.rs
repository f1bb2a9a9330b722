//! Charts drawn by plotters.

use super::{Axis, Chart, ChartError, Drawing, Scale, SeriesStyle};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::prelude::*;

/// Colors that also color-blind readers tell apart (Okabe & Ito 2008).
const COLORS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(140, 110, 60),
];

/// Color of the series with a place in the order of a chart, as a page writes it.
pub(crate) fn color_of(series: usize) -> String {
    let RGBColor(red, green, blue) = COLORS[series % COLORS.len()];
    format!("#{red:02X}{green:02X}{blue:02X}")
}

impl Chart {
    /// Draws over coordinates made for the two scales.
    pub(super) fn draw<X, Y>(
        &self,
        [width, height]: [u32; 2],
        x: X,
        y: Y,
    ) -> Result<Drawing, ChartError>
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let mut svg = String::new();
        let area = SVGBackend::with_string(&mut svg, (width, height)).into_drawing_area();
        let frame = self
            .draw_on(&area, x, y)
            .map_err(|error| ChartError::Refused {
                title: self.title.clone(),
                reason: error.to_string(),
            })?;
        drop(area);
        Ok(Drawing { svg, frame })
    }

    /// Draws on an area; the left, right, upper and lower end of what the axes enclose [px].
    fn draw_on<'s, X, Y>(
        &self,
        area: &DrawingArea<SVGBackend<'s>, Shift>,
        x: X,
        y: Y,
    ) -> Result<[i32; 4], DrawingAreaErrorKind<<SVGBackend<'s> as DrawingBackend>::ErrorType>>
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        area.fill(&WHITE)?;
        let mut builder = ChartBuilder::on(area);
        if !self.title.is_empty() {
            builder.caption(&self.title, ("sans-serif", 17));
        }
        let mut chart = builder
            .margin(14)
            .x_label_area_size(46)
            .y_label_area_size(70)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .x_label_formatter(&|value| tick(*value))
            .y_label_formatter(&|value| tick(*value))
            .axis_desc_style(("sans-serif", 14))
            .label_style(("sans-serif", 12))
            .bold_line_style(BLACK.mix(0.12))
            .light_line_style(TRANSPARENT)
            .draw()?;
        for (series, color) in self.series.iter().zip(COLORS.iter().cycle()) {
            let points = || series.points.iter().map(|&[x, y]| (x, y));
            let style = color.stroke_width(2);
            // The legend hangs on one element; the others of a series are drawn beside it.
            let first = if series.style == SeriesStyle::Dashed {
                chart.draw_series(DashedLineSeries::new(points(), 6, 4, style))?
            } else if series.style.has_line() {
                chart.draw_series(LineSeries::new(points(), style))?
            } else {
                chart.draw_series(points().map(|at| Circle::new(at, 3, color.filled())))?
            };
            if !series.label.is_empty() {
                let (color, kind) = (*color, series.style);
                first
                    .label(&series.label)
                    .legend(move |(x, y)| legend_sign(x, y, color, kind));
            }
            if series.style == SeriesStyle::LineWithMarkers {
                chart.draw_series(points().map(|at| Circle::new(at, 3, color.filled())))?;
            }
        }
        if self.series.iter().any(|series| !series.label.is_empty()) {
            chart
                .configure_series_labels()
                .position(self.emptiest_corner())
                .label_font(("sans-serif", 12))
                .background_style(WHITE.mix(0.85))
                .border_style(BLACK.mix(0.2))
                .draw()?;
        }
        let (across, down) = chart.plotting_area().get_pixel_range();
        area.present()?;
        Ok([across.start, across.end, down.start, down.end])
    }

    /// The corner with the fewest points, for the legend.
    fn emptiest_corner(&self) -> SeriesLabelPosition {
        let placed = |axis: &Axis, value: f64| match axis.scale {
            Scale::Linear => value,
            Scale::Logarithmic => value.log10(),
        };
        let places: Vec<[f64; 2]> = self
            .series
            .iter()
            .flat_map(|series| &series.points)
            .map(|&[x, y]| [placed(&self.x, x), placed(&self.y, y)])
            .collect();
        let share = |direction: usize| {
            let values = places.iter().map(|place| place[direction]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            move |value: f64| (value - low) / (high - low)
        };
        let (across, up) = (share(0), share(1));
        let count = |is_right: bool, is_upper: bool| {
            places
                .iter()
                .filter(|[x, y]| {
                    let in_x = if is_right {
                        across(*x) > 0.7
                    } else {
                        across(*x) < 0.3
                    };
                    in_x && if is_upper {
                        up(*y) > 0.55
                    } else {
                        up(*y) < 0.45
                    }
                })
                .count()
        };
        // Ties go to the first: readers look there.
        let corners = [
            (SeriesLabelPosition::UpperRight, count(true, true)),
            (SeriesLabelPosition::UpperLeft, count(false, true)),
            (SeriesLabelPosition::LowerRight, count(true, false)),
            (SeriesLabelPosition::LowerLeft, count(false, false)),
        ];
        corners
            .into_iter()
            .min_by_key(|(_, points)| *points)
            .map_or(SeriesLabelPosition::UpperRight, |(corner, _)| corner)
    }
}

/// The sign of a series in the legend.
fn legend_sign<'s>(
    x: i32,
    y: i32,
    color: RGBColor,
    kind: SeriesStyle,
) -> DynElement<'static, SVGBackend<'s>, (i32, i32)> {
    let style = color.stroke_width(2);
    if kind.has_markers() {
        Circle::new((x + 9, y), 3, color.filled()).into_dyn()
    } else if kind == SeriesStyle::Dashed {
        PathElement::new([(x, y), (x + 7, y)], style).into_dyn()
    } else {
        PathElement::new([(x, y), (x + 18, y)], style).into_dyn()
    }
}

/// A value at a tick, without the digits that binary fractions add.
fn tick(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude < 1.0e-12 {
        return "0".into();
    }
    if !(1.0e-3..1.0e5).contains(&magnitude) {
        let text = format!("{value:.3e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let digits = digits.trim_end_matches('0').trim_end_matches('.');
        return format!("{digits}e{exponent}");
    }
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_short() {
        assert_eq!(tick(0.300_000_000_000_000_04), "0.3");
        assert_eq!(tick(1.0e-6), "1e-6");
        assert_eq!(tick(2.5e6), "2.5e6");
        assert_eq!(tick(-40.0), "-40");
    }
}
