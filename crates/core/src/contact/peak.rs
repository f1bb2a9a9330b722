//! The greatest force and the greatest overlap between two samples of a contact.

use super::motion::{Alone, Motion};
use super::normal::Normal;

/// Parts of a step in which the top is sought [-].
const PARTS: u32 = 4;

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
    alone: &Alone<'_>,
    from: Motion,
    (steps, time_step): (u32, f64),
) -> Option<f64> {
    let value_of = |motion: Motion| match quantity {
        Quantity::Force => alone.force::<N>(motion).force,
        Quantity::Overlap => motion.overlap,
    };
    let mut motion = from;
    let part = time_step / f64::from(PARTS);
    let here = value_of(motion);
    let ahead = alone.advanced::<N>(motion, part);
    let time = if value_of(ahead) > here { part } else { -part };
    let mut last = [here, here];
    // A top at the very end shows itself one part later.
    for _ in 0..=steps * PARTS {
        motion = alone.advanced::<N>(motion, time);
        let value = value_of(motion);
        if value <= last[1] {
            return Some(top_of_parabola(last[0], last[1], value));
        }
        last = [last[1], value];
    }
    None
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
