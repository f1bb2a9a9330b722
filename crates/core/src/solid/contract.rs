//! What touches promise.

use super::Solid;
use crate::{Profile, Shape, Vec3};
use nalgebra::{UnitQuaternion, UnitVector3};

fn cuboid(min: [f64; 3], max: [f64; 3]) -> Shape {
    let (min, max) = (Vec3::from(min), Vec3::from(max));
    Shape::Cuboid {
        half_sides: (max - min) / 2.0,
    }
    .translated((min + max) / 2.0)
}

/// Distances and normals of all touches.
fn felt(shape: &Shape, center: [f64; 3], reach: f64) -> Vec<(f64, Vec3)> {
    Solid::new(shape)
        .touches(Vec3::from(center), reach)
        .as_slice()
        .iter()
        .map(|touch| (touch.distance, touch.normal))
        .collect()
}

fn assert_felt(shape: &Shape, center: [f64; 3], reach: f64, expected: &[(f64, [f64; 3])]) {
    let felt = felt(shape, center, reach);
    assert_eq!(felt.len(), expected.len(), "{felt:?}");
    for ((distance, normal), (expected_distance, expected_normal)) in felt.iter().zip(expected) {
        // A few roundings of lengths of order 1.
        assert!((distance - expected_distance).abs() < 1.0e-12, "{felt:?}");
        // Where an edge is as near as a face by rounding, it leans by the root of that.
        assert!(
            (normal - Vec3::from(*expected_normal)).norm() < 1.0e-7,
            "{felt:?}"
        );
    }
}

#[test]
fn a_ball_in_the_corner_of_a_union_touches_both_parts() {
    let corner = Shape::Union {
        of: vec![
            cuboid([-1.0, -1.0, -0.1], [1.0, 1.0, 0.0]),
            cuboid([0.9, -1.0, -0.1], [1.0, 1.0, 1.0]),
        ],
    };
    assert_felt(
        &corner,
        [0.81, 0.0, 0.095],
        0.1,
        &[(0.09, [-1.0, 0.0, 0.0]), (0.095, [0.0, 0.0, 1.0])],
    );
    // Away from the corner, one.
    assert_felt(&corner, [0.5, 0.0, 0.095], 0.1, &[(0.095, [0.0, 0.0, 1.0])]);
}

#[test]
fn the_seam_of_flush_parts_is_not_felt() {
    let floor = Shape::Union {
        of: vec![
            cuboid([-1.0, -1.0, -0.1], [0.0, 1.0, 0.0]),
            cuboid([0.0, -1.0, -0.1], [1.0, 1.0, 0.0]),
        ],
    };
    for x in [-0.2, -0.05, -1.0e-3, -1.0e-6, 0.0, 1.0e-9, 0.02, 0.09] {
        assert_felt(&floor, [x, 0.3, 0.08], 0.1, &[(0.08, [0.0, 0.0, 1.0])]);
    }
}

#[test]
fn a_part_inside_another_is_not_felt() {
    let shape = Shape::Union {
        of: vec![
            Shape::Sphere { radius: 0.5 },
            cuboid([-0.6, -0.6, -0.6], [0.6, 0.6, 0.0]),
            cuboid([-0.2, -0.2, -0.2], [0.2, 0.2, 0.2]),
        ],
    };
    assert_felt(&shape, [0.0, 0.0, 0.55], 0.1, &[(0.05, [0.0, 0.0, 1.0])]);
}

#[test]
fn a_ball_where_a_cone_meets_its_bin_touches_both() {
    let bin = |profile| Shape::Revolution { profile };
    let plate = bin(Profile::Plate {
        corners: vec![[0.1, 0.0], [0.5, 0.4], [0.5, 1.0]],
        thickness: 0.02,
    });
    let closed = bin(Profile::Closed {
        corners: vec![
            [0.1, 0.0],
            [0.5, 0.4],
            [0.5, 1.0],
            [0.6, 1.0],
            [0.6, 0.3],
            [0.2, -0.1],
        ],
    });
    let slope = 0.5_f64.sqrt();
    // At 0.07 from the bin and 0.065 from the cone.
    let z = 0.4 - 0.07 + 0.065 * 2.0 * slope;
    let expected = [(0.065, [-slope, 0.0, slope]), (0.07, [-1.0, 0.0, 0.0])];
    assert_felt(&closed, [0.43, 0.0, z], 0.08, &expected);
    let nearer = expected.map(|(distance, normal)| (distance - 0.01, normal));
    assert_felt(&plate, [0.43, 0.0, z], 0.08, &nearer);
    // On the far side of the plate the same corner juts out.
    let outside = felt(&plate, [0.56, 0.0, 0.37], 0.08);
    assert_eq!(outside.len(), 1);
}

