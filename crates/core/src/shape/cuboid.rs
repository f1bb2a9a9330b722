//! A box: exact outside, where faces, edges and corners are each nearest somewhere.

use super::Surface;
use crate::Vec3;

pub(super) fn surface(half_sides: Vec3, point: Vec3) -> Surface {
    let beyond = point.abs() - half_sides;
    let sign = point.map(|value| if value < 0.0 { -1.0 } else { 1.0 });
    let outside = beyond.sup(&Vec3::zeros());
    let outside_distance = outside.norm();
    let (distance, normal) = if outside_distance > 0.0 {
        (
            outside_distance,
            outside.component_mul(&sign) / outside_distance,
        )
    } else {
        let axis = beyond.imax();
        let mut normal = Vec3::zeros();
        normal[axis] = sign[axis];
        (beyond[axis], normal)
    };
    Surface {
        distance,
        normal,
        mean_curvature: 0.0,
    }
}
