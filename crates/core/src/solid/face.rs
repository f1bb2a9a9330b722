//! A smooth face of a solid, which goes on beyond the edges at which the solid ends.

use super::similarity::Similarity;
use crate::shape::combination::inside_out;
use crate::shape::offset::parallel;
use crate::shape::revolution::{HalfPlaneSurface, from_axis, lifted};
use crate::{Bounds, Shape, Surface, Vec3};

/// A face where it stands.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Face {
    pub(super) kind: FaceKind,
    pub(super) placement: Similarity,
    /// Which of the solid's frames that is.
    pub(super) frame: usize,
    /// Distance by which it is moved outward [m].
    pub(super) moved: f64,
    /// Whether the solid is on its other side.
    pub(super) is_reversed: bool,
    /// A box about the part of it that can bound the solid.
    pub(super) bounds: Bounds,
}

/// Which surface it is, in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum FaceKind {
    /// That of a shape without edges.
    Smooth(Shape),
    /// A line of the half-plane `[radius, z]` turned about the z axis: a plane, a cylinder or a cone.
    Slope {
        /// A point of the line [m].
        start: [f64; 2],
        /// Unit vector out of the solid [-].
        normal: [f64; 2],
    },
}

impl Face {
    /// The face seen from a point.
    pub(super) fn surface(&self, point: Vec3) -> Surface {
        let own = self.placement.inverse_point(point);
        let surface = match &self.kind {
            FaceKind::Smooth(shape) => shape.surface(own),
            FaceKind::Slope { start, normal } => {
                let distance =
                    (from_axis(own) - start[0]) * normal[0] + (own.z - start[1]) * normal[1];
                lifted(own, &HalfPlaneSurface::flat(distance, *normal))
            }
        };
        let mut surface = self.placement.surface(surface);
        if self.moved != 0.0 {
            surface = parallel(surface, self.moved);
        }
        if self.is_reversed {
            inside_out(surface)
        } else {
            surface
        }
    }

    /// Distance of a point, which is given in the face's own frame [m].
    pub(super) fn distance_in_frame(&self, own: Vec3) -> f64 {
        let distance = match &self.kind {
            FaceKind::Smooth(shape) => shape.distance(own),
            FaceKind::Slope { start, normal } => {
                (from_axis(own) - start[0]) * normal[0] + (own.z - start[1]) * normal[1]
            }
        };
        let moved = self.placement.scale() * distance - self.moved;
        if self.is_reversed { -moved } else { moved }
    }

    /// Whether the part that can bound the solid may be as near as this to a point [m].
    pub(super) fn may_be_within(&self, distance: f64, point: Vec3) -> bool {
        self.bounds.grown(distance).contains(point)
    }

    /// Whether two faces may bound the solid at the same place.
    pub(super) fn may_meet(&self, other: &Self) -> bool {
        let common = self.bounds.common(&other.bounds);
        let rounding = 1.0e-9;
        (0..3).all(|axis| common.min[axis] <= common.max[axis] + rounding)
    }
}
