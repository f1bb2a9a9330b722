//! A half-space: everything behind a plane (the paper's equation 4).

use super::Surface;
use crate::{Bounds, Vec3};
use nalgebra::UnitVector3;

pub(super) fn surface(on_plane: Vec3, normal: UnitVector3<f64>, point: Vec3) -> Surface {
    Surface {
        distance: (point - on_plane).dot(&normal),
        normal: normal.into_inner(),
        principal_curvatures: [0.0; 2],
    }
}

/// Finite only on the open side of a plane that stands across one axis.
pub(super) fn bounds(on_plane: Vec3, normal: UnitVector3<f64>) -> Bounds {
    let mut bounds = Bounds::everything();
    for axis in 0..3 {
        if normal[axis] == 1.0 {
            bounds.max[axis] = on_plane[axis];
        }
        if normal[axis] == -1.0 {
            bounds.min[axis] = on_plane[axis];
        }
    }
    bounds
}
