//! Numbers as they stand in tables.

/// A count with its thousands apart: `5,000` [-].
pub fn count(count: u64) -> String {
    let digits = count.to_string();
    let mut grouped = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped
}

/// A number with four significant digits, in its own unit [-].
pub fn number(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude != 0.0 && !(1.0e-3..1.0e6).contains(&magnitude) {
        return format!("{value:.3e}");
    }
    if magnitude == 0.0 {
        return "0".into();
    }
    let decimals = 3 - magnitude.log10().floor() as i32;
    format!("{value:.*}", usize::try_from(decimals).unwrap_or(0))
}

/// A number that somebody chose, as it was written: four significant digits at most.
pub fn chosen(value: f64) -> String {
    let text = number(value);
    if text.contains('e') || !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Share below which no distribution can be believed [-].
pub const LEAST_SHARE: f64 = 1.0e-6;

/// A share in percent: what is next to nothing is no number [-].
pub fn percent(share: f64) -> String {
    if share > 0.0 && share < LEAST_SHARE {
        format!("< {} %", chosen(100.0 * LEAST_SHARE))
    } else {
        format!("{} %", number(100.0 * share))
    }
}
