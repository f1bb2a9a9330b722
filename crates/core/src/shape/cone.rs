//! A solid frustum about the z axis.

use super::Surface;
use super::revolution::{polygon_surface, turned};
use crate::Vec3;

pub(super) fn surface(
    lower_radius: f64,
    upper_radius: f64,
    half_length: f64,
    point: Vec3,
) -> Surface {
    let corners = [
        [0.0, -half_length],
        [lower_radius, -half_length],
        [upper_radius, half_length],
        [0.0, half_length],
    ];
    turned(point, |from_axis, z| {
        polygon_surface(&corners, from_axis, z)
    })
}
