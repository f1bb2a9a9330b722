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
