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

/// A box about the origin by half of its sides.
pub(crate) fn block(half: Vec3) -> TriangleMesh {
    let vertices = (0..8_u32)
        .map(|corner| {
            let sign = |axis: u32| f64::from(corner >> axis & 1) * 2.0 - 1.0;
            half.component_mul(&Vec3::new(sign(0), sign(1), sign(2)))
        })
        .collect();
    let triangles = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ]
    .iter()
    .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
    .collect();
    TriangleMesh::new(vertices, triangles).expect("a box is a mesh")
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

/// A sphere about the origin, cut along meridians and half as many parallels.
pub(crate) fn globe(radius: f64, sides: u32) -> TriangleMesh {
    let rows = sides / 2 - 1;
    let mut vertices = vec![-radius * Vec3::z(), radius * Vec3::z()];
    for row in 1..=rows {
        let (out, up) = (TAU / 2.0 * f64::from(row) / f64::from(rows + 1)).sin_cos();
        vertices.extend((0..sides).map(|side| {
            let angle = TAU * f64::from(side) / f64::from(sides);
            radius * Vec3::new(out * angle.cos(), out * angle.sin(), -up)
        }));
    }
    let at = |row: u32, side: u32| 2 + row * sides + side % sides;
    let caps = (0..sides).flat_map(|side| {
        [
            [0, at(0, side + 1), at(0, side)],
            [1, at(rows - 1, side), at(rows - 1, side + 1)],
        ]
    });
    let belts = (0..rows - 1).flat_map(|row| {
        (0..sides).flat_map(move |side| {
            let (a, b) = (at(row, side), at(row, side + 1));
            let (c, d) = (at(row + 1, side), at(row + 1, side + 1));
            [[a, b, d], [a, d, c]]
        })
    });
    TriangleMesh::new(vertices, caps.chain(belts).collect()).expect("a globe is a mesh")
}
