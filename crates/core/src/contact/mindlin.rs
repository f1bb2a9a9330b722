//! Mindlin's tangential spring with history, damped, capped by Coulomb's friction.
//!
//! `F = −8 G* a ξ − c v`, at most `μ F_n` (Mindlin 1949; total-displacement form).

use super::hertz::NormalForce;
use super::{Contact, Tangential};
use crate::{MaterialPair, Vec3};

/// The tangential part of a contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentialForce {
    /// Force on body A [N].
    pub force: Vec3,
    /// Elastic tangential displacement to remember [m].
    pub displacement: Vec3,
    /// Energy stored in the spring [J].
    pub elastic_energy: f64,
    /// Rate at which the motion works on spring, damper and slider together [W].
    pub power: f64,
}

/// Share of the sliding that damping alone may stop in one step [-].
///
/// Damping answers to a predicted velocity, which is stable while all contacts of a pellet together stop less than the
/// whole of its motion in a step. A dozen contacts do within this bound; strong damping alone would break it.
const STOPPED_PER_STEP: f64 = 0.3;
/// Mass that resists sliding at the surface of solid spheres, over the effective mass: `1 / (1 + R² m / I)` [-].
const SLIDING_MASS: f64 = 2.0 / 7.0;

/// Mindlin's spring.
#[derive(Debug, Clone, Copy)]
pub struct Mindlin;

impl Tangential for Mindlin {
    /// Velocities belong to the middle of the step that the displacement grows over, so the force takes half
    /// of this step's growth and the memory all of it: second order in the step at no extra cost.
    #[inline]
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        sliding: Vec3,
        displacement: Vec3,
        time_step: f64,
    ) -> TangentialForce {
        let stiffness = 8.0 * pair.effective_shear_modulus * normal.contact_radius;
        // Both directions are damped by one ratio, c ∝ √(stiffness m*), and the normal root is known.
        let damping = normal.damping * pair.tangential_damping_share;
        let steadiest = STOPPED_PER_STEP * SLIDING_MASS * contact.effective_mass / time_step;
        let damping = if damping < steadiest {
            damping
        } else {
            steadiest
        };
        let half_growth = 0.5 * time_step * sliding;
        let tried = turned_into_plane(displacement, contact.normal) + half_growth;
        let stuck = -stiffness * tried - damping * sliding;
        let cap = pair.friction * normal.force;
        let squared = stuck.norm_squared();
        // Both answers are worked out and one is taken: contacts in a batch must not branch.
        let is_sliding = squared > cap * cap;
        let share = if is_sliding {
            cap / squared.sqrt()
        } else {
            1.0
        };
        let force = share * stuck;
        // The damper may hold the cap alone; the spring then goes on until it holds it, and no farther.
        let tried_squared = tried.norm_squared();
        let longest = cap / stiffness;
        let kept = if tried_squared > longest * longest {
            longest / tried_squared.sqrt()
        } else {
            1.0
        };
        let reached = kept * tried;
        TangentialForce {
            force,
            displacement: reached + half_growth,
            elastic_energy: 0.5 * stiffness * reached.norm_squared(),
            power: -force.dot(&sliding),
        }
    }
}

/// A displacement turned with the contact: laid into the plane across the normal, its length kept.
#[inline]
fn turned_into_plane(displacement: Vec3, normal: Vec3) -> Vec3 {
    let flat = displacement - displacement.dot(&normal) * normal;
    let flat_squared = flat.norm_squared();
    let stretch = (displacement.norm_squared() / flat_squared).sqrt();
    flat * if flat_squared > 0.0 { stretch } else { 0.0 }
}
