//! How bodies push apart: one file per law.

mod hertz;
mod jkr;
mod linear;
mod plastic;

pub use hertz::{Hertz, clamped_restitution, damping_ratio_for_clamped_restitution};
pub use jkr::{Jkr, pull_off_gap};
pub use linear::Linear;
pub use plastic::Plastic;

use super::{Contact, ContactHistory};
use crate::MaterialPair;

/// The normal part of a contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalForce {
    /// Force that pushes the bodies apart; less than 0 only where they stick together [N].
    pub force: f64,
    /// Radius of the contact circle [m].
    pub contact_radius: f64,
    /// Depth of the elastic part of the overlap [m].
    pub elastic_overlap: f64,
    /// Damping coefficient of the normal direction [N·s/m].
    pub damping: f64,
    /// Force of the spring alone [N].
    pub elastic: f64,
    /// Stiffness of the spring, `S = dF/dδ` [N/m].
    pub stiffness: f64,
    /// Energy stored in the spring [J].
    pub elastic_energy: f64,
    /// Force below which damping does not bring it [N]: 0, or the pull of the spring.
    pub least: f64,
    /// What presses the surfaces together beyond the force [N]: with it friction is capped.
    pub adhesion: f64,
    /// Rate at which the damping turns motion into heat [W].
    pub dissipation: f64,
    /// Heat that the spring has made since the last sample, by yielding or tearing off [J].
    pub spring_heat: f64,
    /// Whether the bodies hold on to each other, at an overlap however small.
    pub is_touching: bool,
}

/// A normal law.
pub trait Normal {
    /// Power of the overlap in the elastic force at first touch and release [-].
    const ELASTIC_POWER: f64;
    /// Power of the overlap in the damping, there [-].
    const DAMPING_POWER: f64;
    /// Whether the force is gone at release, which can then be located by it.
    const ENDS_AT_ZERO: bool;
    /// Whether it remembers the deepest overlap.
    const REMEMBERS_DEPTH: bool = false;

    /// Force of a contact whose overlap grows at `approach_speed` [m/s].
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        history: &ContactHistory,
        approach_speed: f64,
    ) -> NormalForce;
}

impl NormalForce {
    /// An elastic spring at rest that only pushes, of this contact radius [m], force [N], stiffness [N/m] and energy
    /// [J].
    #[inline(always)]
    pub(super) fn of_spring(
        contact: &Contact,
        contact_radius: f64,
        elastic: f64,
        stiffness: f64,
        elastic_energy: f64,
    ) -> Self {
        Self {
            force: elastic,
            contact_radius,
            elastic_overlap: contact.overlap,
            damping: 0.0,
            elastic,
            stiffness,
            elastic_energy,
            least: 0.0,
            adhesion: 0.0,
            dissipation: 0.0,
            spring_heat: 0.0,
            is_touching: true,
        }
    }

    /// The same overlap, growing at another speed [m/s].
    #[inline(always)]
    #[must_use]
    pub fn at_speed(&self, approach_speed: f64) -> Self {
        let damped = self.elastic + self.damping * approach_speed;
        // Not `f64::max`, whose care for NaN costs two more instructions per contact.
        let force = if damped > self.least {
            damped
        } else {
            self.least
        };
        Self {
            force,
            dissipation: (force - self.elastic) * approach_speed,
            ..*self
        }
    }

    /// Force that presses the surfaces together, 0 or more [N].
    #[inline(always)]
    pub fn pressing(&self) -> f64 {
        self.force + self.adhesion
    }
}
