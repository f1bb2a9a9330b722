//! When a wall is there: gates that open and close.

use serde::{Deserialize, Serialize};

/// The moments at which a wall vanishes and comes back.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Schedule {
    changes: Vec<f64>,
    is_absent_at_first: bool,
}

impl Schedule {
    /// Always there.
    pub fn always() -> Self {
        Self::default()
    }

    /// There at first, gone at the first moment, back at the second, and so on; the moments rise [s].
    pub fn opening_at(changes: Vec<f64>) -> Self {
        Self {
            changes,
            is_absent_at_first: false,
        }
    }

    /// Absent at first, there from the first moment, gone at the second, and so on; the moments rise [s].
    pub fn closing_at(changes: Vec<f64>) -> Self {
        Self {
            changes,
            is_absent_at_first: true,
        }
    }

    /// Whether the wall is there at a time [s].
    pub fn is_present(&self, time: f64) -> bool {
        let passed = self
            .changes
            .iter()
            .filter(|&&change| change <= time)
            .count();
        (passed % 2 == 0) != self.is_absent_at_first
    }

    /// The moments of change, rising [s].
    pub fn changes(&self) -> &[f64] {
        &self.changes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_gate_changes_at_each_of_its_moments_and_at_no_other(
            mut moments in prop::collection::vec(0.0..100.0_f64, 0..12),
            time in 0.0..100.0_f64,
        ) {
            moments.sort_by(f64::total_cmp);
            moments.dedup();
            let (opening, closing) = (
                Schedule::opening_at(moments.clone()),
                Schedule::closing_at(moments.clone()),
            );
            prop_assert!(opening.is_present(-1.0) && !closing.is_present(-1.0));
            for &moment in &moments {
                prop_assert_ne!(opening.is_present(moment.next_down()), opening.is_present(moment));
            }
            // Between two moments, and before the first, it is what it was at the last one.
            let last = moments.iter().rfind(|moment| **moment <= time);
            let since = last.is_none_or(|last| opening.is_present(*last));
            prop_assert_eq!(opening.is_present(time), since);
            // One that opens is there exactly when one that closes at the same moments is not.
            prop_assert_ne!(opening.is_present(time), closing.is_present(time));
        }
    }
}
