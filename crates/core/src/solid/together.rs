//! Where a ball touches several parts: wherever it touches one of them, unless another covers that place.

use super::{Part, Touches};
use crate::{Bounds, Shape, Surface, Vec3};
use smallvec::SmallVec;

/// How far out of the surface a touched place must be clear of the other parts, over the radius of the ball [-].
pub(super) const CLEARANCE: f64 = 1.0e-3;
/// Share of that by which another part may be nearer: it is then as near by rounding alone [-].
pub(super) const ROUNDING: f64 = 1.0e-6;

/// Parts together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Together {
    parts: Vec<(Bounds, Part)>,
}

impl Together {
    pub(super) fn new(of: &[Shape]) -> Self {
        Self {
            parts: of
                .iter()
                .map(|shape| (shape.bounds(), Part::new(shape)))
                .collect(),
        }
    }

    pub(super) fn offer(&self, center: Vec3, touches: &mut Touches) {
        let reach = touches.reach();
        let mut near = self
            .parts
            .iter()
            .filter(|(bounds, _)| bounds.grown(reach).contains(center))
            .map(|(_, part)| part);
        let Some(first) = near.next() else { return };
        let Some(second) = near.next() else {
            first.offer(center, touches);
            return;
        };
        let near: SmallVec<[&Part; 8]> = [first, second].into_iter().chain(near).collect();
        for (index, part) in near.iter().enumerate() {
            let mut own = Touches::none(reach);
            part.offer(center, &mut own);
            for surface in own.as_slice() {
                let mut others = near
                    .iter()
                    .enumerate()
                    .filter(|&(other, _)| other != index)
                    .map(|(_, other)| other);
                if others.all(|other| leaves_bare(other, center, surface, reach)) {
                    touches.offer(*surface);
                }
            }
        }
    }
}

/// Whether a part leaves bare a place that the ball touches on another part.
///
/// Just out of the surface nothing may be nearer than that place. Where two parts lie flush, the edge of one is covered
/// by the face of the other.
fn leaves_bare(part: &Part, center: Vec3, surface: &Surface, reach: f64) -> bool {
    let clearance = CLEARANCE * reach;
    let out_of_it = center - (surface.distance - clearance) * surface.normal;
    part.distance_within(out_of_it, clearance) >= clearance * (1.0 - ROUNDING)
}
