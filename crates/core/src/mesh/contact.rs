//! Where a ball touches triangles.

use super::{Foot, FootOn, Triangle, TriangleMesh};
use crate::{Surface, Touches, Vec3};

/// Distance over the radius of the ball below which a point lies on a triangle: beyond the single precision of files, and
/// less than the ball can feel [-].
const ON_IT: f64 = 1.0e-3;

/// The nearest point of one triangle, within reach of the ball.
struct Near {
    triangle: Triangle,
    foot: Foot,
    surface: Surface,
}

/// Offers the places where a ball touches the triangles named.
///
/// Faces come first, so that of two equally near the one with the exact normal is kept.
pub(super) fn offer(mesh: &TriangleMesh, candidates: &[u32], center: Vec3, touches: &mut Touches) {
    let near: Vec<Near> = candidates
        .iter()
        .filter_map(|&index| Near::new(mesh.triangle(index), center, touches.reach()))
        .collect();
    let tolerance = ON_IT * touches.reach();
    for rank in [FootOn::Face, FootOn::Edge, FootOn::Corner] {
        for own in near.iter().filter(|own| own.foot.on == rank) {
            if near
                .iter()
                .all(|other| other.leaves_bare(own, center, tolerance))
            {
                touches.offer(own.surface);
            }
        }
    }
}

impl Near {
    fn new(triangle: Triangle, center: Vec3, reach: f64) -> Option<Self> {
        let foot = triangle.foot(center);
        let way = center - foot.at;
        let squared = way.norm_squared();
        if squared >= reach * reach {
            return None;
        }
        let surface = if foot.on == FootOn::Face || squared == 0.0 {
            flat(&triangle, center)
        } else {
            let distance = squared.sqrt();
            Surface {
                distance,
                normal: way / distance,
                principal_curvatures: match foot.on {
                    FootOn::Corner => [f64::INFINITY; 2],
                    _ => [f64::INFINITY, 0.0],
                },
            }
        };
        Some(Self {
            triangle,
            foot,
            surface,
        })
    }

    /// Whether this triangle neither goes on, nearer to the center, where the foot on another ends, nor hides it.
    fn leaves_bare(&self, other: &Self, center: Vec3, tolerance: f64) -> bool {
        if self.surface.distance >= other.surface.distance {
            return true;
        }
        let goes_on =
            other.foot.on != FootOn::Face && self.triangle.distance(other.foot.at) <= tolerance;
        !goes_on && !self.hides(other.foot.at, center, tolerance)
    }

    /// Whether the straight way from the center to a point passes through the triangle.
    fn hides(&self, point: Vec3, center: Vec3, tolerance: f64) -> bool {
        let normal = self.triangle.area_vector().normalize();
        let height = |at: Vec3| normal.dot(&(at - self.triangle.corners[0]));
        let (above, below) = (height(center), height(point));
        let is_across = above * below < 0.0 && below.abs() > tolerance;
        is_across && {
            let crossing = center + (above / (above - below)) * (point - center);
            self.triangle.distance(crossing) <= tolerance
        }
    }
}

/// The plane of a triangle, seen from either side.
fn flat(triangle: &Triangle, center: Vec3) -> Surface {
    let normal = triangle.area_vector().normalize();
    let height = normal.dot(&(center - triangle.corners[0]));
    Surface {
        distance: height.abs(),
        normal: 1.0_f64.copysign(height) * normal,
        principal_curvatures: [0.0; 2],
    }
}
