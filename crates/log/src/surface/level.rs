//! The surface at a constant distance from a shape, found on a grid of cubes.
//!
//! Each cube that the surface goes through gets one point of it, and each side of cubes that it cuts
//! a face between the four cubes around (surface nets, Gibson 1998).

use super::Mesh;
use pelletflow_core::{Bounds, Shape, Vec3};
use std::collections::HashMap;

/// Cubes along the longest side of the box [-].
const CUBES: f64 = 48.0;
/// Steps along the normal that bring a point to the surface; one is enough where the distance is exact [-].
const STEPS: usize = 8;

/// Triangles where the distance to the shape is `level` [m]; nothing where the box is empty or has no end.
pub(super) fn mesh(shape: &Shape, level: f64, bounds: &Bounds) -> Mesh {
    let mut mesh = Mesh::default();
    let sides = bounds.max - bounds.min;
    if !bounds.is_finite() || sides.min() < 0.0 || sides.max() <= 0.0 {
        return mesh;
    }
    let grid = Grid::over(shape, level, bounds, sides);
    let mut points = HashMap::new();
    for (corner, axis, is_inside) in grid.cut_sides() {
        let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
        let around = [[1, 1], [0, 1], [0, 0], [1, 0]].map(|[back, down]| {
            let mut cube = corner;
            cube[first] -= back;
            cube[second] -= down;
            *points
                .entry(cube)
                .or_insert_with(|| grid.point_in(shape, level, cube))
        });
        let mut face = around;
        if !is_inside {
            face.reverse();
        }
        mesh.push_polygon(&face);
    }
    mesh
}

/// Corners of cubes, and which of them are within the level.
struct Grid {
    origin: Vec3,
    /// Side of a cube [m].
    side: f64,
    /// Number of corners along each axis [-].
    counts: [usize; 3],
    is_inside: Vec<bool>,
}

impl Grid {
    fn over(shape: &Shape, level: f64, bounds: &Bounds, sides: Vec3) -> Self {
        let side = sides.max() / CUBES;
        // A cube and a half beyond on every side, so that what is inside has corners outside around it.
        let origin = bounds.min.add_scalar(-1.5 * side);
        let counts = [0, 1, 2].map(|axis: usize| (sides[axis] / side).ceil() as usize + 4);
        let mut grid = Self {
            origin,
            side,
            counts,
            is_inside: Vec::new(),
        };
        grid.is_inside = grid
            .corners()
            .map(|corner| shape.distance(grid.place(corner)) < level)
            .collect();
        grid
    }

    fn corners(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [x_count, y_count, z_count] = self.counts;
        (0..x_count)
            .flat_map(move |x| (0..y_count).flat_map(move |y| (0..z_count).map(move |z| [x, y, z])))
    }

    fn place(&self, corner: [usize; 3]) -> Vec3 {
        self.origin + Vec3::from(corner.map(|index| index as f64)) * self.side
    }

    fn is_inside(&self, [x, y, z]: [usize; 3]) -> bool {
        self.is_inside[(x * self.counts[1] + y) * self.counts[2] + z]
    }

    /// Each side of cubes that the surface cuts: its lower corner, its axis, and whether that corner is inside.
    fn cut_sides(&self) -> impl Iterator<Item = ([usize; 3], usize, bool)> {
        self.corners().flat_map(move |corner| {
            (0..3).filter_map(move |axis| {
                let mut next = corner;
                next[axis] += 1;
                let across = [(axis + 1) % 3, (axis + 2) % 3];
                let has_cubes_around = next[axis] < self.counts[axis]
                    && across
                        .iter()
                        .all(|&axis| corner[axis] > 0 && corner[axis] + 1 < self.counts[axis]);
                let is_inside = self.is_inside(corner);
                (has_cubes_around && is_inside != self.is_inside(next))
                    .then_some((corner, axis, is_inside))
            })
        })
    }

    /// The point of the surface nearest to the middle of a cube, named by its lowest corner.
    fn point_in(&self, shape: &Shape, level: f64, cube: [usize; 3]) -> Vec3 {
        let middle = self.place(cube).add_scalar(self.side / 2.0);
        (0..STEPS).fold(middle, |point, _| {
            let surface = shape.surface(point);
            point - (surface.distance - level) * surface.normal
        })
    }
}
