//! Meshes to let a pellet fall onto.

use pelletflow::core::{TriangleMesh, Vec3};
use std::f64::consts::TAU;

/// A level square about the origin, cut into cells of two triangles each.
pub(crate) fn square(side: f64, cells: u32) -> TriangleMesh {
    let row = cells + 1;
    let at = |index: u32| side * (f64::from(index) / f64::from(cells) - 0.5);
    let vertices = (0..row * row)
        .map(|index| Vec3::new(at(index % row), at(index / row), 0.0))
        .collect();
    let triangles = (0..cells * cells)
        .map(|index| index / cells * row + index % cells)
        .flat_map(|first| {
            let across = first + row;
            [[first, first + 1, across + 1], [first, across + 1, across]]
        })
        .collect();
    TriangleMesh::new(vertices, triangles).expect("a square is a mesh")
}

/// A cone about the z axis, wide end up, and its floor.
pub(crate) fn funnel(sides: u32, lower: f64, upper: f64, height: f64) -> TriangleMesh {
    let ring = |radius: f64, z: f64| {
        (0..sides).map(move |side| {
            let angle = TAU * f64::from(side) / f64::from(sides);
            Vec3::new(radius * angle.cos(), radius * angle.sin(), z)
        })
    };
    let vertices = ring(lower, 0.0)
        .chain(ring(upper, height))
        .chain([Vec3::zeros()])
        .collect();
    let triangles = (0..sides)
        .flat_map(|side| {
            let next = (side + 1) % sides;
            [
                [side, next, sides + next],
                [side, sides + next, sides + side],
                [2 * sides, next, side],
            ]
        })
        .collect();
    TriangleMesh::new(vertices, triangles).expect("a funnel is a mesh")
}
