//! Ways to turn forces into motion.

use pelletflow_core::contact::Sampling;
use serde::{Deserialize, Serialize};

/// How forces become motion; all take one force evaluation per step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Integrator {
    /// Kick, then drift; the contact laws see the velocity half a step late. The scheme of the paper.
    SemiImplicitEuler,
    /// Velocity Verlet in its leapfrog form; the contact laws see positions and velocities of one instant.
    VelocityVerlet,
    /// The same with first touch and release located within the step, and the error in between taken off.
    #[default]
    LocatedVerlet,
}

/// Error of an elastic impact by Verlet times the square of the steps per contact [-]: contact time, the worst of peak
/// force, contact time and rebound, errs by this (`tests/impact.rs` holds it).
const VERLET_ERROR: f64 = 0.57;
/// The same of located Verlet, times the fourth power of the steps per contact [-]; rebound is the worst.
const LOCATED_ERROR: f64 = 23.0;

impl Integrator {
    /// All of them, the simplest first.
    pub const ALL: [Self; 3] = [
        Self::SemiImplicitEuler,
        Self::VelocityVerlet,
        Self::LocatedVerlet,
    ];

    /// Steps per contact that an elastic impact within an error of a share takes [-].
    pub fn steps_per_contact(self, error: f64) -> f64 {
        match self {
            Self::SemiImplicitEuler | Self::VelocityVerlet => (VERLET_ERROR / error).sqrt(),
            Self::LocatedVerlet => (LOCATED_ERROR / error).sqrt().sqrt(),
        }
    }

    /// How samples of a contact force stand for steps of `time_step` [s].
    pub(crate) fn sampling(self, time_step: f64) -> Sampling {
        match self {
            Self::SemiImplicitEuler | Self::VelocityVerlet => Sampling::plain(time_step),
            Self::LocatedVerlet => Sampling::located(time_step),
        }
    }

    /// The part of a step's kick that leads up to the full step [s]: none in the first step, which starts there.
    pub(crate) fn kick_before(self, step: u64, time_step: f64) -> f64 {
        match self {
            Self::VelocityVerlet | Self::LocatedVerlet if step == 0 => 0.0,
            _ => 0.5 * time_step,
        }
    }

    /// How far the velocity that contact laws see is predicted beyond that of the last kick [s].
    pub(crate) fn prediction(self, time_step: f64) -> f64 {
        match self {
            Self::SemiImplicitEuler => 0.0,
            Self::VelocityVerlet | Self::LocatedVerlet => 0.5 * time_step,
        }
    }
}
