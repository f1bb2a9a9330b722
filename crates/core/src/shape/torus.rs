//! A ring about the z axis: everything within the tube's radius of a circle.

use super::Surface;
use super::revolution::{HalfPlaneSurface, turned};
use crate::Vec3;

pub(super) fn surface(ring_radius: f64, tube_radius: f64, point: Vec3) -> Surface {
    turned(point, |from_axis, z| {
        let beyond_ring = from_axis - ring_radius;
        let from_ring = beyond_ring.hypot(z);
        // In the middle of the tube every way out is as short: any will do.
        let normal = if from_ring > 0.0 {
            [beyond_ring / from_ring, z / from_ring]
        } else {
            [1.0, 0.0]
        };
        HalfPlaneSurface {
            distance: from_ring - tube_radius,
            normal,
            meridian_curvature: 1.0 / tube_radius,
        }
    })
}
