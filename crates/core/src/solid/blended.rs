//! Where a ball touches parts joined by a fillet: the fillet, or the parts where it leaves them bare.

use super::together::Together;
use super::{Touches, together};
use crate::{Shape, Vec3};

/// Parts joined by a fillet.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Blended {
    shape: Shape,
    parts: Together,
}

impl Blended {
    /// `shape` joins the parts `of` by a fillet.
    pub(super) fn new(shape: &Shape, of: &[Shape]) -> Self {
        Self {
            shape: shape.clone(),
            parts: Together::new(of),
        }
    }

    pub(super) fn offer(&self, center: Vec3, touches: &mut Touches) {
        let mut own = Touches::none(touches.reach());
        self.parts.offer(center, &mut own);
        let clearance = together::CLEARANCE * touches.reach();
        let mut is_covered = own.as_slice().is_empty();
        for &surface in own.as_slice() {
            let out_of_it = center - (surface.distance - clearance) * surface.normal;
            if self.shape.distance(out_of_it) < clearance * (1.0 - together::ROUNDING) {
                is_covered = true;
            } else {
                touches.offer(surface);
            }
        }
        if is_covered {
            touches.offer(self.shape.surface(center));
        }
    }
}
