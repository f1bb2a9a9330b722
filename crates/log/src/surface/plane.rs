//! The face of a half-space, as far as a box reaches.

use super::Mesh;
use nalgebra::UnitVector3;
use pelletflow_core::{Bounds, Vec3};

/// Share of the box's diagonal by which it is grown, so that a plane in one of its sides is shown [-].
const MARGIN: f64 = 1.0e-6;

/// The polygon that the plane cuts out of the box; nothing where it misses the box or the box has no end.
pub(super) fn mesh(on_plane: Vec3, normal: UnitVector3<f64>, bounds: &Bounds) -> Mesh {
    let mut mesh = Mesh::default();
    if !bounds.is_finite() {
        return mesh;
    }
    let diagonal = (bounds.max - bounds.min).norm();
    let bounds = bounds.grown(MARGIN * diagonal);
    let center = (bounds.min + bounds.max) / 2.0;
    let foot = center - normal.into_inner() * (center - on_plane).dot(&normal);
    let across = if normal.z.abs() < 0.9 {
        Vec3::z()
    } else {
        Vec3::x()
    };
    let first = across.cross(&normal).normalize() * diagonal;
    let second = normal.cross(&first);
    // A square larger than the box, then cut by each of its six sides.
    let mut polygon = vec![
        foot - first - second,
        foot + first - second,
        foot + first + second,
        foot - first + second,
    ];
    for axis in 0..3 {
        polygon = kept(&polygon, |point| bounds.min[axis] - point[axis]);
        polygon = kept(&polygon, |point| point[axis] - bounds.max[axis]);
    }
    if polygon.len() >= 3 {
        mesh.push_polygon(&polygon);
        mesh.push_outline(&polygon);
    }
    mesh
}

/// The part of a convex polygon where a linear function is not positive.
fn kept(polygon: &[Vec3], outside: impl Fn(&Vec3) -> f64) -> Vec<Vec3> {
    let mut result = Vec::with_capacity(polygon.len() + 1);
    let next = polygon.iter().cycle().skip(1);
    for (from, to) in polygon.iter().zip(next) {
        let (at_from, at_to) = (outside(from), outside(to));
        if at_from <= 0.0 {
            result.push(*from);
        }
        if (at_from <= 0.0) != (at_to <= 0.0) {
            result.push(from.lerp(to, at_from / (at_from - at_to)));
        }
    }
    result
}
