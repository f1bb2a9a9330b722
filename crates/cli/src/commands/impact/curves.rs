//! The bell curve itself, figure 9 of the paper.

use super::chart::taus;
use crate::table::{self, chosen, number};
use pelletflow_impact::fit::{bell, bell_area};
use pelletflow_log::plot::{Axis, Chart, Series, SeriesStyle};
use serde_json::{Value, json};

/// Shape parameter and asymmetry of the curves.
const CURVES: [[f64; 2]; 3] = [[4.0, 0.5], [4.0, 0.45], [6.0, 0.45]];

pub(super) fn chart() -> Chart {
    Chart {
        title: "The bell curve of the paper's (14), without its factor of force and time".into(),
        x: Axis::linear("time over contact time [-]"),
        y: Axis::linear("force over peak force [-]"),
        series: CURVES
            .iter()
            .map(|&[shape_parameter, asymmetry]| Series {
                label: format!("ε = {shape_parameter}, τ_max = {asymmetry}"),
                points: taus()
                    .map(|tau| [tau, bell(tau, shape_parameter, asymmetry)])
                    .collect(),
                style: SeriesStyle::Line,
            })
            .collect(),
    }
}

pub(super) fn page() -> String {
    let rows = CURVES.iter().map(|&[shape_parameter, asymmetry]| {
        [
            chosen(shape_parameter),
            chosen(asymmetry),
            number(bell_area(shape_parameter, asymmetry)),
        ]
    });
    table::listing(["ε [-]", "τ_max [-]", "k_P [-]"], &[0, 1, 2], rows)
}

pub(super) fn json() -> Value {
    CURVES
        .iter()
        .map(|&[shape_parameter, asymmetry]| {
            json!({
                "shape_parameter": shape_parameter,
                "asymmetry": asymmetry,
                "specific_impulse": bell_area(shape_parameter, asymmetry),
            })
        })
        .collect()
}
