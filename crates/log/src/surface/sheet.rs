//! Meshes as they are, with the lines where they bend sharply or end.

use super::Mesh;
use pelletflow_core::{TriangleMesh, Vec3};
use std::collections::BTreeMap;

/// Cosine of the angle between two triangles from which their edge is drawn: 30 degrees [-].
const SHARP: f64 = 0.866;

/// Every triangle, and every edge that is sharp or does not lie between two.
pub(super) fn mesh(sheet: &TriangleMesh) -> Mesh {
    let mut beside: BTreeMap<[u32; 2], Vec<Vec3>> = BTreeMap::new();
    for (corners, triangle) in sheet.indices().iter().zip(sheet.triangles()) {
        let normal = triangle.area_vector().normalize();
        for side in 0..3 {
            let (from, to) = (corners[side], corners[(side + 1) % 3]);
            beside
                .entry([from.min(to), from.max(to)])
                .or_default()
                .push(if from < to { normal } else { -normal });
        }
    }
    let is_drawn = |normals: &[Vec3]| match normals {
        // Neighbors of one winding pass their edge in opposite ways.
        [a, b] => -a.dot(b) < SHARP,
        _ => true,
    };
    Mesh {
        triangles: sheet.triangles().map(|triangle| triangle.corners).collect(),
        edges: beside
            .iter()
            .filter(|(_, normals)| is_drawn(normals))
            .map(|(ends, _)| ends.map(|end| sheet.vertices()[end as usize]))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_open_box_is_drawn_with_its_edges_and_without_its_diagonals() {
        let vertices = (0..8)
            .map(|corner| {
                Vec3::new(
                    f64::from(corner & 1),
                    f64::from(corner >> 1 & 1),
                    f64::from(corner >> 2),
                )
            })
            .collect();
        let sides = [
            [0, 2, 3, 1],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let triangles = sides
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect();
        let drawn = mesh(&TriangleMesh::new(vertices, triangles).expect("a box is a mesh"));
        assert_eq!(drawn.triangles.len(), 10);
        assert_eq!(drawn.edges.len(), 12);
        assert!(
            drawn
                .edges
                .iter()
                .all(|[from, to]| (to - from).norm() == 1.0)
        );
    }
}
