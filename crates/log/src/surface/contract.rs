//! What the triangles of every shape promise.

use super::Mesh;
use pelletflow_core::shape::Profile;
use pelletflow_core::{Bounds, Shape, UnitQuaternion, UnitVector3, Vec3};
use std::f64::consts::PI;

const CLIP: Bounds = Bounds {
    min: Vec3::new(-2.0, -2.0, -2.0),
    max: Vec3::new(2.0, 2.0, 2.0),
};

fn cylinder(radius: f64, half_length: f64) -> Shape {
    Shape::Cylinder {
        radius,
        half_length,
    }
}

fn cuboid() -> Shape {
    Shape::Cuboid {
        half_sides: Vec3::new(0.3, 0.4, 0.5),
    }
}

fn cone() -> Shape {
    Shape::Cone {
        lower_radius: 0.2,
        upper_radius: 0.8,
        half_length: 0.5,
    }
}

/// A name, a shape and its volume [m³].
type Row = (&'static str, Shape, f64);

fn registry() -> Vec<Row> {
    [built(), changed()].concat()
}

/// Shapes changed as a whole.
fn changed() -> Vec<Row> {
    vec![
        (
            "mirrored cone",
            Shape::Mirrored {
                point: Vec3::new(0.2, 0.0, 0.0),
                normal: UnitVector3::new_normalize(Vec3::new(1.0, 2.0, 0.5)),
                of: Box::new(cone()),
            },
            PI / 3.0 * (0.04 + 0.16 + 0.64),
        ),
        (
            "scaled cone",
            Shape::Scaled {
                by: 0.5,
                of: Box::new(cone()),
            },
            PI / 24.0 * (0.04 + 0.16 + 0.64),
        ),
        (
            "hollow box",
            Shape::Shell {
                thickness: 0.1,
                of: Box::new(cuboid()),
            },
            0.48 - 0.4 * 0.6 * 0.8,
        ),
        (
            "grown box",
            Shape::Offset {
                by: 0.2,
                of: Box::new(cuboid()),
            },
            // Steiner's formula: body, faces, quarters of cylinders along the edges, and a ball.
            0.48 + 0.2 * 3.76 + PI * 0.04 / 4.0 * 9.6 + 4.0 / 3.0 * PI * 0.008,
        ),
    ]
}

/// Primitives, placed and put together.
fn built() -> Vec<Row> {
    let half_space = Shape::HalfSpace {
        point: Vec3::zeros(),
        normal: Vec3::z_axis(),
    };
    vec![
        ("box", cuboid(), 0.48),
        ("sphere", Shape::Sphere { radius: 0.5 }, PI / 6.0),
        ("cylinder", cylinder(0.5, 1.0), 0.5 * PI),
        ("cone", cone(), PI / 3.0 * (0.04 + 0.16 + 0.64)),
        (
            "torus",
            Shape::Torus {
                ring_radius: 0.7,
                tube_radius: 0.2,
            },
            2.0 * PI * PI * 0.7 * 0.04,
        ),
        (
            "capsule",
            Shape::Capsule {
                radius: 0.3,
                half_length: 0.5,
            },
            PI * 0.09 * (1.0 + 0.4),
        ),
        (
            "ellipsoid",
            Shape::Ellipsoid {
                half_axes: Vec3::new(0.2, 0.5, 0.3),
            },
            4.0 / 3.0 * PI * 0.03,
        ),
        (
            "ring with clockwise corners",
            Shape::Revolution {
                profile: Profile::Closed {
                    corners: vec![[0.5, -0.1], [0.5, 0.1], [0.7, 0.1], [0.7, -0.1]],
                },
            },
            0.2 * PI * (0.49 - 0.25),
        ),
        (
            "straight plate",
            Shape::Revolution {
                profile: Profile::Plate {
                    corners: vec![[0.5, -0.5], [0.5, 0.5]],
                    thickness: 0.02,
                },
            },
            2.0 * PI * 0.5 * (0.02 + PI * 1.0e-4),
        ),
        (
            "moved and turned box",
            cuboid()
                .rotated(UnitQuaternion::from_euler_angles(0.3, -0.8, 1.1))
                .translated(Vec3::new(0.4, 0.2, -0.3)),
            0.48,
        ),
        (
            "union",
            Shape::Union {
                of: vec![
                    Shape::Sphere { radius: 0.3 },
                    Shape::Sphere { radius: 0.3 }.translated(Vec3::x()),
                ],
            },
            2.0 * 4.0 / 3.0 * PI * 0.027,
        ),
        (
            "pipe",
            Shape::Difference {
                of: Box::new(cylinder(0.5, 0.8)),
                minus: Box::new(cylinder(0.45, 2.0)),
            },
            1.6 * PI * (0.25 - 0.2025),
        ),
        (
            "half ball",
            Shape::Intersection {
                of: vec![Shape::Sphere { radius: 0.5 }, half_space.clone()],
            },
            PI / 12.0,
        ),
        (
            "thin plate with a hole",
            Shape::Difference {
                of: Box::new(Shape::Cuboid {
                    half_sides: Vec3::new(0.5, 0.5, 0.001),
                }),
                minus: Box::new(cylinder(0.2, 1.0)),
            },
            0.002 * (1.0 - 0.04 * PI),
        ),
    ]
}

/// Volume within a closed surface, from the divergence theorem [m³].
fn volume(mesh: &Mesh) -> f64 {
    mesh.triangles
        .iter()
        .map(|[a, b, c]| a.dot(&b.cross(c)) / 6.0)
        .sum()
}

#[test]
fn every_surface_is_closed_faces_out_and_holds_the_volume() {
    for (name, shape, exact) in registry() {
        let found = volume(&Mesh::of(&shape, &CLIP));
        // Chords of 64 sides lose 0.16 % of a circle's area; thin rings lose it on both sides.
        assert!(
            (found / exact - 1.0).abs() < 0.01,
            "{name}: {found} for {exact}"
        );
    }
}

#[test]
fn every_corner_of_a_triangle_lies_on_the_surface() {
    for (name, shape, _) in registry() {
        for corner in Mesh::of(&shape, &CLIP).triangles.iter().flatten() {
            let distance = shape.distance(*corner);
            // A cut through a chord is as far off as the chord: r (1 − cos(π/64)) for the largest r of 0.8.
            assert!(distance.abs() < 1.0e-3, "{name}: {distance} at {corner}");
        }
    }
}

#[test]
fn every_sharp_edge_lies_on_the_surface() {
    for (name, shape, _) in registry() {
        for end in Mesh::of(&shape, &CLIP).edges.iter().flatten() {
            let distance = shape.distance(*end);
            assert!(distance.abs() < 1.0e-3, "{name}: {distance} at {end}");
        }
    }
}

#[test]
fn a_half_space_is_a_rectangle_over_the_bounds() {
    let floor = Shape::HalfSpace {
        point: Vec3::new(0.0, 0.0, -2.0),
        normal: Vec3::z_axis(),
    };
    let mesh = Mesh::of(&floor, &CLIP);
    let bounds = mesh.bounds();
    let area: f64 = mesh
        .triangles
        .iter()
        .map(|[a, b, c]| (b - a).cross(&(c - a)).z / 2.0)
        .sum();
    assert!((area - 16.0).abs() < 1.0e-3, "area {area}");
    assert!((bounds.min - Vec3::new(-2.0, -2.0, -2.0)).norm() < 1.0e-4);
    assert_eq!(mesh.edges.len(), 4);
}

#[test]
fn a_half_space_that_misses_the_bounds_shows_nothing() {
    let far = Shape::HalfSpace {
        point: Vec3::new(0.0, 0.0, -3.0),
        normal: UnitVector3::new_normalize(Vec3::z()),
    };
    assert_eq!(Mesh::of(&far, &CLIP), Mesh::default());
}

#[test]
fn a_box_has_twelve_edges_and_a_ball_none() {
    let cuboid = Shape::Cuboid {
        half_sides: Vec3::new(1.0, 1.0, 1.0),
    };
    assert_eq!(Mesh::of(&cuboid, &CLIP).edges.len(), 12);
    assert!(
        Mesh::of(&Shape::Sphere { radius: 1.0 }, &CLIP)
            .edges
            .is_empty()
    );
}

#[test]
fn a_face_shared_by_a_body_and_its_hole_is_open() {
    // A pipe whose hole is exactly as long: no lid may stay at its ends.
    let pipe = Shape::Difference {
        of: Box::new(cylinder(0.5, 0.8)),
        minus: Box::new(cylinder(0.4, 0.8)),
    };
    for [a, b, c] in Mesh::of(&pipe, &CLIP).triangles {
        let center = (a + b + c) / 3.0;
        // The chords of the inner circle lie up to 0.5 mm within it.
        assert!(center.x.hypot(center.y) > 0.399, "a lid at {center}");
    }
}

#[test]
fn each_corner_is_listed_once() {
    let (corners, indices) = Mesh::of(&cylinder(0.5, 1.0), &CLIP).indexed();
    // Two rings of 64 and the two centers.
    assert_eq!(corners.len(), 130);
    assert_eq!(indices.len(), 3 * 256);
}
