//! What touches promise.

mod carved;

use super::Solid;
use crate::{Profile, Shape, Vec3};

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
fn a_fillet_is_felt_by_what_fits_in_and_its_faces_by_what_does_not() {
    let corner = Shape::Blend {
        radius: 0.1,
        of: vec![
            cuboid([-1.0, -1.0, -0.1], [1.0, 1.0, 0.0]),
            cuboid([0.9, -1.0, -0.1], [1.0, 1.0, 1.0]),
        ],
    };
    let diagonal = 0.5_f64.sqrt();
    // The center of the fillet is 0.1 from both; this is halfway between it and the fillet.
    let half = 0.05 * diagonal;
    let between = [0.8 + half, 0.0, 0.1 - half];
    assert_felt(
        &corner,
        between,
        0.06,
        &[(0.05, [-diagonal, 0.0, diagonal])],
    );
    assert_felt(
        &corner,
        [0.79, 0.0, 0.105],
        0.12,
        &[(0.105, [0.0, 0.0, 1.0]), (0.11, [-1.0, 0.0, 0.0])],
    );
    assert_felt(&corner, [0.5, 0.0, 0.05], 0.06, &[(0.05, [0.0, 0.0, 1.0])]);
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
