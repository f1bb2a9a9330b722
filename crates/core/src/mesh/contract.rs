//! What meshes promise: a ball feels the surface, and not how it is cut.

use super::{MeshError, TriangleMesh};
use crate::{Surface, UnitQuaternion, Vec3};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Rounding of lengths of order 1 [m].
const ROUNDING: f64 = 1.0e-14;

/// A square about the origin of a plane, cut into cells of two triangles each, turned.
fn sheet(side: f64, cells: u32, turn: UnitQuaternion<f64>) -> TriangleMesh {
    let row = cells + 1;
    let at = |index: u32| side * (f64::from(index) / f64::from(cells) - 0.5);
    let vertices = (0..row * row)
        .map(|index| turn * Vec3::new(at(index % row), at(index / row), 0.0))
        .collect();
    let cell = |index: u32| {
        let first = index / cells * row + index % cells;
        // The diagonals alternate, so that corners of four and of eight triangles occur.
        if (index / cells + index % cells).is_multiple_of(2) {
            [
                [first, first + 1, first + row + 1],
                [first, first + row + 1, first + row],
            ]
        } else {
            [
                [first, first + 1, first + row],
                [first + 1, first + row + 1, first + row],
            ]
        }
    };
    let triangles = (0..cells * cells).flat_map(cell).collect();
    TriangleMesh::new(vertices, triangles).expect("a sheet is a mesh")
}

/// The faces of a box from its lowest to its highest corner.
fn cuboid(min: Vec3, max: Vec3) -> TriangleMesh {
    let vertices = (0..8)
        .map(|corner| {
            let side = |axis: usize| {
                if corner >> axis & 1 == 0 {
                    min[axis]
                } else {
                    max[axis]
                }
            };
            Vec3::new(side(0), side(1), side(2))
        })
        .collect();
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles = faces
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .collect();
    TriangleMesh::new(vertices, triangles).expect("a box is a mesh")
}

/// The mantle of a frustum about the z axis.
fn mantle(sides: u32, lower: f64, upper: f64, height: f64) -> TriangleMesh {
    let ring = |radius: f64, z: f64| {
        (0..sides).map(move |side| {
            let angle = TAU * f64::from(side) / f64::from(sides);
            Vec3::new(radius * angle.cos(), radius * angle.sin(), z)
        })
    };
    let vertices = ring(lower, 0.0).chain(ring(upper, height)).collect();
    let triangles = (0..sides)
        .flat_map(|side| {
            let next = (side + 1) % sides;
            [
                [side, next, sides + next],
                [side, sides + next, sides + side],
            ]
        })
        .collect();
    TriangleMesh::new(vertices, triangles).expect("a mantle is a mesh")
}

fn felt(mesh: &TriangleMesh, center: Vec3, reach: f64) -> Vec<Surface> {
    let all: Vec<u32> = (0..mesh.indices().len() as u32).collect();
    mesh.touches(&all, center, reach).as_slice().to_vec()
}

fn turned() -> UnitQuaternion<f64> {
    UnitQuaternion::from_euler_angles(0.7, -0.4, 1.1)
}

#[test]
fn a_plane_is_felt_as_a_plane_over_faces_edges_and_corners_however_finely_it_is_cut() {
    for turn in [UnitQuaternion::identity(), turned()] {
        for cells in [2, 10, 100] {
            let mesh = sheet(2.0, cells, turn);
            let cell = 2.0 / f64::from(cells);
            let corner = Vec3::new(0.0, 0.0, 0.0);
            let places = [
                corner,
                Vec3::new(0.3, 0.7, 0.0) * cell,
                Vec3::new(0.5, 0.0, 0.0) * cell,
                Vec3::new(0.5, 0.5, 0.0) * cell,
                Vec3::new(1.0e-9, 0.3, 0.0) * cell,
                Vec3::new(1.0e-5, -1.0e-12, 0.0) * cell,
            ];
            for place in places {
                for (height, side) in [(0.095, 1.0), (0.095, -1.0), (0.02, 1.0)] {
                    let center = turn * (place + side * height * Vec3::z());
                    let found = felt(&mesh, center, 0.1);
                    assert_eq!(found.len(), 1, "{cells} cells, {place:?}: {found:?}");
                    assert!((found[0].distance - height).abs() < ROUNDING, "{found:?}");
                    let normal = turn * (side * Vec3::z());
                    // Over an edge the way to the foot leans by the root of what rounding hides.
                    assert!((found[0].normal - normal).norm() < 1.0e-7, "{found:?}");
                    assert_eq!(found[0].mean_curvature(), 0.0);
                }
            }
        }
    }
}

#[test]
fn corners_on_the_side_of_a_neighbor_and_the_rounding_of_a_file_are_not_felt() {
    let mut vertices = Vec::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    // Two sheets side by side, cut differently, in single precision and far from the origin.
    for (side, cells) in [(-1.0, 7), (1.0, 10)] {
        let part = sheet(1.0, cells, UnitQuaternion::identity());
        let first = vertices.len() as u32;
        triangles.extend(
            part.indices()
                .iter()
                .map(|corners| corners.map(|corner| first + corner)),
        );
        let place =
            |at: &Vec3| turned() * (at + 0.5 * side * Vec3::x()) + Vec3::new(9.0, -7.0, 5.0);
        let rounded = |at: Vec3| at.map(|value| f64::from(value as f32));
        vertices.extend(part.vertices().iter().map(place).map(rounded));
    }
    let mesh = TriangleMesh::new(vertices, triangles).expect("two sheets are a mesh");
    for step in 0..500_u32 {
        let along = |share: f64| (f64::from(step) * share).fract() - 0.5;
        let place = Vec3::new(0.3 * along(0.819_172), 0.8 * along(0.671_043), 0.08);
        let center = turned() * place + Vec3::new(9.0, -7.0, 5.0);
        let found = felt(&mesh, center, 0.1);
        assert_eq!(found.len(), 1, "{place:?}: {found:?}");
        // Single precision of 10 m.
        assert!((found[0].distance - 0.08).abs() < 1.0e-6, "{found:?}");
    }
}

