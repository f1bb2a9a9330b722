//! The ellipsoid against closed forms, and where it is hardest to be exact.

use super::points;
use crate::Vec3;
use crate::shape::Shape;

#[test]
fn an_ellipsoid_has_the_closed_forms_on_its_axes() {
    let [a, b, c] = [0.9, 0.35, 0.6];
    let ellipsoid = Shape::Ellipsoid {
        half_axes: Vec3::new(a, b, c),
    };
    // At the end of an axis the sections are ellipses of radius b²/a and c²/a.
    let tip = ellipsoid.surface(Vec3::new(-2.0, 0.0, 0.0));
    assert!((tip.distance - (2.0 - a)).abs() < 1.0e-15);
    let expected = f64::midpoint(a / (b * b), a / (c * c));
    assert!((tip.mean_curvature() / expected - 1.0).abs() < 1.0e-14);
    // In the middle the shortest way out is along the shortest axis.
    let middle = ellipsoid.surface(Vec3::zeros());
    assert!((middle.distance + b).abs() < 1.0e-15);
    assert!((middle.normal.y.abs() - 1.0).abs() < 1.0e-15);
    // On the long axis within the evolute, x < (a² − b²)/a, the nearest point is aside.
    let x: f64 = 0.3;
    let across = a * a - b * b;
    let expected = -b * (1.0 - x * x / across).sqrt();
    let found = ellipsoid.surface(Vec3::new(x, 0.0, 0.0)).distance;
    assert!((found - expected).abs() < 1.0e-15);
}

#[test]
fn an_ellipsoid_of_equal_axes_is_a_ball() {
    for radius in [1.0e-6, 0.6, 1.0e6] {
        // Equal, and so nearly equal that rounding must not matter.
        for stretch in [1.0, 1.0 + 1.0e-15] {
            let ellipsoid = Shape::Ellipsoid {
                half_axes: radius * Vec3::new(1.0, stretch, 1.0),
            };
            let ball = Shape::Sphere { radius };
            // The first point is the center, where every way out is as short.
            for point in points(500).skip(1) {
                let point = radius * point;
                let (found, expected) = (ellipsoid.surface(point), ball.surface(point));
                // A few roundings of lengths up to three and a half radii.
                assert!((found.distance - expected.distance).abs() < 1.0e-14 * radius);
                assert!((found.normal - expected.normal).norm() < 1.0e-13);
                // The root of a difference that vanishes doubles the digits lost, but not in the mean.
                let mean = found.mean_curvature() / expected.mean_curvature();
                assert!((mean - 1.0).abs() < 1.0e-13);
            }
        }
    }
}

#[test]
fn the_nearest_point_of_an_extreme_ellipsoid_lies_on_it_and_the_way_there_is_normal() {
    for half_axes in [
        Vec3::new(1.0, 1.0e-3, 1.0),
        Vec3::new(1.0e-3, 1.0, 1.0e-3),
        Vec3::new(1.0, 0.1, 1.0e-3),
    ] {
        let ellipsoid = Shape::Ellipsoid { half_axes };
        // All of space, then each plane and axis of symmetry, and beside it by almost nothing.
        let faces = [1.0, 0.0, 1.0e-9, 1.0e-300];
        for point in points(300) {
            for (x, y, z) in faces
                .iter()
                .flat_map(|&x| faces.iter().map(move |&y| (x, y)))
                .flat_map(|(x, y)| faces.iter().map(move |&z| (x, y, z)))
            {
                let point = point.component_mul(&Vec3::new(x, y, z));
                let surface = ellipsoid.surface(point);
                let nearest = point - surface.distance * surface.normal;
                let on_it = nearest.component_div(&half_axes).norm_squared();
                // 10⁻¹⁵ of a coordinate of 1 counts for 10⁻¹² across an axis of 10⁻³.
                assert!(
                    (on_it - 1.0).abs() < 1.0e-11,
                    "{half_axes} at {point}: {on_it}"
                );
                assert!((surface.normal.norm() - 1.0).abs() < 1.0e-14);
            }
        }
    }
}
