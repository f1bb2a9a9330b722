//! No friction and no rolling resistance.

use super::hertz::NormalForce;
use super::mindlin::TangentialForce;
use super::{Contact, Rolling, Tangential};
use crate::{MaterialPair, Vec3};

/// Bodies slide freely.
#[derive(Debug, Clone, Copy)]
pub struct NoFriction;

impl Tangential for NoFriction {
    #[inline]
    fn force(
        _: &Contact,
        _: &MaterialPair,
        _: &NormalForce,
        _: Vec3,
        displacement: Vec3,
        _: f64,
    ) -> TangentialForce {
        TangentialForce {
            force: Vec3::zeros(),
            displacement,
            elastic_energy: 0.0,
            power: 0.0,
        }
    }
}

/// Bodies roll freely.
#[derive(Debug, Clone, Copy)]
pub struct NoRolling;

impl Rolling for NoRolling {
    #[inline]
    fn torque(_: &Contact, _: &MaterialPair, _: f64, _: f64) -> Vec3 {
        Vec3::zeros()
    }
}
