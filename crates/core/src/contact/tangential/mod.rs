//! How bodies resist sliding: one file per law.

mod coulomb;
mod mindlin;
mod none;
mod partial_slip;

pub use coulomb::Coulomb;
pub use mindlin::Mindlin;
pub use none::NoFriction;
pub use partial_slip::{PartialSlip, SLIDERS, Sliders};

use super::normal::NormalForce;
use super::spring::SpringForce;
use super::{Contact, ContactHistory};
use crate::{MaterialPair, Vec3};

/// How surfaces slide at a sample.
#[derive(Debug, Clone, Copy)]
pub struct Slide {
    /// Velocity of A's surface along B's [m/s].
    pub velocity: Vec3,
    /// The time step [s].
    pub time_step: f64,
    /// Steps per second [1/s].
    pub rate: f64,
    /// Time since the last sample, or since first touch [s].
    pub elapsed: f64,
    /// Time before the sample for which the velocity stands where a spring stiffens with the contact [s].
    pub behind: f64,
}

/// A tangential law.
pub trait Tangential {
    /// Whether it remembers a row of sliders.
    const HAS_SLIDERS: bool = false;

    /// Force of a contact whose surfaces slide, and its memory one step on.
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        slide: &Slide,
        history: &mut ContactHistory,
    ) -> SpringForce;
}

/// Share of the sliding that a force against it may stop in one step [-].
///
/// Such a force answers to a predicted velocity, which is stable while all contacts of a pellet together stop less than
/// the whole of its motion in a step. A dozen contacts do within this bound; strong damping alone would break it.
const STOPPED_PER_STEP: f64 = 0.3;
/// Mass that resists sliding at the surface of solid spheres, over the effective mass: `1 / (1 + R² m / I)` [-].
const SLIDING_MASS: f64 = 2.0 / 7.0;

/// Greatest force against sliding, over the speed, that keeps a step stable [N·s/m].
#[inline(always)]
fn steadiest_damping(contact: &Contact, slide: &Slide) -> f64 {
    STOPPED_PER_STEP * SLIDING_MASS * contact.effective_mass * slide.rate
}

/// Damping of a spring against sliding of a stiffness [N/m], in [N·s/m].
///
/// A spring stretched by predicted velocities lags by a step, which gives it energy at the rate `Δt³ ω⁴ / 4` for an
/// oscillation of frequency ω; a damping of `Δt³ S² / 4 m` takes that away.
#[inline(always)]
fn damping(
    contact: &Contact,
    pair: &MaterialPair,
    normal: &NormalForce,
    slide: &Slide,
    stiffness: f64,
) -> f64 {
    // Both directions are damped by one ratio, c ∝ √(stiffness m*), and the normal root is known.
    let of_pair = normal.damping * pair.tangential_damping_share;
    let per_step = slide.time_step * stiffness;
    let per_mass = contact.inverse_mass / SLIDING_MASS;
    let of_prediction = 0.25 * slide.time_step * per_step * per_step * per_mass;
    let damping = of_pair + of_prediction;
    let steadiest = steadiest_damping(contact, slide);
    if damping < steadiest {
        damping
    } else {
        steadiest
    }
}
