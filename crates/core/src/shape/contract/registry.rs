//! The table that the contract tests loop over.

use crate::Vec3;
use crate::shape::{Profile, Shape};
use nalgebra::UnitQuaternion;

/// A name, a shape, and whether its distance is exact everywhere outside.
type Row = (&'static str, Shape, bool);

/// One of each shape.
pub(super) fn registry() -> Vec<Row> {
    [primitives(), combinations(), parallels(), placements()].concat()
}

fn primitives() -> Vec<Row> {
    let hopper = Profile::Closed {
        corners: vec![
            [0.3, -0.5],
            [0.8, 0.4],
            [0.8, 0.9],
            [0.9, 0.9],
            [0.9, 0.35],
            [0.4, -0.5],
        ],
    };
    let plate = Profile::Plate {
        corners: vec![[0.3, -0.5], [0.8, 0.4], [0.8, 0.9]],
        thickness: 0.1,
    };
    vec![
        (
            "half-space",
            Shape::HalfSpace {
                point: Vec3::new(0.1, 0.2, 0.3),
                normal: nalgebra::Unit::new_normalize(Vec3::new(1.0, -2.0, 0.5)),
            },
            true,
        ),
        ("sphere", ball(), true),
        ("cylinder", cylinder(), true),
        (
            "cone",
            Shape::Cone {
                lower_radius: 0.2,
                upper_radius: 0.8,
                half_length: 0.5,
            },
            true,
        ),
        ("pointed cone", pointed_cone(), true),
        ("torus", torus(), true),
        (
            "capsule",
            Shape::Capsule {
                radius: 0.4,
                half_length: 0.6,
            },
            true,
        ),
        ("ellipsoid", ellipsoid(0.9, 0.35, 0.6), true),
        ("disk-like ellipsoid", ellipsoid(0.8, 0.8, 0.2), true),
        ("needle-like ellipsoid", ellipsoid(0.2, 0.2, 0.8), true),
        ("box", cuboid(), true),
        (
            "revolution, closed",
            Shape::Revolution { profile: hopper },
            true,
        ),
        (
            "revolution, plate",
            Shape::Revolution { profile: plate },
            true,
        ),
    ]
}

fn combinations() -> Vec<Row> {
    vec![
        (
            "union",
            Shape::Union {
                of: vec![ball().translated(Vec3::x()), cuboid()],
            },
            true,
        ),
        ("blend of planes", blend_of_planes(), true),
        (
            "blend of a box and a plane",
            Shape::Blend {
                radius: 0.3,
                of: vec![cuboid(), plane(Vec3::new(0.1, 0.2, 1.0))],
            },
            false,
        ),
        (
            "intersection",
            Shape::Intersection {
                of: vec![ball(), cuboid()],
            },
            false,
        ),
        (
            "difference",
            Shape::Difference {
                of: Box::new(cuboid()),
                minus: Box::new(ball()),
            },
            false,
        ),
    ]
}

fn parallels() -> Vec<Row> {
    let grown = |of: Shape| Shape::Offset {
        by: 0.2,
        of: Box::new(of),
    };
    let hollow = |of: Shape| Shape::Shell {
        thickness: 0.1,
        of: Box::new(of),
    };
    let acute = Shape::Intersection {
        of: vec![cuboid(), cuboid().rotated(turn())],
    };
    vec![
        ("offset of a box", grown(cuboid()), true),
        ("offset of a pointed cone", grown(pointed_cone()), true),
        ("offset of a torus", grown(torus()), true),
        ("offset of an intersection", grown(acute), false),
        ("shell of a box", hollow(cuboid()), true),
        ("shell of a cylinder", hollow(cylinder()), true),
        ("shell of a torus", hollow(torus()), true),
        (
            "shell of an ellipsoid",
            hollow(ellipsoid(0.9, 0.35, 0.6)),
            true,
        ),
    ]
}

fn placements() -> Vec<Row> {
    vec![
        (
            "translated",
            cylinder().translated(Vec3::new(0.2, -0.3, 0.1)),
            true,
        ),
        ("rotated", cuboid().rotated(turn()), true),
        (
            "rotated and translated",
            cylinder().rotated(turn()).translated(Vec3::y()),
            true,
        ),
        (
            "mirrored",
            Shape::Mirrored {
                point: Vec3::new(0.2, 0.1, 0.0),
                normal: nalgebra::Unit::new_normalize(Vec3::new(1.0, 0.5, -0.3)),
                of: Box::new(cylinder().rotated(turn())),
            },
            true,
        ),
        (
            "scaled",
            Shape::Scaled {
                by: 1.7,
                of: Box::new(torus()),
            },
            true,
        ),
    ]
}

fn plane(normal: Vec3) -> Shape {
    Shape::HalfSpace {
        point: Vec3::new(0.1, 0.0, -0.2),
        normal: nalgebra::Unit::new_normalize(normal),
    }
}

fn blend_of_planes() -> Shape {
    Shape::Blend {
        radius: 0.5,
        of: vec![
            plane(Vec3::new(1.0, 0.3, 0.0)),
            plane(Vec3::new(-0.2, 0.2, 1.0)),
        ],
    }
}

fn turn() -> UnitQuaternion<f64> {
    UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1)
}

fn ball() -> Shape {
    Shape::Sphere { radius: 0.6 }
}

fn cuboid() -> Shape {
    Shape::Cuboid {
        half_sides: Vec3::new(0.5, 0.7, 0.3),
    }
}

fn ellipsoid(x: f64, y: f64, z: f64) -> Shape {
    Shape::Ellipsoid {
        half_axes: Vec3::new(x, y, z),
    }
}

fn cylinder() -> Shape {
    Shape::Cylinder {
        radius: 0.4,
        half_length: 0.8,
    }
}

fn torus() -> Shape {
    Shape::Torus {
        ring_radius: 0.7,
        tube_radius: 0.3,
    }
}

fn pointed_cone() -> Shape {
    Shape::Cone {
        lower_radius: 0.0,
        upper_radius: 0.8,
        half_length: 0.5,
    }
}
