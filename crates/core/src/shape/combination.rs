//! Shapes put together by the exact minimum and maximum of their distances.
//!
//! On the surface, and wherever one part is nearest, the result is the true distance.
//! Elsewhere it is a lower bound of it in magnitude: outside the edge of an intersection, and inside a union.

use super::{Shape, Surface};
use crate::Vec3;

pub(super) fn union(of: &[Shape], point: Vec3) -> Surface {
    of.iter()
        .map(|shape| shape.surface(point))
        .reduce(|nearest, other| {
            if other.distance < nearest.distance {
                other
            } else {
                nearest
            }
        })
        .unwrap_or(NOWHERE)
}

pub(super) fn intersection(of: &[Shape], point: Vec3) -> Surface {
    of.iter()
        .map(|shape| shape.surface(point))
        .reduce(|farthest, other| {
            if other.distance > farthest.distance {
                other
            } else {
                farthest
            }
        })
        .unwrap_or(NOWHERE)
}

pub(super) fn difference(of: &Shape, minus: &Shape, point: Vec3) -> Surface {
    let kept = of.surface(point);
    let cut = inside_out(minus.surface(point));
    if cut.distance > kept.distance {
        cut
    } else {
        kept
    }
}

pub(crate) fn inside_out(surface: Surface) -> Surface {
    Surface {
        distance: -surface.distance,
        normal: -surface.normal,
        principal_curvatures: surface.principal_curvatures.map(|curvature| -curvature),
    }
}

/// What an empty combination answers; validation refuses it before any run.
const NOWHERE: Surface = Surface {
    distance: f64::INFINITY,
    normal: Vec3::new(0.0, 0.0, 1.0),
    principal_curvatures: [0.0; 2],
};
