//! A shape grown outward: the surface at a constant distance from its own.
//!
//! Each principal curvature κ becomes κ / (1 + κ d) at the distance d (do Carmo 1976, section 3-5, exercise 11).
//! That is exact wherever the shape's own distance and curvatures are: on planes, balls, cylinders and all others;
//! an edge, infinitely sharp, becomes a round of radius d.

use super::{Shape, Surface};
use crate::Vec3;

pub(super) fn surface(by: f64, of: &Shape, point: Vec3) -> Surface {
    parallel(of.surface(point), by)
}

/// The parallel surface at a distance, positive outward.
pub(crate) fn parallel(surface: Surface, at: f64) -> Surface {
    Surface {
        distance: surface.distance - at,
        normal: surface.normal,
        principal_curvatures: surface
            .principal_curvatures
            .map(|curvature| parallel_curvature(curvature, at)),
    }
}

fn parallel_curvature(curvature: f64, at: f64) -> f64 {
    if curvature.is_infinite() {
        return 1.0 / at;
    }
    let share_of_length = 1.0 + curvature * at;
    if share_of_length > 0.0 {
        curvature / share_of_length
    } else {
        // Beyond the center of curvature the parallel surface has no smooth point here, but an edge:
        // one that juts out of what was shrunk, a groove in what was grown.
        f64::INFINITY.copysign(-at)
    }
}