#[test]
fn the_inside_of_a_box_has_corners_of_three_faces_and_its_outside_corners_of_one_point() {
    let mesh = cuboid(Vec3::zeros(), Vec3::repeat(1.0));
    let inside = felt(&mesh, Vec3::new(0.08, 0.09, 0.07), 0.1);
    let distances: Vec<f64> = inside.iter().map(|touch| touch.distance).collect();
    assert_eq!(distances, [0.07, 0.08, 0.09]);
    assert_eq!(inside[0].normal, Vec3::z());
    let outside = felt(&mesh, Vec3::new(-0.05, -0.05, -0.05), 0.1);
    assert_eq!(outside.len(), 1);
    assert!((outside[0].distance - 0.05 * 3.0_f64.sqrt()).abs() < ROUNDING);
    assert_eq!(outside[0].principal_curvatures, [f64::INFINITY; 2]);
    let over_edge = felt(&mesh, Vec3::new(-0.03, -0.04, 0.4), 0.1);
    assert_eq!(over_edge.len(), 1);
    assert!((over_edge[0].distance - 0.05).abs() < ROUNDING);
    assert_eq!(over_edge[0].principal_curvatures, [f64::INFINITY, 0.0]);
}

#[test]
fn the_far_face_of_a_thin_plate_is_not_felt_through_the_near_one() {
    let plate = cuboid(Vec3::new(-1.0, -1.0, -0.002), Vec3::new(1.0, 1.0, 0.0));
    for place in [
        Vec3::new(0.3, 0.1, 0.0),
        Vec3::zeros(),
        Vec3::new(0.2, 0.2, 0.0),
    ] {
        let found = felt(&plate, place + 0.004 * Vec3::z(), 0.0075);
        let distances: Vec<f64> = found.iter().map(|touch| touch.distance).collect();
        assert_eq!(distances, [0.004]);
    }
}

#[test]
fn a_cone_of_480_sides_is_touched_once_and_where_the_cone_is() {
    let (lower, upper, height) = (0.1_f64, 0.5, 0.4);
    let mesh = mantle(480, lower, upper, height);
    let across = Vec3::new(height, 0.0, lower - upper).normalize();
    // A side lies within the cone by its sagitta, and a ball of 15 mm meets none other first.
    let sagitta = upper * (1.0 - (std::f64::consts::PI / 480.0).cos());
    for inward in [1.0, -1.0] {
        for step in 0..97 {
            let angle = f64::from(step) * 0.0137;
            let about = UnitQuaternion::from_axis_angle(&Vec3::z_axis(), angle);
            let foot = Vec3::new(0.3, 0.0, 0.2);
            let center = about * (foot - inward * 0.0073 * across);
            let found = felt(&mesh, center, 0.0075);
            assert_eq!(found.len(), 1, "{angle}: {found:?}");
            assert!((found[0].distance - 0.0073).abs() < sagitta, "{found:?}");
            let normal = about * (-inward * across);
            // It leans by less than the turn from one side to the next.
            assert!((found[0].normal - normal).norm() < TAU / 480.0, "{found:?}");
        }
    }
}

#[test]
fn a_list_that_is_no_mesh_is_refused() {
    let corners = || vec![Vec3::zeros(), Vec3::x(), Vec3::y(), 2.0 * Vec3::x()];
    let refused = |vertices, triangles| TriangleMesh::new(vertices, triangles).err();
    assert_eq!(
        refused(corners(), vec![]),
        Some(MeshError::Count { triangles: 0 })
    );
    let unknown = MeshError::UnknownVertex {
        triangle: 1,
        vertices: 4,
    };
    assert_eq!(
        refused(corners(), vec![[0, 1, 2], [0, 1, 4]]),
        Some(unknown)
    );
    let flat = refused(corners(), vec![[0, 1, 2], [0, 1, 3]]);
    assert!(matches!(
        flat,
        Some(MeshError::Degenerate { triangle: 1, .. })
    ));
    let mut far = corners();
    far[3].z = f64::NAN;
    let nowhere = refused(far, vec![[0, 1, 2]]);
    assert!(matches!(
        nowhere,
        Some(MeshError::NotFinite { vertex: 3, .. })
    ));
}

proptest! {
    #[test]
    fn the_nearest_touch_is_the_nearest_point_of_all_triangles(
        x in -0.7..0.7_f64, y in -0.7..0.7_f64, z in -0.7..0.7_f64,
    ) {
        let mesh = cuboid(Vec3::repeat(-0.5), Vec3::repeat(0.5));
        let center = Vec3::new(x, y, z);
        let nearest = mesh.triangles().map(|t| t.distance(center)).fold(f64::INFINITY, f64::min);
        let found = felt(&mesh, center, 0.3);
        match found.first() {
            Some(touch) => prop_assert!((touch.distance - nearest).abs() < ROUNDING),
            None => prop_assert!(nearest >= 0.3),
        }
    }
}
