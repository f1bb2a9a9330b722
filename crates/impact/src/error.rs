//! What can be wrong with a hit.

/// A hit that cannot be worked out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ImpactError {
    /// A quantity is outside its bounds.
    #[error("{quantity} is {}; expected {expected}", with_unit(*value, unit))]
    OutOfBounds {
        /// What it is.
        quantity: &'static str,
        /// Its value, in the unit beside it [unit].
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// The bound.
        expected: &'static str,
    },
    /// A blow among many is not one.
    #[error("blow {index}: {fault}")]
    Blow {
        /// Its place in the list, counted from 0 [-].
        index: usize,
        /// What is wrong with it.
        fault: Box<ImpactError>,
    },
    /// The solver did not reach the release.
    #[error("the hit has no end that the solver reaches: {reason}; lower the damping")]
    NoRelease {
        /// What the solver says.
        reason: String,
    },
    /// The fit of a curve did not come to an end.
    #[error("the {curve} could not be fitted: {reason}")]
    NoFit {
        /// Which curve.
        curve: &'static str,
        /// Why not.
        reason: &'static str,
    },
}

/// A value and its unit; the space goes where there is no unit.
fn with_unit(value: f64, unit: &str) -> String {
    format!("{value} {unit}").trim_end().to_owned()
}

/// Refuses a quantity that is not finite and positive.
pub(crate) fn positive(
    quantity: &'static str,
    unit: &'static str,
    value: f64,
) -> Result<(), ImpactError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(ImpactError::OutOfBounds {
        quantity,
        value,
        unit,
        expected: "more than 0",
    })
}

/// Refuses a quantity that is not finite, or less than nothing.
pub(crate) fn not_negative(
    quantity: &'static str,
    unit: &'static str,
    value: f64,
) -> Result<(), ImpactError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(ImpactError::OutOfBounds {
        quantity,
        value,
        unit,
        expected: "0 or more",
    })
}

/// Refuses a sample that leaves no scatter to see; none counts as exact.
pub(crate) fn sample(size: Option<u32>) -> Result<(), ImpactError> {
    match size {
        Some(size) if size < 2 => Err(ImpactError::OutOfBounds {
            quantity: "sample size of the test",
            value: f64::from(size),
            unit: "",
            expected: "at least 2, or none where the numbers count as exact",
        }),
        _ => Ok(()),
    }
}
