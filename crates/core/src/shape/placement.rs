//! A shape moved or turned.

use super::{Shape, Surface};
use crate::Vec3;
use nalgebra::UnitQuaternion;

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
