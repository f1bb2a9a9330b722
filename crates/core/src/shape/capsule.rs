//! A capsule: everything within a radius of a piece of the z axis.

use super::Surface;
use crate::Vec3;

pub(super) fn surface(radius: f64, half_length: f64, point: Vec3) -> Surface {
    let nearest_on_axis = point.z.clamp(-half_length, half_length);
    let offset = point - nearest_on_axis * Vec3::z();
    let from_axis = offset.norm();
    // On the axis every way across is as short: any will do.
    let normal = if from_axis > 0.0 {
        offset / from_axis
    } else {
        Vec3::x()
    };
    let is_beside_end = point.z.abs() > half_length;
    Surface {
        distance: from_axis - radius,
        normal,
        principal_curvatures: [1.0 / radius, if is_beside_end { 1.0 / radius } else { 0.0 }],
    }
}
