//! Contact laws: a touch in, a force out.
//!
//! A law is composed of four parts: normal, tangential, rolling and twisting. Each choice is one file.
//! To add one: write its file in the folder of its part, then add its variant and its arm in `laws.rs`.
#![expect(
    clippy::inline_always,
    reason = "a call in the loop of a batch would keep it from using vector instructions"
)]

pub mod batch;
mod beginning;
mod compose;
pub mod curvature;
mod laws;
mod memory;
mod motion;
pub mod normal;
pub mod peak;
pub mod release;
mod sampling;
mod spring;
pub mod tangential;
pub mod turning;

pub use batch::Batch;
pub use laws::{ContactLaws, NormalLaw, TangentialLaw, TurningLaw};
pub use sampling::Sampling;
pub use spring::SpringForce;

use crate::Vec3;
use serde::{Deserialize, Serialize};
use tangential::Sliders;

/// One touch, seen from body A; body B is a pellet or a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Unit vector from B into A [-].
    pub normal: Vec3,
    /// Depth of the overlap along the normal, more than 0 [m].
    pub overlap: f64,
    /// Velocity of A's surface relative to B's at the contact point [m/s].
    pub relative_velocity: Vec3,
    /// Spin of A relative to B [rad/s].
    pub relative_spin: Vec3,
    /// `R* = 1 / (K_A + K_B)`, where a hollow wall's curvature K is negative; by [`curvature::effective_radius`] where the
    /// bodies bend more one way than across it [m].
    pub effective_radius: f64,
    /// `m* = 1 / (1/m_A + 1/m_B)`; a wall has no inverse mass [kg].
    pub effective_mass: f64,
    /// `1 / m*`, so that nobody divides by it [1/kg].
    pub inverse_mass: f64,
}

/// What a contact remembers from first touch to release.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactHistory {
    /// Elastic tangential displacement of A's surface relative to B's, times the root of its stiffness [√J].
    pub tangential_stretch: Vec3,
    /// Normal force that the last step was given [N]: 0 before first touch and after release, never in between.
    pub normal_force: f64,
    /// Samples since first touch [-].
    pub samples: f64,
    /// Deepest overlap so far [m].
    pub deepest_overlap: f64,
    /// Elastic rolling of A over B, times the root of its stiffness [√J].
    pub rolling_stretch: Vec3,
    /// Elastic twist of A on B about the normal, times the root of its stiffness [√J].
    pub twisting_stretch: f64,
    /// What a contact in partial slip remembers.
    pub sliders: Sliders,
}

/// What a contact does to body A; body B receives the negative force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce {
    /// Normal force; less than 0 only where the bodies stick together [N].
    pub normal: f64,
    /// Force on A, normal and tangential together [N].
    pub force: Vec3,
    /// Size of its tangential part [N].
    pub tangential: f64,
    /// Torque on A against rolling and twisting, beside the moment of the force; B receives the negative [N·m].
    pub turning_torque: Vec3,
    /// Energy stored in the normal spring [J].
    pub elastic_energy: f64,
    /// Rate at which the normal direction turns motion into heat [W].
    pub dissipation: f64,
    /// Energy stored in the springs against sliding, rolling and twisting [J].
    pub shear_energy: f64,
    /// Rate at which sliding, rolling and twisting work on springs, dampers and sliders together [W].
    ///
    /// What becomes heat is known over time only: this work less the energy stored.
    pub shear_power: f64,
}

#[cfg(test)]
mod contract;
