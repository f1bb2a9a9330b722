//! Hits: contacts from first touch to release, each with its greatest force, its impulse and its cause.
//!
//! Every contact is followed at every step ([`Trace`]).
//! When it ends it becomes a [`Hit`], which the [`HitLedger`] counts and, where it matters, keeps in full.

mod arrival;
mod ending;
mod ledger;
mod trace;

pub use ledger::{HitClass, HitClassKey, HitLedger, HitRequest};
pub use trace::Trace;

pub(crate) use arrival::Arrivals;
pub(crate) use ending::{Ended, end_leaving, enter, open};
pub(crate) use trace::follow;

use pelletflow_core::Vec3;
use pelletflow_impact::yielding::yielded_force;

/// One contact of a pellet, from first touch to release or to the end of the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Permanent number of the pellet [-].
    pub pellet: u32,
    /// Its diameter [m].
    pub diameter: f64,
    /// Its mass [kg].
    pub mass: f64,
    /// What it met.
    pub partner: HitPartner,
    /// What made the force.
    pub cause: Cause,
    /// Whether the two still touched when this was told.
    pub is_open: bool,
    /// Moment of the first step in which they touched [s].
    pub begin: f64,
    /// How long they touched [s].
    pub duration: f64,
    /// In how many steps [-].
    pub steps: u64,
    /// Moment of the greatest force, to the step [s].
    pub peak_time: f64,
    /// The contact point at that moment, in the world [m].
    pub place: Vec3,
    /// Greatest normal force, between steps too [N].
    pub peak_force: f64,
    /// Greatest normal force of any one step [N].
    pub sampled_force: f64,
    /// Greatest normal force that the arrival of the two bodies alone makes at their true stiffness, damped as their
    /// restitution tells (Hertz; see [`Impact`](pelletflow_impact::Impact)) [N].
    ///
    /// It is the peak force of a hit of two bodies whose stiffness is not softened; the force of a hit that is squeezed
    /// hardly depends on it.
    pub arrival_force: f64,
    /// Greatest pressure under that force, at true stiffness [Pa].
    pub arrival_pressure: f64,
    /// Greatest pressure, in the middle of the contact under the greatest force (Johnson 1985, eq. 4.24) [Pa].
    pub peak_pressure: f64,
    /// Normal force over time [N·s].
    pub normal_impulse: f64,
    /// Size of the tangential force over time [N·s].
    pub tangential_impulse: f64,
    /// Energy that the contact took from motion [J]; of an open one with what springs against sliding still hold.
    pub lost_energy: f64,
    /// Speed along the normal at first touch [m/s].
    pub approach_speed: f64,
    /// Speed of the contact points past each other at first touch [m/s].
    pub sliding_speed: f64,
    /// `R*` of the contact at the greatest force [m].
    pub effective_radius: f64,
}

/// What a pellet met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HitPartner {
    /// Another pellet.
    Pellet {
        /// Permanent number [-].
        id: u32,
        /// Diameter [m].
        diameter: f64,
        /// Mass [kg].
        mass: f64,
    },
    /// A wall, by index in the setup.
    Wall(usize),
}

/// What made the force of a hit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Cause {
    /// The pellet's own arrival at a wall.
    Drop,
    /// The arrival of two pellets at each other.
    Collision,
    /// The rest of the bed: the force is more than the two bodies alone could make by their arrival.
    Squeeze,
}

impl Cause {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Drop, Self::Collision, Self::Squeeze];

    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Drop => "drop",
            Self::Collision => "pellet on pellet",
            Self::Squeeze => "squeezed in the bed",
        }
    }
}

impl Hit {
    /// Speed of the contact points toward and past each other at first touch [m/s].
    pub fn speed(&self) -> f64 {
        self.approach_speed.hypot(self.sliding_speed)
    }

    /// Angle between path and surface at first touch, π/2 head on [rad].
    pub fn angle(&self) -> f64 {
        self.approach_speed.max(0.0).atan2(self.sliding_speed)
    }

    /// Greatest normal force at true stiffness: of an arrival its own, of a squeeze what the bed makes [N].
    pub fn true_force(&self) -> f64 {
        match self.cause {
            Cause::Squeeze => self.peak_force,
            Cause::Drop | Cause::Collision => self.arrival_force,
        }
    }

    /// The same where pellets yield under a pressure [Pa] before they break (Thornton 1997) [N].
    ///
    /// An arrival brings an energy, which makes less force where the contact yields; a squeeze brings the force itself.
    pub fn yielded_force(&self, yield_pressure: f64) -> f64 {
        match self.cause {
            Cause::Squeeze => self.peak_force,
            Cause::Drop | Cause::Collision => {
                yielded_force(self.arrival_force, self.arrival_pressure, yield_pressure)
            }
        }
    }

    /// Energy of the approach along the normal, `m* v² / 2` [J].
    pub fn approach_energy(&self) -> f64 {
        0.5 * self.effective_mass() * self.approach_speed.powi(2)
    }

    /// `m*` of the two bodies [kg].
    pub fn effective_mass(&self) -> f64 {
        match self.partner {
            HitPartner::Pellet { mass, .. } => self.mass * mass / (self.mass + mass),
            HitPartner::Wall(_) => self.mass,
        }
    }
}
