//! `[time]`, `[stop]`, `[output]`, `[limits]` and `[skip]`.

use crate::quantity::{Duration, Force, Moment, Pause, Share, Speed};
use schemars::JsonSchema;
use serde::Deserialize;

/// How long and in what steps; give at most one of `step` and `peak_force_error`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TimeSpec {
    /// Simulated time at which the run ends at the latest [s].
    pub(crate) end: Duration,
    /// A fixed time step [s].
    pub(crate) step: Option<Duration>,
    /// How forces become motion; `located-verlet` where none is given.
    pub(crate) integrator: Option<IntegratorSpec>,
    /// Error of the peak force of the fastest hit, from which the step is chosen [-]; 0.001 where none is given.
    #[schemars(extend("maximum" = 0.2))]
    pub(crate) peak_force_error: Option<Share>,
}

/// How forces become motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum IntegratorSpec {
    /// Kick, then drift; contact laws see the velocity half a step late.
    SemiImplicitEuler,
    /// Velocity Verlet.
    VelocityVerlet,
    /// Velocity Verlet with first touch and release located within the step.
    LocatedVerlet,
}

/// What ends the run before its time; any one is enough.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct StopSpec {
    /// No pellet is inside any more, after this moment [s].
    pub(crate) empty_after: Option<Moment>,
    /// The bed has come to rest, after this moment [s].
    pub(crate) settled_after: Option<Moment>,
    /// Root mean square speed below which the bed counts as at rest [m/s]; 5 mm/s where none is given.
    pub(crate) settled_speed: Option<Speed>,
}

/// What is recorded and how often.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct OutputSpec {
    /// Time between recorded frames [s]; chosen from the length of the run where none is given.
    pub(crate) frame_interval: Option<Duration>,
    /// Once the run is over, only frames of its last stretch are kept, of this length, beside the first and the last [s];
    /// all where nothing is said.
    pub(crate) frames_of_last: Option<Duration>,
    /// Once the run is over, only frames are kept that are no farther than this from one of its 20 hardest hits, beside the
    /// first and the last [s]; all where nothing is said. With `frames_of_last`, the frames of both are kept.
    pub(crate) frames_around_worst_hits: Option<Duration>,
    /// Time between recorded meter readings [s]; chosen from the length of the run where none is given.
    pub(crate) meter_interval: Option<Duration>,
    /// Number of pellets up to which they are recorded as spheres of true size [-]; 2000 where none is given.
    pub(crate) spheres_up_to: Option<usize>,
    /// Whether every contact is recorded in every frame; false where nothing is said.
    pub(crate) contacts: Option<bool>,
    /// Whether every contact is followed from first touch to release and recorded; true where nothing is said.
    pub(crate) hits: Option<bool>,
    /// Greatest normal force from which on every hit is recorded in full [N]; a tenth of the strength's load where none
    /// is given. Hits harder than all before them of a pellet are recorded in any case.
    pub(crate) hits_above: Option<Force>,
    /// Time by the wall clock between checkpoints, from which a run that was killed can be resumed [s]; 10 min where none is
    /// given, and 0 where only an interruption is to write one.
    pub(crate) checkpoint_interval: Option<Pause>,
}

/// When the run counts as failed.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct LimitsSpec {
    /// Largest overlap over the smaller radius of a contact [-].
    #[schemars(extend("exclusiveMaximum" = 1.0))]
    pub(crate) overlap_ratio: Option<Share>,
    /// Largest residual of the energy ledger over the energy that went through it [-].
    pub(crate) energy_residual: Option<Share>,
}

/// Work that may be left out because it changes nothing; false forces it back in.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct SkipSpec {
    /// No spin where no law acts on it; true where nothing is said.
    pub(crate) rotation: Option<bool>,
    /// No wall evaluated for a pellet that cannot reach it; true where nothing is said.
    pub(crate) distant_walls: Option<bool>,
    /// Many steps at once while no pellet is near anything; true where nothing is said.
    pub(crate) free_flight: Option<bool>,
}
