//! Rolling resistance of constant torque (Ai et al. 2011, type A).

use super::Contact;
use crate::{MaterialPair, Vec3};

/// Share of a body's spin that one contact may stop in one step [-].
///
/// Below the spin that it stops, the torque falls in proportion, so that a body at rest is not shaken.
const STOPPED_PER_STEP: f64 = 0.25;

/// Rolling torque on body A, against its rolling over B, at most `μ_r R* F_n` [N·m].
#[inline]
pub fn torque(contact: &Contact, pair: &MaterialPair, normal_force: f64, time_step: f64) -> Vec3 {
    let twist = contact.relative_spin.dot(&contact.normal);
    let rolling = contact.relative_spin - twist * contact.normal;
    let spin = rolling.norm();
    if spin == 0.0 {
        return Vec3::zeros();
    }
    let radius = contact.effective_radius;
    let resisting = pair.rolling_friction * radius * normal_force;
    let stopping =
        STOPPED_PER_STEP * 0.4 * contact.effective_mass * radius * radius * spin / time_step;
    rolling * (-resisting.min(stopping) / spin)
}
