//! Mindlin's tangential spring with history, damped, capped by Coulomb's friction.
//!
//! `F = −8 G* a ξ − c v`, at most `μ F_n` (Mindlin 1949; total-displacement form).

use super::hertz::NormalForce;
use super::{Contact, ContactHistory};
use crate::{MaterialPair, Vec3};

/// The tangential part of a contact force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentialForce {
    /// Force on body A [N].
    pub force: Vec3,
    /// Energy stored in the spring [J].
    pub elastic_energy: f64,
    /// Rate at which the motion works on spring, damper and slider together [W].
    pub power: f64,
}

/// Tangential force of a contact whose surfaces slide at `sliding` [m/s].
///
/// Velocities belong to the middle of the step that the displacement grows over, so the force takes half
/// of this step's growth and the history all of it: second order in the step at no extra cost.
#[inline]
pub fn force(
    contact: &Contact,
    pair: &MaterialPair,
    normal: &NormalForce,
    sliding: Vec3,
    history: &mut ContactHistory,
    time_step: f64,
) -> TangentialForce {
    let stiffness = 8.0 * pair.effective_shear_modulus * normal.contact_radius;
    // Both directions are damped by one ratio, c ∝ √(stiffness m*), and the normal root is known.
    let damping = normal.damping * pair.tangential_damping_share;
    let half_growth = 0.5 * time_step * sliding;
    let mut displacement =
        turned_into_plane(history.tangential_displacement, contact.normal) + half_growth;
    let mut force = -stiffness * displacement - damping * sliding;
    let cap = pair.friction * normal.force;
    let squared = force.norm_squared();
    if squared > cap * cap {
        force *= cap / squared.sqrt();
        displacement = -(force + damping * sliding) / stiffness;
    }
    history.tangential_displacement = displacement + half_growth;
    TangentialForce {
        force,
        elastic_energy: 0.5 * stiffness * displacement.norm_squared(),
        power: -force.dot(&sliding),
    }
}

/// A displacement turned with the contact: laid into the plane across the normal, its length kept.
#[inline]
fn turned_into_plane(displacement: Vec3, normal: Vec3) -> Vec3 {
    let out_of_plane = displacement.dot(&normal);
    if out_of_plane == 0.0 {
        return displacement;
    }
    let flat = displacement - out_of_plane * normal;
    let flat_squared = flat.norm_squared();
    if flat_squared == 0.0 {
        return flat;
    }
    flat * (displacement.norm_squared() / flat_squared).sqrt()
}
