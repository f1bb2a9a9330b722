//! A shape moved, turned, mirrored or scaled.

use super::{Shape, Surface};
use crate::Vec3;
use nalgebra::{UnitQuaternion, UnitVector3};

pub(super) fn translated(by: Vec3, of: &Shape, point: Vec3) -> Surface {
    of.surface(point - by)
}

pub(super) fn rotated(by: UnitQuaternion<f64>, of: &Shape, point: Vec3) -> Surface {
    let surface = of.surface(by.inverse_transform_vector(&point));
    Surface {
        normal: by * surface.normal,
        ..surface
    }
}

pub(super) fn mirrored(
    on_plane: Vec3,
    normal: UnitVector3<f64>,
    of: &Shape,
    point: Vec3,
) -> Surface {
    let across = |vector: Vec3| vector - 2.0 * vector.dot(&normal) * normal.into_inner();
    let surface = of.surface(on_plane + across(point - on_plane));
    Surface {
        normal: across(surface.normal),
        ..surface
    }
}

pub(super) fn scaled(by: f64, of: &Shape, point: Vec3) -> Surface {
    let surface = of.surface(point / by);
    Surface {
        distance: surface.distance * by,
        normal: surface.normal,
        principal_curvatures: surface.principal_curvatures.map(|curvature| curvature / by),
    }
}
