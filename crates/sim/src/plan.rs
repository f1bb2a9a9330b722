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
    /// Time between recorded meter readings [s].
    pub meter_interval: f64,
    /// Time by the wall clock between checkpoints [s]; infinite where only an interruption writes one.
    pub checkpoint_interval: f64,
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
