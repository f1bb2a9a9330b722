//! Quantities outside of scenes, as on a command line: `15mm` to 0.015.

use crate::number::show_with_unit;
use crate::units::{self, Kind, UnitError};

/// A text that is not a quantity of the kind asked for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` {problem}; expected {expected}")]
pub struct MeasureError {
    /// The text.
    text: String,
    /// What is wrong with it.
    problem: String,
    /// What was asked for, with an example.
    expected: String,
}

/// Value in SI units of a number with a unit such as `15 mm`, or of a plain number, which is in SI units already; its
/// unit is that of the kind [its unit].
///
/// ```
/// use pelletflow_scene::{Kind, measure};
///
/// assert_eq!(measure("60MPa", Kind::Pressure)?, 60.0e6);
/// assert_eq!(measure("0.015", Kind::Length)?, 0.015);
/// assert!(measure("15 kg", Kind::Length).is_err());
/// # Ok::<(), pelletflow_scene::MeasureError>(())
/// ```
///
/// # Errors
///
/// When it is not a number, not of this kind, or larger than any plant needs.
pub fn measure(text: &str, kind: Kind) -> Result<f64, MeasureError> {
    let refuse = |problem: String, expected: String| MeasureError {
        text: text.trim().to_owned(),
        problem,
        expected,
    };
    let asked_for = || format!("{}, for example {}", kind.phrase(), kind.example());
    let value = match units::parse(text, &[kind]) {
        Ok((value, _)) => value,
        Err(UnitError::NoUnit) => text
            .trim()
            .parse()
            .map_err(|_| refuse("is not a number".into(), asked_for()))?,
        Err(error) => return Err(refuse(error.to_string(), asked_for())),
    };
    if !value.is_finite() || value.abs() > kind.largest() {
        let largest = show_with_unit(kind.largest(), kind.si());
        return Err(refuse("is too large".into(), format!("at most {largest}")));
    }
    Ok(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantity_of_another_kind_or_of_no_kind_is_refused_with_an_example() {
        for (text, expected) in [
            (
                "15kg",
                "`15kg` is a mass; expected a length, for example 15 mm",
            ),
            (
                "wide",
                "`wide` does not begin with a number; expected a length, for example 15 mm",
            ),
            ("15 mn", "`15 mn` has the unknown unit `mn`"),
            ("1e300", "`1e300` is too large; expected at most 10000 m"),
            ("nan", "`nan` does not begin with a number"),
        ] {
            let message = measure(text, Kind::Length).expect_err(text).to_string();
            assert!(message.starts_with(expected), "{message}");
        }
    }
}
