//! What can go wrong, before a run and in it.

use pelletflow_core::Vec3;

/// A mistake in a setup.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{key}: {message}")]
pub struct SetupError {
    /// Dotted key of the scene table it belongs to, such as `walls.cone` or `inlets.feed.rate`.
    pub key: String,
    /// What is wrong, its value, the bound and the cure, in one sentence or two.
    pub message: String,
}

impl SetupError {
    pub(crate) fn new(key: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            key: key.into(),
            message: message.into(),
        }
    }
}

/// A run that went wrong; the state is that before the failed step.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StepError {
    /// A position or velocity is not a number.
    #[error(
        "pellet {pellet} has a position or velocity that is not finite at step {step}, t = {time:.6} s, after ({:.4}, {:.4}, {:.4}) m \
         with {speed:.2} m/s: a force on it has passed every number; lower `time.peak_force_error`, so that the step shrinks, \
         and look for a material, a size or a speed that is off by powers of ten",
        position.x, position.y, position.z
    )]
    NotFinite {
        /// Permanent number of the pellet [-].
        pellet: u32,
        /// Where it was before the step [m].
        position: Vec3,
        /// How fast it was [m/s].
        speed: f64,
        /// Step [-].
        step: u64,
        /// Simulated time [s].
        time: f64,
    },
    /// A pellet too fast for the step.
    #[error(
        "pellet {pellet} moves at {speed:.2} m/s at step {step}, t = {time:.6} s, near ({:.4}, {:.4}, {:.4}) m; the step of {seconds:.3e} s \
         was chosen for {expected:.2} m/s and is too large beyond {limit:.2} m/s, where hits have too few steps or pellets pass thin \
         walls; look for what throws the pellet, such as one that begins inside another body; if it is meant to be that fast, lower \
         `time.peak_force_error` or `time.step`",
        position.x, position.y, position.z
    )]
    StepTooLarge {
        /// Permanent number of the pellet [-].
        pellet: u32,
        /// Where it is [m].
        position: Vec3,
        /// How fast [m/s].
        speed: f64,
        /// The limit [m/s].
        limit: f64,
        /// Speed of the fastest hit expected [m/s].
        expected: f64,
        /// The time step [s].
        seconds: f64,
        /// Step [-].
        step: u64,
        /// Simulated time [s].
        time: f64,
    },
    /// An overlap past its limit.
    #[error(
        "pellet {pellet} overlaps {partner} by {ratio:.3} of its radius at step {step}, t = {time:.6} s; \
         the limit is {limit} (`limits.overlap_ratio`): stiffen the material, slow the impact or lower \
         `time.peak_force_error`"
    )]
    Overlap {
        /// Permanent number of the pellet [-].
        pellet: u32,
        /// The other body, as `pellet 7` or ``wall `cone` ``.
        partner: String,
        /// Overlap over the smaller radius [-].
        ratio: f64,
        /// The limit [-].
        limit: f64,
        /// Step [-].
        step: u64,
        /// Simulated time [s].
        time: f64,
    },
    /// A pellet that left the domain without an outlet.
    #[error(
        "pellet {pellet} left the domain at ({:.4}, {:.4}, {:.4}) m with {speed:.2} m/s at step {step}, t = {time:.6} s, nearest wall \
         {nearest_wall}; close the gap, widen `domain` or put an outlet there",
        position.x, position.y, position.z
    )]
    Lost {
        /// Permanent number of the pellet [-].
        pellet: u32,
        /// Where [m].
        position: Vec3,
        /// How fast [m/s].
        speed: f64,
        /// The nearest wall and its distance, ready to print.
        nearest_wall: String,
        /// Step [-].
        step: u64,
        /// Simulated time [s].
        time: f64,
    },
    /// An energy ledger that does not close.
    #[error(
        "{} {:.3e} J of the {throughput:.3e} J that went through the energy ledger at step {step}, t = {time:.6} s, more than \
         {limit} of it (`limits.energy_residual`); {fastest}; the step is too large for what happens: lower `time.peak_force_error`, so that it shrinks",
        if *residual > 0.0 { "contacts have made" } else { "contacts have lost" }, residual.abs()
    )]
    Energy {
        /// The fastest pellet, ready to print.
        fastest: String,
        /// What is missing or too much [J].
        residual: f64,
        /// Energy that went through the ledger [J].
        throughput: f64,
        /// The limit, as a share [-].
        limit: f64,
        /// Step [-].
        step: u64,
        /// Simulated time [s].
        time: f64,
    },
    /// A wall that appeared where pellets were.
    #[error(
        "wall `{wall}` closed onto pellets at t = {time:.6} s: {pellets} of them stood in its way, pellet {deepest} by {ratio:.3} \
         of its radius; let it close when they have passed, earlier or later, or make it a wall with a `translating` or \
         `rotating` motion, which pushes them aside"
    )]
    GateClosed {
        /// Name of the wall.
        wall: String,
        /// How many pellets it cut into too deep [-].
        pellets: usize,
        /// Permanent number of the one that it cut into deepest [-].
        deepest: u32,
        /// Overlap of that one over its radius [-].
        ratio: f64,
        /// Simulated time [s].
        time: f64,
    },
    /// A feeder that cannot hold its rate.
    #[error(
        "inlet `{inlet}` has fed {fed:.4} {unit} of the {due:.4} {unit} due at t = {time:.6} s, {:.4} {unit}/s in place of {:.4} \
         {unit}/s: its region is too small for the rate, or pellets do not leave it fast enough; widen the region, raise \
         the velocity, clear what dams it up or lower the rate",
        fed / feeding_time, due / feeding_time
    )]
    InletBlocked {
        /// Name of the inlet.
        inlet: String,
        /// What it has fed [the unit below].
        fed: f64,
        /// What it should have fed [the unit below].
        due: f64,
        /// `kg` or `pellets`.
        unit: &'static str,
        /// Time that it has fed for [s].
        feeding_time: f64,
        /// Simulated time [s].
        time: f64,
    },
}