#[test]
fn a_lone_shape_is_touched_where_its_distance_says() {
    let shapes = [
        Shape::Sphere { radius: 0.4 },
        cuboid([-0.3, -0.2, -0.5], [0.3, 0.2, 0.5]),
        Shape::Revolution {
            profile: Profile::Closed {
                corners: vec![[0.0, -0.3], [0.4, -0.3], [0.2, 0.3], [0.0, 0.3]],
            },
        },
    ];
    for shape in &shapes {
        let solid = Solid::new(shape);
        for index in 0..2000 {
            let fraction = |ratio: f64| (0.5 + ratio * f64::from(index)).fract() * 2.0 - 1.0;
            let center = Vec3::new(fraction(0.8192), fraction(0.6710), fraction(0.5497));
            let surface = shape.surface(center);
            let touches = solid.touches(center, 0.3);
            match touches.as_slice() {
                [] => assert!(surface.distance >= 0.3, "{shape:?} at {center:?}"),
                [nearest, ..] => {
                    assert!((nearest.distance - surface.distance).abs() < 1.0e-12);
                    assert!((nearest.normal - surface.normal).norm() < 1.0e-9);
                }
            }
        }
    }
}

#[test]
fn grown_parts_that_meet_are_touched_where_they_are_bare() {
    let corner = Shape::Offset {
        by: 0.05,
        of: Box::new(Shape::Union {
            of: vec![
                cuboid([-1.0, -1.0, -0.1], [1.0, 1.0, 0.0]),
                cuboid([0.9, -1.0, -0.1], [1.0, 1.0, 1.0]),
            ],
        }),
    };
    assert_felt(
        &corner,
        [0.76, 0.0, 0.145],
        0.1,
        &[(0.09, [-1.0, 0.0, 0.0]), (0.095, [0.0, 0.0, 1.0])],
    );
}

/// Shapes with edges of many kinds, all within 1 of the origin.
fn carved_shapes() -> Vec<(&'static str, Shape)> {
    let ball = |radius| Shape::Sphere { radius };
    let block = || cuboid([-0.5, -0.4, -0.3], [0.5, 0.4, 0.3]);
    let tilt = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
    let less = |of: Shape, minus: Shape| Shape::Difference {
        of: Box::new(of),
        minus: Box::new(minus),
    };
    let common = |of| Shape::Intersection { of };
    let pipe = |radius| Shape::Cylinder {
        radius,
        half_length: 1.0,
    };
    let hopper = Shape::Revolution {
        profile: Profile::Closed {
            corners: vec![
                [0.2, -0.5],
                [0.6, 0.0],
                [0.6, 0.5],
                [0.7, 0.5],
                [0.7, -0.05],
                [0.3, -0.55],
            ],
        },
    };
    vec![
        (
            "lens",
            common(vec![
                ball(0.6).translated(Vec3::new(0.0, 0.0, -0.3)),
                ball(0.6).translated(Vec3::new(0.0, 0.1, 0.3)),
            ]),
        ),
        ("block cut to a ball", common(vec![block(), ball(0.55)])),
        ("two blocks", common(vec![block(), block().rotated(tilt)])),
        ("block with a round hole", less(block(), pipe(0.2))),
        (
            "block with a tilted hole",
            less(block(), pipe(0.15).rotated(tilt)),
        ),
        (
            "block with a slot",
            less(block(), cuboid([-0.6, -0.1, -0.4], [0.6, 0.1, 0.05])),
        ),
        (
            "block with a dent",
            less(block(), ball(0.3).translated(Vec3::new(0.0, 0.0, 0.4))),
        ),
        (
            "trough",
            less(
                pipe(0.5),
                Shape::Union {
                    of: vec![
                        pipe(0.4).translated(Vec3::new(0.0, 0.0, 0.1)),
                        cuboid([-1.0, 0.1, -2.0], [1.0, 1.0, 2.0]),
                    ],
                },
            ),
        ),
        (
            "hopper with a window",
            less(hopper.clone(), cuboid([0.0, -0.15, -0.2], [1.0, 0.15, 0.3])),
        ),
        (
            "half a hopper",
            common(vec![
                hopper,
                Shape::HalfSpace {
                    point: Vec3::zeros(),
                    normal: UnitVector3::new_normalize(Vec3::new(0.2, 1.0, 0.1)),
                },
            ]),
        ),
        (
            "three balls",
            common(vec![
                ball(0.6).translated(Vec3::new(0.25, 0.0, 0.0)),
                ball(0.6).translated(Vec3::new(-0.2, 0.25, 0.0)),
                ball(0.6).translated(Vec3::new(0.0, -0.2, 0.3)),
            ]),
        ),
        (
            "open box",
            less(block(), cuboid([-0.45, -0.35, -0.25], [0.45, 0.35, 0.5])),
        ),
        (
            "hollow block",
            Shape::Shell {
                thickness: 0.1,
                of: Box::new(block()),
            },
        ),
        (
            "hollow cone",
            Shape::Shell {
                thickness: 0.06,
                of: Box::new(Shape::Cone {
                    lower_radius: 0.2,
                    upper_radius: 0.6,
                    half_length: 0.4,
                }),
            },
        ),
        (
            "small mirror image",
            Shape::Scaled {
                by: 0.7,
                of: Box::new(Shape::Mirrored {
                    point: Vec3::new(0.1, 0.0, 0.0),
                    normal: UnitVector3::new_normalize(Vec3::new(1.0, 1.0, 0.0)),
                    of: Box::new(less(block().rotated(tilt), pipe(0.2))),
                }),
            },
        ),
    ]
}

