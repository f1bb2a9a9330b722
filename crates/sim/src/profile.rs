//! Wall-clock time of each stage of the step.

use std::time::{Duration, Instant};

/// The stages, in the order of the step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    Walls,
    Search,
    Forces,
    Motion,
    Exchange,
    Meters,
}

impl Stage {
    pub(crate) const ALL: [Self; 6] = [
        Self::Walls,
        Self::Search,
        Self::Forces,
        Self::Motion,
        Self::Exchange,
        Self::Meters,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Walls => "walls",
            Self::Search => "neighbors",
            Self::Forces => "forces",
            Self::Motion => "motion",
            Self::Exchange => "exchange",
            Self::Meters => "meters",
        }
    }
}

/// Time spent so far, by stage.
#[derive(Debug, Default)]
pub(crate) struct Profile {
    spent: [Duration; Stage::ALL.len()],
}

impl Profile {
    /// Runs a stage and enters its time.
    pub(crate) fn time<R>(&mut self, stage: Stage, run: impl FnOnce() -> R) -> R {
        let start = Instant::now();
        let result = run();
        self.spent[stage as usize] += start.elapsed();
        result
    }

    /// Time of a stage so far [s].
    pub(crate) fn seconds(&self, stage: Stage) -> f64 {
        self.spent[stage as usize].as_secs_f64()
    }
}
