//! What every shape promises, for shapes put together at random.

use crate::Vec3;
use crate::shape::Shape;
use nalgebra::{UnitQuaternion, UnitVector3};
use proptest::collection::vec;
use proptest::prelude::*;

/// What rounding leaves of lengths of a few meters after some tens of operations [m].
const ROUNDING: f64 = 1.0e-9;
/// Half of the side of the cube about the origin in which points are taken [m].
const REACH: f64 = 4.0;

fn length() -> impl Strategy<Value = f64> {
    0.05..1.0_f64
}

fn vector(most: f64) -> impl Strategy<Value = Vec3> {
    [-most..most, -most..most, -most..most].prop_map(Vec3::from)
}

fn direction() -> impl Strategy<Value = UnitVector3<f64>> {
    vector(1.0)
        .prop_filter("it has a length", |vector| vector.norm() > 0.1)
        .prop_map(UnitVector3::new_normalize)
}

fn primitives() -> impl Strategy<Value = Shape> {
    let lengths = || [length(), length(), length()];
    prop_oneof![
        (vector(1.0), direction()).prop_map(|(point, normal)| Shape::HalfSpace { point, normal }),
        length().prop_map(|radius| Shape::Sphere { radius }),
        lengths().prop_map(|[radius, half_length, _]| Shape::Cylinder {
            radius,
            half_length
        }),
        lengths().prop_map(|[lower_radius, upper_radius, half_length]| Shape::Cone {
            lower_radius,
            upper_radius,
            half_length
        }),
        lengths().prop_map(|[ring, tube, _]| Shape::Torus {
            ring_radius: ring + tube,
            tube_radius: tube
        }),
        lengths().prop_map(|[radius, half_length, _]| Shape::Capsule {
            radius,
            half_length
        }),
        lengths().prop_map(|half_axes| Shape::Ellipsoid {
            half_axes: half_axes.into()
        }),
        lengths().prop_map(|half_sides| Shape::Cuboid {
            half_sides: half_sides.into()
        }),
    ]
}

/// Shapes of up to eight others; those that cannot be are left out.
fn shapes() -> impl Strategy<Value = Shape> {
    let shapes =
        primitives().prop_recursive(3, 8, 3, |part| {
            let parts = || vec(part.clone(), 1..4);
            let boxed = || part.clone().prop_map(Box::new);
            prop_oneof![
                parts().prop_map(|of| Shape::Union { of }),
                parts().prop_map(|of| Shape::Intersection { of }),
                (length(), parts()).prop_map(|(radius, of)| Shape::Blend { radius, of }),
                (boxed(), boxed()).prop_map(|(of, minus)| Shape::Difference { of, minus }),
                (vector(1.0), part.clone()).prop_map(|(by, of)| of.translated(by)),
                (direction(), 0.0..3.0_f64, part.clone())
                    .prop_map(|(axis, angle, of)| of
                        .rotated(UnitQuaternion::from_axis_angle(&axis, angle))),
                (vector(1.0), direction(), boxed())
                    .prop_map(|(point, normal, of)| Shape::Mirrored { point, normal, of }),
                (0.3..2.0_f64, boxed()).prop_map(|(by, of)| Shape::Scaled { by, of }),
                (0.01..0.3_f64, boxed()).prop_map(|(by, of)| Shape::Offset { by, of }),
                (0.01..0.3_f64, boxed()).prop_map(|(thickness, of)| Shape::Shell { thickness, of }),
            ]
        });
    shapes.prop_filter("it can be", |shape| shape.validate().is_ok())
}

proptest! {
    /// Outside, where the centers of pellets are; deep inside, fillets of parts that cross tell more than the depth.
    #[test]
    fn the_distance_of_any_shape_changes_no_faster_than_the_point_moves(
        shape in shapes(), points in vec(vector(REACH), 2..32), near in vector(1.0e-3),
    ) {
        let ways = points.windows(2).map(|pair| [pair[0], pair[1]]);
        let short = points.iter().map(|&point| [point, point + near]);
        for [from, to] in ways.chain(short) {
            let [before, after] = [from, to].map(|point| shape.distance(point));
            if before.min(after) >= 0.0 {
                let (change, way) = ((after - before).abs(), (to - from).norm());
                prop_assert!(change <= way + ROUNDING, "{change} m over {way} m from {from:?}");
            }
        }
    }

    #[test]
    fn every_normal_of_any_shape_is_a_direction_and_bounds_hold_the_solid(
        shape in shapes(), points in vec(vector(REACH), 32),
    ) {
        let bounds = shape.bounds().grown(ROUNDING);
        for point in points {
            let surface = shape.surface(point);
            prop_assert!(surface.distance.is_finite(), "{point:?}");
            prop_assert!((surface.normal.norm() - 1.0).abs() < ROUNDING, "{point:?}");
            prop_assert_eq!(surface.distance, shape.distance(point));
            prop_assert!(surface.distance > 0.0 || bounds.contains(point), "{point:?}");
        }
    }
}
