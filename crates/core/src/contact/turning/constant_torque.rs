//! A torque of constant size against the turning (Ai et al. 2011, type A).

use super::{Resistance, Turning};
use crate::Vec3;
use crate::contact::spring::SpringForce;

/// Share of a body's spin that one contact may stop in one step [-].
///
/// Below the spin that it stops, the torque falls in proportion, so that a body at rest is not shaken.
const STOPPED_PER_STEP: f64 = 0.25;

/// The greatest torque, against any turning.
#[derive(Debug, Clone, Copy)]
pub struct ConstantTorque;

impl Turning for ConstantTorque {
    #[inline(always)]
    fn torque(resistance: &Resistance, spin: Vec3, _: &mut Vec3) -> SpringForce {
        let size = spin.norm();
        let stopping = STOPPED_PER_STEP * resistance.inertia * size * resistance.rate;
        let smaller = if resistance.most < stopping {
            resistance.most
        } else {
            stopping
        };
        let per_spin = if size > 0.0 { smaller / size } else { 0.0 };
        SpringForce {
            force: -per_spin * spin,
            elastic_energy: 0.0,
            power: smaller * size,
        }
    }
}
