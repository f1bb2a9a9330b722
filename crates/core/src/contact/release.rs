//! The release of a contact, by following it from a sample to where spring and damping balance.
//!
//! There the force is gone, though damped bodies still overlap: the last kick is the one that leaves them with the speed
//! they have then.

use super::motion::{Alone, Motion};
use super::normal::Normal;

/// Parts of a step in which the contact is followed [-].
const PARTS: u32 = 2;

/// Speed of approach at release [m/s], where that is within two steps [s] of a motion.
pub(super) fn speed_at_release<N: Normal>(
    alone: &Alone<'_>,
    from: Motion,
    time_step: f64,
) -> Option<f64> {
    // What the law gives where the force is not clamped.
    let balance = |motion: Motion| {
        let law = alone.force::<N>(motion);
        law.elastic + law.damping * motion.speed
    };
    let part = time_step / f64::from(PARTS);
    let mut motion = from;
    let mut force = balance(motion);
    for _ in 0..2 * PARTS {
        if force <= 0.0 {
            return Some(motion.speed);
        }
        let next = alone.advanced::<N>(motion, part);
        let next_force = balance(next);
        if next_force <= 0.0 {
            let share = force / (force - next_force);
            return Some(alone.advanced::<N>(motion, share * part).speed);
        }
        (motion, force) = (next, next_force);
    }
    None
}
