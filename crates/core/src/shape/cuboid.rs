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
    // Two sides exceeded are an edge, three a corner, which is sharp every way.
    let sharp = |least: usize| {
        if beyond.iter().filter(|&&length| length > 0.0).count() >= least {
            f64::INFINITY
        } else {
            0.0
        }
    };
    Surface {
        distance,
        normal,
        principal_curvatures: [sharp(2), sharp(3)],
    }
}