/// Points spread evenly and without a pattern over a cube of half side 1.
fn points(count: u32) -> impl Iterator<Item = Vec3> {
    (1..=count).map(|index| {
        let fraction = |ratio: f64| (0.5 + ratio * f64::from(index)).fract() * 2.0 - 1.0;
        Vec3::new(
            fraction(0.819_172_513_396_164_4),
            fraction(0.671_043_606_703_789_2),
            fraction(0.549_700_477_901_970_2),
        )
    })
}

#[test]
fn the_nearest_touch_of_a_solid_with_edges_is_at_its_true_distance() {
    let ways: Vec<Vec3> = points(500).map(|way| way.normalize()).collect();
    for (name, shape) in carved_shapes() {
        let solid = Solid::new(&shape);
        let mut at_edges = 0;
        for (center, reach) in points(2400).zip([0.03, 0.1, 0.3, 0.6].into_iter().cycle()) {
            let field = shape.distance(center);
            if field <= 0.0 || field >= reach {
                continue;
            }
            let touches = solid.touches(center, reach);
            let nearest = touches.as_slice().first().copied();
            // What is touched is on the solid: the shape's own distance is exact there.
            for touch in touches.as_slice() {
                let foot = center - touch.distance * touch.normal;
                assert!(
                    shape.distance(foot).abs() < 1.0e-9,
                    "{name} at {center:?}: {touch:?}"
                );
            }
            // Nothing of the solid is nearer, and of what is out of reach nothing is within reach.
            let distance = nearest.map_or(reach, |touch| touch.distance);
            assert!(distance >= field - 1.0e-12, "{name} at {center:?}");
            for way in &ways {
                let point = center + 0.999 * distance * way;
                assert!(
                    shape.distance(point) > 0.0,
                    "{name} at {center:?}: {point:?} is nearer than {distance}"
                );
            }
            if nearest.is_some_and(|touch| touch.principal_curvatures[0].is_infinite()) {
                at_edges += 1;
            }
        }
        assert!(at_edges > 20, "{name}: {at_edges} touches at edges");
    }
}

#[test]
fn a_lip_cut_into_a_plate_is_felt_where_it_is() {
    // A plate with a round hole: the lip is a circle of radius 0.2 at z = 0.
    let plate = Shape::Difference {
        of: Box::new(cuboid([-1.0, -1.0, -0.1], [1.0, 1.0, 0.0])),
        minus: Box::new(Shape::Cylinder {
            radius: 0.2,
            half_length: 0.5,
        }),
    };
    for (inward, above) in [(0.03, 0.04), (0.05, 0.0001), (0.0001, 0.05), (0.06, 0.07)] {
        let distance = f64::hypot(inward, above);
        let (cos, sin) = (0.6, 0.8);
        let center = [cos * (0.2 - inward), sin * (0.2 - inward), above];
        let normal = [
            -cos * inward / distance,
            -sin * inward / distance,
            above / distance,
        ];
        assert_felt(&plate, center, 0.1, &[(distance, normal)]);
    }
    // A ball that has just cleared the lip feels nothing.
    assert!(felt(&plate, [0.13, 0.0, 0.0725], 0.1).is_empty());
}

#[test]
fn a_ball_in_the_corner_of_an_open_box_touches_three_faces() {
    let open_box = Shape::Difference {
        of: Box::new(cuboid([-0.6, -0.6, -0.6], [0.6, 0.6, 0.5])),
        minus: Box::new(cuboid([-0.5, -0.5, -0.5], [0.5, 0.5, 0.6])),
    };
    let expected = [
        (0.07, [1.0, 0.0, 0.0]),
        (0.08, [0.0, -1.0, 0.0]),
        (0.09, [0.0, 0.0, 1.0]),
    ];
    assert_felt(&open_box, [-0.43, 0.42, -0.41], 0.1, &expected);
    let hollow = Shape::Shell {
        thickness: 0.1,
        of: Box::new(cuboid([-0.6, -0.6, -0.6], [0.6, 0.6, 0.6])),
    };
    assert_felt(&hollow, [-0.43, 0.42, -0.41], 0.1, &expected);
}
