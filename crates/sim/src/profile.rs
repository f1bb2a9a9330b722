//! Wall-clock time of each stage of the step.

use std::time::{Duration, Instant};

/// The stages, in the order of the step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    Walls,
    Exchange,
    Search,
    PairContacts,
    WallContacts,
    Motion,
    Meters,
}

/// One step in so many is timed, and stands for the others [-]: reading a clock takes longer than a step of one pellet.
const TIMED_STEPS: u32 = 16;

impl Stage {
    pub(crate) const ALL: [Self; 7] = [
        Self::Walls,
        Self::Exchange,
        Self::Search,
        Self::PairContacts,
        Self::WallContacts,
        Self::Motion,
        Self::Meters,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Walls => "walls",
            Self::Exchange => "exchange",
            Self::Search => "neighbors",
            Self::PairContacts => "pair contacts",
            Self::WallContacts => "wall contacts",
            Self::Motion => "motion",
            Self::Meters => "meters",
        }
    }
}

/// Time spent so far, by stage.
#[derive(Debug, Default)]
pub(crate) struct Profile {
    spent: [Duration; Stage::ALL.len()],
}

/// Time that one chunk spent in a step, by stage; nothing in steps that are not timed.
#[derive(Debug, Clone, Default)]
pub(crate) struct ChunkClock {
    is_running: bool,
    spent: [Duration; Stage::ALL.len()],
}

/// Whether a step is one of those that are timed.
pub(crate) fn is_timed(step: u64) -> bool {
    step.is_multiple_of(u64::from(TIMED_STEPS))
}

impl Profile {
    /// Runs a stage that comes now and then, and enters its time.
    pub(crate) fn time<R>(&mut self, stage: Stage, run: impl FnOnce() -> R) -> R {
        let start = Instant::now();
        let result = run();
        self.spent[stage as usize] += start.elapsed();
        result
    }

    /// Runs a stage of every step, and enters its time for all steps where this one is timed.
    pub(crate) fn sample<R>(&mut self, step: u64, stage: Stage, run: impl FnOnce() -> R) -> R {
        if !is_timed(step) {
            return run();
        }
        let start = Instant::now();
        let result = run();
        self.spent[stage as usize] += TIMED_STEPS * start.elapsed();
        result
    }

    /// Enters the time that the chunks together took, by the shares that their clocks tell.
    pub(crate) fn share_out<'a>(
        &mut self,
        together: Duration,
        clocks: impl Iterator<Item = &'a ChunkClock> + Clone,
    ) {
        let all: f64 = clocks
            .clone()
            .flat_map(|clock| clock.spent)
            .map(|spent| spent.as_secs_f64())
            .sum();
        if all > 0.0 {
            let part = together.as_secs_f64() / all;
            for clock in clocks {
                for (mine, theirs) in self.spent.iter_mut().zip(clock.spent) {
                    *mine += TIMED_STEPS * theirs.mul_f64(part);
                }
            }
        }
    }

    /// Time of a stage so far [s].
    pub(crate) fn seconds(&self, stage: Stage) -> f64 {
        self.spent[stage as usize].as_secs_f64()
    }
}

impl ChunkClock {
    /// Starts a step.
    pub(crate) fn begin(&mut self, step: u64) {
        *self = Self {
            is_running: is_timed(step),
            ..Self::default()
        };
    }

    /// The time now, where the step is timed.
    pub(crate) fn now(&self) -> Option<Instant> {
        self.is_running.then(Instant::now)
    }

    /// Enters the time since `start`.
    pub(crate) fn enter(&mut self, stage: Stage, start: Option<Instant>) {
        if let Some(start) = start {
            self.spent[stage as usize] += start.elapsed();
        }
    }
}
