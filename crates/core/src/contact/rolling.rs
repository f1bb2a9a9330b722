//! Rolling resistance of constant torque (Ai et al. 2011, type A).

use super::{Contact, Rolling};
use crate::{MaterialPair, Vec3};

/// Share of a body's spin that one contact may stop in one step [-].
///
/// Below the spin that it stops, the torque falls in proportion, so that a body at rest is not shaken.
const STOPPED_PER_STEP: f64 = 0.25;

/// A torque of at most `μ_r R* F_n` against the rolling.
#[derive(Debug, Clone, Copy)]
pub struct ConstantTorque;

impl Rolling for ConstantTorque {
    #[inline]
    fn torque(contact: &Contact, pair: &MaterialPair, normal_force: f64, time_step: f64) -> Vec3 {
        let twist = contact.relative_spin.dot(&contact.normal);
        let rolling = contact.relative_spin - twist * contact.normal;
        let spin = rolling.norm();
        let radius = contact.effective_radius;
        let resisting = pair.rolling_friction * radius * normal_force;
        let stopping =
            STOPPED_PER_STEP * 0.4 * contact.effective_mass * radius * radius * spin / time_step;
        let smaller = if resisting < stopping {
            resisting
        } else {
            stopping
        };
        let per_spin = if spin > 0.0 { -smaller / spin } else { 0.0 };
        rolling * per_spin
    }
}
