//! The six sides of a box.

use super::Mesh;
use pelletflow_core::{Bounds, Vec3};

/// The box; nothing where it is empty or without end.
pub(super) fn mesh(bounds: &Bounds) -> Mesh {
    let mut mesh = Mesh::default();
    if !bounds.is_finite() {
        return mesh;
    }
    for axis in 0..3 {
        for (end, position) in [(-1.0, bounds.min[axis]), (1.0, bounds.max[axis])] {
            let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
            let corner = |at_first: f64, at_second: f64| {
                let mut corner = Vec3::zeros();
                corner[axis] = position;
                corner[first] = at_first;
                corner[second] = at_second;
                corner
            };
            let (low, high) = (bounds.min, bounds.max);
            let mut side = [
                corner(low[first], low[second]),
                corner(high[first], low[second]),
                corner(high[first], high[second]),
                corner(low[first], high[second]),
            ];
            // Each edge belongs to two sides; the sides across one axis give four, from low to high.
            mesh.edges.push([side[0], side[1]]);
            mesh.edges.push([side[3], side[2]]);
            if end < 0.0 {
                side.reverse();
            }
            mesh.push_polygon(&side);
        }
    }
    mesh
}
