//! A solid cylinder about the z axis.

use super::Surface;
use super::revolution::{HalfPlaneSurface, turned};
use crate::Vec3;

pub(super) fn surface(radius: f64, half_length: f64, point: Vec3) -> Surface {
    turned(point, |from_axis, z| {
        let beyond_side = from_axis - radius;
        let beyond_end = z.abs() - half_length;
        let end_sign = if z < 0.0 { -1.0 } else { 1.0 };
        if beyond_side > 0.0 && beyond_end > 0.0 {
            let distance = beyond_side.hypot(beyond_end);
            HalfPlaneSurface {
                distance,
                normal: [beyond_side / distance, end_sign * beyond_end / distance],
                meridian_curvature: f64::INFINITY,
            }
        } else if beyond_side > beyond_end {
            HalfPlaneSurface::flat(beyond_side, [1.0, 0.0])
        } else {
            HalfPlaneSurface::flat(beyond_end, [0.0, end_sign])
        }
    })
}
