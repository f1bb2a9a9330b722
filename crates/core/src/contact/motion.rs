//! The motion of two bodies along their normal by their contact alone.

use super::normal::{Normal, NormalForce};
use super::{Contact, ContactHistory};
use crate::MaterialPair;

/// Overlap and its rate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion {
    /// Overlap [m].
    pub(super) overlap: f64,
    /// Its rate [m/s].
    pub(super) speed: f64,
}

/// Two bodies that nothing but their contact acts on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Alone<'a> {
    pub(super) contact: &'a Contact,
    pub(super) pair: &'a MaterialPair,
    pub(super) history: &'a ContactHistory,
}

impl Alone<'_> {
    /// The normal force of a motion.
    pub(super) fn force<N: Normal>(&self, motion: Motion) -> NormalForce {
        let at = Contact {
            overlap: motion.overlap.max(0.0),
            ..*self.contact
        };
        N::force(&at, self.pair, self.history, motion.speed)
    }

    /// The motion, `m* δ̈ = −F`, a time later [s], by the classical method of Runge and Kutta.
    pub(super) fn advanced<N: Normal>(&self, from: Motion, time: f64) -> Motion {
        let rate = |motion: Motion| Motion {
            overlap: motion.speed,
            speed: -self.force::<N>(motion).force / self.contact.effective_mass,
        };
        let moved = |by: Motion, share: f64| Motion {
            overlap: from.overlap + share * time * by.overlap,
            speed: from.speed + share * time * by.speed,
        };
        let first = rate(from);
        let second = rate(moved(first, 0.5));
        let third = rate(moved(second, 0.5));
        let fourth = rate(moved(third, 1.0));
        let mean = |of: fn(&Motion) -> f64| {
            (of(&first) + 2.0 * of(&second) + 2.0 * of(&third) + of(&fourth)) / 6.0
        };
        Motion {
            overlap: from.overlap + time * mean(|motion| motion.overlap),
            speed: from.speed + time * mean(|motion| motion.speed),
        }
    }
}
