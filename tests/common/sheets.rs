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

/// A cone about the z axis, wide end up, open at both ends.
pub(crate) fn cone(sides: u32, lower: f64, upper: f64, height: f64) -> TriangleMesh {
    let vertices = rings(sides, lower, upper, height);
    TriangleMesh::new(vertices, slopes(sides)).expect("a cone is a mesh")
}

/// The same with a floor.
pub(crate) fn funnel(sides: u32, lower: f64, upper: f64, height: f64) -> TriangleMesh {
    let mut vertices = rings(sides, lower, upper, height);
    vertices.push(Vec3::zeros());
    let floor = (0..sides).map(|side| [2 * sides, (side + 1) % sides, side]);
    let triangles = slopes(sides).into_iter().chain(floor).collect();
    TriangleMesh::new(vertices, triangles).expect("a funnel is a mesh")
}

/// The lower and the upper end of a cone.
fn rings(sides: u32, lower: f64, upper: f64, height: f64) -> Vec<Vec3> {
    [(lower, 0.0), (upper, height)]
        .into_iter()
        .flat_map(|(radius, z)| {
            (0..sides).map(move |side| {
                let angle = TAU * f64::from(side) / f64::from(sides);
                Vec3::new(radius * angle.cos(), radius * angle.sin(), z)
            })
        })
        .collect()
}

/// The triangles between the two.
fn slopes(sides: u32) -> Vec<[u32; 3]> {
    (0..sides)
        .flat_map(|side| {
            let next = (side + 1) % sides;
            [
                [side, next, sides + next],
                [side, sides + next, sides + side],
            ]
        })
        .collect()
}
