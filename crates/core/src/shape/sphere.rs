//! A ball (the paper's equations 1 and 2).

use super::Surface;
use crate::Vec3;

pub(super) fn surface(radius: f64, point: Vec3) -> Surface {
    let from_center = point.norm();
    // At the center every way out is as short: any will do.
    let normal = if from_center > 0.0 {
        point / from_center
    } else {
        Vec3::z()
    };
    Surface {
        distance: from_center - radius,
        normal,
        principal_curvatures: [1.0 / radius; 2],
    }
}
