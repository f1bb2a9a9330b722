//! Numbers as people write them.

/// A number for a message: plain where it is short, with an exponent where it is not.
pub(crate) fn show(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude != 0.0 && !(1.0e-4..1.0e6).contains(&magnitude) {
        format!("{value:e}")
    } else {
        format!("{value}")
    }
}

/// A number with its unit; the space goes where there is no unit.
pub(crate) fn show_with_unit(value: f64, unit: &str) -> String {
    format!("{} {unit}", show(value)).trim_end().to_owned()
}
