//! No resistance.

use super::{Resistance, Turning};
use crate::Vec3;
use crate::contact::spring::SpringForce;

/// Bodies turn freely.
#[derive(Debug, Clone, Copy)]
pub struct FreeTurning;

impl Turning for FreeTurning {
    #[inline(always)]
    fn torque(_: &Resistance, _: Vec3, _: &mut Vec3) -> SpringForce {
        SpringForce::NONE
    }
}
