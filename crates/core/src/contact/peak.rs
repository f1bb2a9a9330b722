//! The greatest force and the greatest overlap between two samples of a contact.

use super::normal::Normal;
use super::{Contact, ContactHistory};
use crate::MaterialPair;

/// Parts of a step in which the top is sought [-].
const PARTS: u32 = 8;

/// Overlap and its rate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion {
    /// Overlap [m].
    pub(super) overlap: f64,
    /// Its rate [m/s].
    pub(super) speed: f64,
}

/// What has a top.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    /// The normal force [N].
    Force,
    /// The overlap [m].
    Overlap,
}

/// Greatest value within a number of steps of a motion; none where the top is farther away.
///
/// Samples of a smooth peak fall short of it by up to 1.5 % at 12 steps per contact. The contact is followed by itself
/// from the sample toward its top, by the classical method of Runge and Kutta over parts of a step.
pub(super) fn top_near<N: Normal>(
    quantity: Quantity,
    contact: &Contact,
    pair: &MaterialPair,
    history: &ContactHistory,
    from: Motion,
    (steps, time_step): (u32, f64),
) -> Option<f64> {
    let force_of = |motion: Motion| {
        let at = Contact {
            overlap: motion.overlap.max(0.0),
            ..*contact
        };
        N::force(&at, pair, history, motion.speed).force
    };
    let value_of = |motion: Motion| match quantity {
        Quantity::Force => force_of(motion),
        Quantity::Overlap => motion.overlap,
    };
    let mut motion = from;
    let part = time_step / f64::from(PARTS);
    let here = value_of(motion);
    let ahead = advanced(motion, part, contact.effective_mass, force_of);
    let time = if value_of(ahead) > here { part } else { -part };
    let mut last = [here, here];
    for _ in 0..steps * PARTS {
        motion = advanced(motion, time, contact.effective_mass, force_of);
        let value = value_of(motion);
        if value <= last[1] {
            return Some(top_of_parabola(last[0], last[1], value));
        }
        last = [last[1], value];
    }
    None
}

/// The motion of the contact by itself, `m* δ̈ = −F`, a time later [s].
fn advanced(from: Motion, time: f64, mass: f64, force_of: impl Fn(Motion) -> f64) -> Motion {
    let rate = |motion: Motion| Motion {
        overlap: motion.speed,
        speed: -force_of(motion) / mass,
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

/// Top of the parabola through three even samples, the middle one the greatest.
fn top_of_parabola(before: f64, middle: f64, after: f64) -> f64 {
    let bend = before - 2.0 * middle + after;
    if bend < 0.0 {
        middle - (after - before).powi(2) / (8.0 * bend)
    } else {
        middle
    }
}
