//! How long a run goes on and how often it is looked at.

/// The course of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunPlan {
    /// Simulated time at which the run ends at the latest [s].
    pub end_time: f64,
    /// Conditions that end it earlier; any one is enough.
    pub stop: Vec<StopCondition>,
    /// Time between recorded frames [s].
    pub frame_interval: f64,
    /// Which of them are kept once the run is over.
    pub kept_frames: KeptFrames,
    /// Time between recorded meter readings [s].
    pub meter_interval: f64,
    /// Time by the wall clock between checkpoints [s]; infinite where only an interruption writes one.
    pub checkpoint_interval: f64,
}

/// Which frames of a recording are kept; all where nothing is asked for, else each that is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KeptFrames {
    /// Those of the last stretch of the run, of this length [s].
    pub of_last: Option<f64>,
    /// Those that are no farther than this from the moment of one of the hardest hits [s].
    pub around_worst_hits: Option<f64>,
}

impl KeptFrames {
    /// Whether nothing is left out.
    pub fn are_all(&self) -> bool {
        self.of_last.is_none() && self.around_worst_hits.is_none()
    }
}

/// What ends a run before its time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum StopCondition {
    /// No pellet is inside any more, after a moment.
    Empty {
        /// Not before this moment [s].
        after: f64,
    },
    /// The bed has come to rest: kinetic energy per pellet below a bound, after a moment.
    Settled {
        /// Not before this moment [s].
        after: f64,
        /// Mean speed of the pellets below which they count as at rest, root mean square [m/s].
        speed: f64,
    },
}
