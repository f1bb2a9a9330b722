//! No friction.

use super::{Slide, Tangential};
use crate::MaterialPair;
use crate::contact::normal::NormalForce;
use crate::contact::spring::SpringForce;
use crate::contact::{Contact, ContactHistory};

/// Bodies slide freely.
#[derive(Debug, Clone, Copy)]
pub struct NoFriction;

impl Tangential for NoFriction {
    #[inline(always)]
    fn force(
        _: &Contact,
        _: &MaterialPair,
        _: &NormalForce,
        _: &Slide,
        _: &mut ContactHistory,
    ) -> SpringForce {
        SpringForce::NONE
    }
}
