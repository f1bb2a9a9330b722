//! The time step: from the force error asked for and the fastest hit expected.

/// How the step is to be chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepRequest {
    /// From the error of the peak force of the fastest hit expected, as a share [-].
    PeakForceError(f64),
    /// A fixed step [s].
    Fixed(f64),
}

/// The step and why.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeStep {
    /// The step [s].
    pub seconds: f64,
    /// Why it is what it is, in one sentence to print.
    pub reason: String,
    /// Speed of the fastest hit expected [m/s].
    pub expected_speed: f64,
    /// Shortest contact at that speed [s].
    pub shortest_contact: f64,
}
