//! Mindlin's tangential spring with history, damped, capped by Coulomb's friction.
//!
//! `F = −8 G* a ξ − c v`, at most `μ F_n` (Mindlin 1949). Where the contact grows or shrinks, the spring keeps its energy.

use super::{Slide, Tangential, damping};
use crate::MaterialPair;
use crate::contact::normal::NormalForce;
use crate::contact::spring::{CappedSpring, Sampled, SpringForce, turned_into_plane};
use crate::contact::{Contact, ContactHistory};

/// Mindlin's spring.
#[derive(Debug, Clone, Copy)]
pub struct Mindlin;

impl Tangential for Mindlin {
    #[inline(always)]
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        slide: &Slide,
        history: &mut ContactHistory,
    ) -> SpringForce {
        let stiffness = 8.0 * pair.effective_shear_modulus * normal.contact_radius;
        let spring = CappedSpring {
            root_stiffness: stiffness.sqrt(),
            damping: damping(contact, pair, normal, slide, stiffness),
            cap: pair.friction * normal.pressing(),
        };
        let sampled = Sampled {
            velocity: slide.velocity,
            behind: slide.behind,
            ahead: 0.5 * slide.time_step,
        };
        let stretch = &mut history.tangential_stretch;
        *stretch = turned_into_plane(*stretch, contact.normal);
        spring.pull(&sampled, stretch)
    }
}
