//! Plots of a report: what meters read, and the ledgers.

use super::curve::Curve;
use super::html::put;
use crate::markup::escaped;
use crate::plot::{Axis, Chart, Series, SeriesStyle, color_of};
use crate::tables::{unit_of, words_of};
use std::ops::Range;

/// Width and height of a chart on the page [px].
const SIZE: [u32; 2] = [560, 320];

/// What a file of its own says, and a part of a page need not.
const NAMESPACE: &str = " xmlns=\"http://www.w3.org/2000/svg\"";

/// What is drawn of the ledgers: topic, caption, and quantities.
const LEDGERS: [(&str, &str, &[&str]); 3] = [
    (
        "/ledger/mass",
        "Mass ledger",
        &["inserted_kg", "inside_kg", "discharged_kg", "lost_kg"],
    ),
    (
        "/ledger/energy",
        "Energy in motion",
        &["kinetic_j", "elastic_j", "residual_j"],
    ),
    (
        "/ledger/energy",
        "Energy ledger",
        &["potential_j", "dissipated_j", "carried_in_j", "wall_work_j"],
    ),
];

type Curves = [(String, Curve)];

/// Plots of the quantities of a meter that share the unit of its first; nothing where it read nothing.
pub(super) fn of_meter(name: &str, curves: &Curves) -> String {
    let unit = curves.first().map(|(name, _)| unit_of(name));
    let shown = curves
        .iter()
        .filter(|(name, _)| Some(unit_of(name)) == unit);
    over_time(name, shown)
}

/// Plots of the ledgers.
pub(super) fn of_ledgers<'a>(curves_of: impl Fn(&str) -> Option<&'a Curves>) -> String {
    let mut html = String::new();
    for (topic, caption, quantities) in LEDGERS {
        let curves = curves_of(topic).unwrap_or_default();
        let shown = curves
            .iter()
            .filter(|(name, _)| quantities.contains(&name.as_str()));
        html.push_str(&over_time(caption, shown));
    }
    html
}

/// Curves over time on one chart, which follows the replay.
fn over_time<'a>(caption: &str, curves: impl Iterator<Item = &'a (String, Curve)>) -> String {
    let mut unit = "-";
    let series: Vec<Series> = curves
        .map(|(name, curve)| {
            unit = unit_of(name);
            Series {
                label: words_of(name),
                points: curve.points(),
                style: SeriesStyle::Line,
            }
        })
        .filter(|series| !series.points.is_empty())
        .collect();
    if series.is_empty() {
        return String::new();
    }
    let y = match series.as_slice() {
        [only] => format!("{} [{unit}]", only.label),
        _ => format!("[{unit}]"),
    };
    let chart = Chart {
        title: String::new(),
        x: Axis::linear("time [s]"),
        y: Axis::linear(y),
        series,
    };
    let span = chart.range(0).expect("curves hold finite numbers only");
    figure(caption, chart, Some(span))
}

/// A chart with its legend beside it; one over a span of time follows the replay.
pub(super) fn figure(caption: &str, mut chart: Chart, span: Option<Range<f64>>) -> String {
    let mut legend = String::new();
    // One line alone is named by the axis.
    if chart.series.len() > 1 {
        for (index, series) in chart.series.iter().enumerate() {
            let class = match series.style {
                SeriesStyle::Dashed => " class=\"dashed\"",
                _ => "",
            };
            let (color, label) = (color_of(index), escaped(&series.label));
            let style = format_args!("style=\"--line: {color}\"");
            put(&mut legend, format_args!("<li{class} {style}>{label}</li>"));
        }
    }
    for series in &mut chart.series {
        series.label.clear();
    }
    let drawing = chart
        .drawing(SIZE)
        .expect("its points are finite, and positive along a logarithm");
    let [left, right, top, bottom] = drawing.frame;
    let follows = span.map_or_else(String::new, |span| {
        format!(
            " data-span=\"{} {}\" data-frame=\"{left} {right} {top} {bottom}\"",
            span.start, span.end
        )
    });
    format!(
        "<figure class=\"chart\"{follows}><figcaption>{}</figcaption><ul class=\"legend\">{legend}</ul><div class=\"drawing\">{}</div></figure>",
        escaped(caption),
        inline(&drawing.svg, caption)
    )
}

/// An SVG as part of a page: it takes the width that it is given, and has a name for those who cannot see it.
fn inline(svg: &str, name: &str) -> String {
    let [width, height] = SIZE;
    svg.replacen(
        &format!("<svg width=\"{width}\" height=\"{height}\""),
        &format!("<svg role=\"img\" aria-label=\"{}\"", escaped(name)),
        1,
    )
    .replacen(NAMESPACE, "", 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(values: &[f64]) -> Curve {
        let mut curve = Curve::default();
        for (index, &value) in values.iter().enumerate() {
            curve.push(index as f64, value);
        }
        curve
    }

    #[test]
    fn a_meter_shows_what_shares_the_unit_of_its_first_quantity() {
        let curves = [
            ("force_x_n".to_owned(), curve(&[0.0, 1.0])),
            ("force_z_n".to_owned(), curve(&[0.0, 5.0])),
            ("torque_x_nm".to_owned(), curve(&[0.0, 9.0])),
        ];
        let html = of_meter("load <1>", &curves);
        for text in [
            "load &lt;1&gt;",
            "force x",
            "force z",
            "[N]",
            "data-span",
            "aria-label",
        ] {
            assert!(html.contains(text), "{text}");
        }
        assert!(!html.contains("torque"));
    }

    #[test]
    fn a_meter_that_read_nothing_has_no_plot() {
        assert_eq!(
            of_meter("load", &[("force_x_n".to_owned(), Curve::default())]),
            ""
        );
        assert_eq!(of_meter("load", &[]), "");
    }
}
