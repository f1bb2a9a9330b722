//! Bounds of a number, as the schema states them.

use crate::number::show_with_unit;
use serde_json::Value as Schema;

/// What was expected of a number outside its bounds; nothing where it is inside.
pub(super) fn broken(schema: &Schema, value: f64, unit: &str) -> Option<String> {
    if let Some(only) = schema["const"].as_f64() {
        return (value != only).then(|| show_with_unit(only, unit));
    }
    let bound = |key: &str| schema[key].as_f64();
    let show = |value: f64| show_with_unit(value, unit);
    let (above, least) = (bound("exclusiveMinimum"), bound("minimum"));
    let (below, most) = (bound("exclusiveMaximum"), bound("maximum"));
    let is_inside = above.is_none_or(|above| value > above)
        && least.is_none_or(|least| value >= least)
        && below.is_none_or(|below| value < below)
        && most.is_none_or(|most| value <= most);
    if is_inside {
        return None;
    }
    let lower = above
        .map(|above| format!("more than {}", show(above)))
        .or_else(|| least.map(|least| format!("at least {}", show(least))));
    let upper = below
        .map(|below| format!("less than {}", show(below)))
        .or_else(|| most.map(|most| format!("at most {}", show(most))));
    let both: Vec<String> = lower.into_iter().chain(upper).collect();
    Some(both.join(" and "))
}
