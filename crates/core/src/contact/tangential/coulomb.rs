//! Coulomb's sliding friction without memory, regularized.
//!
//! `F = −μ F_n v / |v|`, the paper's (10); below the speed that it could stop within a step, in proportion to the speed.
//! A body that this friction should hold creeps instead: use a law with memory where beds come to rest.

use super::{Slide, Tangential, steadiest_damping};
use crate::MaterialPair;
use crate::contact::normal::NormalForce;
use crate::contact::spring::SpringForce;
use crate::contact::{Contact, ContactHistory};

/// Friction of the full size against any sliding.
#[derive(Debug, Clone, Copy)]
pub struct Coulomb;

impl Tangential for Coulomb {
    #[inline(always)]
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        slide: &Slide,
        _: &mut ContactHistory,
    ) -> SpringForce {
        let steadiest = steadiest_damping(contact, slide);
        let cap = pair.friction * normal.pressing();
        let squared = slide.velocity.norm_squared();
        let per_speed = if squared * steadiest * steadiest > cap * cap {
            cap / squared.sqrt()
        } else {
            steadiest
        };
        SpringForce {
            force: -per_speed * slide.velocity,
            elastic_energy: 0.0,
            power: per_speed * squared,
        }
    }
}
