//! How bodies resist rolling over each other and twisting on each other: one file per law, for both alike.

mod constant_torque;
mod none;
mod spring_dashpot;

pub use constant_torque::ConstantTorque;
pub use none::FreeTurning;
pub use spring_dashpot::SpringDashpot;

use super::Contact;
use super::Sampling;
use super::normal::NormalForce;
use super::spring::SpringForce;
use crate::{MaterialPair, Vec3};
use std::f64::consts::PI;

/// What a law of turning has to work with.
#[derive(Debug, Clone, Copy)]
pub struct Resistance {
    /// Greatest torque [N·m].
    pub most: f64,
    /// Stiffness [N·m].
    pub stiffness: f64,
    /// Damping over critical damping [-].
    pub damping_ratio: f64,
    /// Moment of inertia that the torque acts on [kg·m²].
    pub inertia: f64,
    /// The time step [s].
    pub time_step: f64,
    /// Steps per second [1/s].
    pub rate: f64,
}

/// A law of turning.
pub trait Turning {
    /// Whether it has a spring, which remembers how far it is stretched.
    const HAS_SPRING: bool = false;

    /// Torque against a relative spin [rad/s], and what the spring remembers [√J] one step on.
    fn torque(resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce;
}

/// Share of a solid sphere's `m R²` that is its moment of inertia [-].
const SOLID_SPHERE: f64 = 0.4;

impl Resistance {
    /// Against rolling: at most `μ_r R* F_n`, with the stiffness `2.25 S (μ_r R*)²` (Iwashita & Oda 1998; Ai et al. 2011).
    #[inline(always)]
    pub(super) fn of_rolling(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        sampling: &Sampling,
    ) -> Self {
        let arm = pair.rolling_friction * contact.effective_radius;
        Self {
            most: arm * normal.pressing(),
            stiffness: 2.25 * normal.stiffness * arm * arm,
            ..Self::any(contact, pair, sampling)
        }
    }

    /// Against twisting: at most `3π/16 μ a F_n`, with the stiffness `16/3 G a³`, where G is `1 / (1/G₁ + 1/G₂)`
    /// (Johnson 1985, sections 3.9 and 7.4).
    #[inline(always)]
    pub(super) fn of_twisting(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        sampling: &Sampling,
    ) -> Self {
        let radius = normal.contact_radius;
        Self {
            most: 3.0 * PI / 16.0 * pair.friction * radius * normal.pressing(),
            stiffness: 16.0 / 3.0 * pair.series_shear_modulus * radius * radius * radius,
            ..Self::any(contact, pair, sampling)
        }
    }

    #[inline(always)]
    fn any(contact: &Contact, pair: &MaterialPair, sampling: &Sampling) -> Self {
        let radius = contact.effective_radius;
        Self {
            most: 0.0,
            stiffness: 0.0,
            damping_ratio: pair.rolling_damping,
            inertia: SOLID_SPHERE * contact.effective_mass * radius * radius,
            time_step: sampling.time_step(),
            rate: sampling.rate(),
        }
    }
}
