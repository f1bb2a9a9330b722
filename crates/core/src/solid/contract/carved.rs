//! Solids with edges, held against points tried one by one.

use super::{assert_felt, cuboid, felt};
use crate::{Profile, Shape, Solid, Vec3};
use nalgebra::{UnitQuaternion, UnitVector3};

type Row = (&'static str, Shape);

/// Shapes with edges of many kinds, all within 1 of the origin.
fn shapes() -> Vec<Row> {
    [blocks(), hollows()].concat()
}

fn ball(radius: f64) -> Shape {
    Shape::Sphere { radius }
}

fn block() -> Shape {
    cuboid([-0.5, -0.4, -0.3], [0.5, 0.4, 0.3])
}

fn pipe(radius: f64) -> Shape {
    Shape::Cylinder {
        radius,
        half_length: 1.0,
    }
}

fn tilt() -> UnitQuaternion<f64> {
    UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1)
}

fn less(of: Shape, minus: Shape) -> Shape {
    Shape::Difference {
        of: Box::new(of),
        minus: Box::new(minus),
    }
}

fn common(of: Vec<Shape>) -> Shape {
    Shape::Intersection { of }
}

fn blocks() -> Vec<Row> {
    vec![
        (
            "lens",
            common(vec![
                ball(0.6).translated(Vec3::new(0.0, 0.0, -0.3)),
                ball(0.6).translated(Vec3::new(0.0, 0.1, 0.3)),
            ]),
        ),
        ("block cut to a ball", common(vec![block(), ball(0.55)])),
        ("two blocks", common(vec![block(), block().rotated(tilt())])),
        ("block with a round hole", less(block(), pipe(0.2))),
        (
            "block with a tilted hole",
            less(block(), pipe(0.15).rotated(tilt())),
        ),
        (
            "block with a slot",
            less(block(), cuboid([-0.6, -0.1, -0.4], [0.6, 0.1, 0.05])),
        ),
        (
            "block with a dent",
            less(block(), ball(0.3).translated(Vec3::new(0.0, 0.0, 0.4))),
        ),
    ]
}

fn hollows() -> Vec<Row> {
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
                    of: Box::new(less(block().rotated(tilt()), pipe(0.2))),
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
    for (name, shape) in shapes() {
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
