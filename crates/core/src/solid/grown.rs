//! Where a ball touches a part grown outward.

use super::{Part, Touches};
use crate::Vec3;
use crate::shape::offset::parallel;

/// Share of the growth by which a point may be too near and still count as on the surface [-].
const ROUNDING: f64 = 1.0e-9;

/// Offers the touches of a part grown by a length [m].
pub(super) fn offer(by: f64, of: &Part, center: Vec3, touches: &mut Touches) {
    let mut inner = Touches::none(touches.reach() + by);
    of.offer(center, &mut inner);
    for &surface in inner.as_slice() {
        let grown = parallel(surface, by);
        let foot = center - grown.distance * grown.normal;
        // In a corner the grown faces end where they meet; beyond, each lies within what the other has grown to.
        let is_bare =
            inner.as_slice().len() == 1 || of.distance_within(foot, by) >= by * (1.0 - ROUNDING);
        if is_bare {
            touches.offer(grown);
        }
    }
}
