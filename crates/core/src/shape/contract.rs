//! What every shape promises, held for each row of the table in `registry.rs`.

mod any_shape;
mod ellipsoid;
mod registry;

use super::{Profile, Shape, Surface};
use crate::Vec3;
use nalgebra::{UnitQuaternion, Vector3};
use registry::registry;

/// Points spread evenly and without a pattern over [−2, 2]³ (additive recurrence).
fn points(count: usize) -> impl Iterator<Item = Vec3> {
    (0..count).map(|index| {
        let fraction = |ratio: f64| (0.5 + ratio * index as f64).fract() * 4.0 - 2.0;
        Vector3::new(
            fraction(0.819_172_513_396_164_4),
            fraction(0.671_043_606_703_789_2),
            fraction(0.549_700_477_901_970_2),
        )
    })
}

/// The gradient by central differences, with the largest change of normal over the stencil.
fn numeric_gradient(shape: &Shape, point: Vec3, step: f64) -> (Vec3, f64) {
    let center = shape.surface(point);
    let mut gradient = Vec3::zeros();
    let mut bend: f64 = 0.0;
    for axis in 0..3 {
        let offset = Vec3::ith(axis, step);
        let (up, down) = (shape.surface(point + offset), shape.surface(point - offset));
        gradient[axis] = (up.distance - down.distance) / (2.0 * step);
        bend = bend
            .max((up.normal - center.normal).norm())
            .max((down.normal - center.normal).norm());
    }
    (gradient, bend)
}

#[test]
fn every_normal_has_unit_length_and_is_the_gradient_of_the_distance() {
    for (name, shape, _) in registry() {
        for point in points(4000) {
            let Surface { normal, .. } = shape.surface(point);
            assert!((normal.norm() - 1.0).abs() < 1.0e-12, "{name} at {point:?}");
            let (gradient, bend) = numeric_gradient(&shape, point, 1.0e-5);
            // Where two parts meet the gradient jumps; the stencil must not straddle that.
            if bend < 1.0e-3 {
                assert!(
                    (gradient - normal).norm() < 1.0e-4,
                    "{name} at {point:?}: {gradient:?} against {normal:?}"
                );
            }
        }
    }
}

#[test]
fn no_distance_exceeds_the_true_distance_and_exact_ones_reach_the_surface() {
    for (name, shape, is_exact) in registry() {
        for point in points(2000) {
            let surface = shape.surface(point);
            if surface.distance <= 0.0 {
                continue;
            }
            let landing = shape.surface(point - surface.distance * surface.normal);
            assert!(
                landing.distance > -1.0e-9,
                "{name} at {point:?} overshoots by {}",
                landing.distance
            );
            if is_exact {
                assert!(
                    landing.distance < 1.0e-9,
                    "{name} at {point:?} stops {} short",
                    landing.distance
                );
            }
        }
    }
}

#[test]
fn the_distance_changes_no_faster_than_the_point_moves() {
    for (name, shape, _) in registry() {
        let all: Vec<Vec3> = points(1000).collect();
        for pair in all.windows(2) {
            let change = (shape.distance(pair[1]) - shape.distance(pair[0])).abs();
            assert!(change <= (pair[1] - pair[0]).norm() + 1.0e-12, "{name}");
        }
    }
}

#[test]
fn bounds_hold_every_inside_point() {
    for (name, shape, _) in registry() {
        let bounds = shape.bounds();
        for point in points(8000) {
            if shape.distance(point) <= 0.0 {
                assert!(bounds.grown(1.0e-12).contains(point), "{name} at {point:?}");
            }
        }
    }
}

#[test]
fn mean_curvature_is_half_the_divergence_of_the_normal_at_the_surface() {
    let step = 1.0e-6;
    for (name, shape, is_exact) in registry() {
        if !is_exact {
            continue;
        }
        for point in points(2000) {
            let surface = shape.surface(point);
            let on_surface = point - (surface.distance - 1.0e-5) * surface.normal;
            let (_, bend) = numeric_gradient(&shape, on_surface, step);
            // Edges and the meeting of two parts have no curvature to compare.
            if bend > 0.01 || surface.distance < 0.0 {
                continue;
            }
            let divergence: f64 = (0..3)
                .map(|axis| {
                    let offset = Vec3::ith(axis, step);
                    (shape.surface(on_surface + offset).normal[axis]
                        - shape.surface(on_surface - offset).normal[axis])
                        / (2.0 * step)
                })
                .sum();
            let here = shape.surface(on_surface).mean_curvature();
            // A level set 10 µm above a surface of curvature κ = 2 H bends less by the share κ · 10 µm.
            assert!(
                (divergence / 2.0 - here).abs() < 1.0e-3 + 3.0e-5 * here * here,
                "{name} at {on_surface:?}: {} against {here}",
                divergence / 2.0
            );
        }
    }
}

#[test]
fn a_hollow_surface_has_negative_curvature() {
    let pipe = Shape::Revolution {
        profile: Profile::Closed {
            corners: vec![[0.3, -1.0], [0.3, 1.0], [0.4, 1.0], [0.4, -1.0]],
        },
    };
    let inside = pipe.surface(Vec3::new(0.2, 0.0, 0.0));
    assert!((inside.distance - 0.1).abs() < 1.0e-15);
    assert!((inside.mean_curvature() + 0.5 / 0.3).abs() < 1.0e-12);
    let outside = pipe.surface(Vec3::new(0.5, 0.0, 0.0));
    assert!((outside.mean_curvature() - 0.5 / 0.4).abs() < 1.0e-12);
}

#[test]
fn a_torus_is_curved_as_a_saddle_at_its_hole() {
    let torus = Shape::Torus {
        ring_radius: 0.7,
        tube_radius: 0.3,
    };
    let inside = torus.surface(Vec3::new(0.0, 0.1, 0.0));
    // Along the tube's section 1/0.3, around the hole −1/0.4.
    let expected = f64::midpoint(1.0 / 0.3, -1.0 / 0.4);
    assert!((inside.distance - 0.3).abs() < 1.0e-15);
    assert!((inside.mean_curvature() - expected).abs() < 1.0e-12);
    let outside = torus.surface(Vec3::new(0.0, 2.0, 0.0));
    let expected = f64::midpoint(1.0 / 0.3, 1.0);
    assert!((outside.mean_curvature() - expected).abs() < 1.0e-12);
}

#[test]
fn a_capsule_is_a_ball_at_its_tip_and_a_cylinder_beside() {
    let capsule = Shape::Capsule {
        radius: 0.4,
        half_length: 0.6,
    };
    let tip = capsule.surface(Vec3::new(0.0, 0.0, 1.5));
    assert!((tip.distance - 0.5).abs() < 1.0e-15);
    assert!((tip.mean_curvature() - 1.0 / 0.4).abs() < 1.0e-12);
    let side = capsule.surface(Vec3::new(1.0, 0.0, 0.5));
    assert!((side.distance - 0.6).abs() < 1.0e-15);
    assert!((side.mean_curvature() - 0.5 / 0.4).abs() < 1.0e-12);
}

#[test]
fn a_grown_shape_is_curved_as_the_larger_shape_it_is() {
    let grown = |of: Shape| {
        let by = 0.25;
        Shape::Offset {
            by,
            of: Box::new(of),
        }
        .surface(Vec3::new(1.5, 0.2, 0.1))
        .mean_curvature()
    };
    let cylinder = Shape::Cylinder {
        radius: 0.5,
        half_length: 1.0,
    };
    let plane = Shape::HalfSpace {
        point: Vec3::zeros(),
        normal: Vec3::x_axis(),
    };
    // Of radius 0.75; one rounding each.
    assert!((grown(Shape::Sphere { radius: 0.5 }) - 1.0 / 0.75).abs() < 1.0e-15);
    assert!((grown(cylinder) - 0.5 / 0.75).abs() < 1.0e-15);
    assert_eq!(grown(plane), 0.0);
    // The edge of a box becomes a quarter of a cylinder, its corner an eighth of a ball.
    let edge = Shape::Cuboid {
        half_sides: Vec3::new(0.5, 0.1, 1.0),
    };
    assert_eq!(grown(edge), 2.0);
    let corner = Shape::Cuboid {
        half_sides: Vec3::new(0.5, 0.1, 0.05),
    };
    assert_eq!(grown(corner), 4.0);
}

#[test]
fn a_shell_is_hollow_within_and_keeps_its_outer_face() {
    let thickness = 0.1;
    let shell = |of: Shape| Shape::Shell {
        thickness,
        of: Box::new(of),
    };
    let ball = shell(Shape::Sphere { radius: 0.5 });
    for (from_center, distance, mean_curvature) in
        [(0.7, 0.2, 2.0), (0.46, -0.04, 2.0), (0.3, 0.1, -1.0 / 0.4)]
    {
        let surface = ball.surface(Vec3::new(0.0, 0.0, from_center));
        assert!((surface.distance - distance).abs() < 1.0e-15);
        assert!((surface.mean_curvature() - mean_curvature).abs() < 1.0e-14);
    }
    // The hollow of a pipe is curved one way only.
    let pipe = shell(Shape::Cylinder {
        radius: 0.5,
        half_length: 2.0,
    });
    let inside = pipe.surface(Vec3::new(0.3, 0.0, 0.0));
    assert!((inside.mean_curvature() + 0.5 / 0.4).abs() < 1.0e-14);
}

#[test]
fn a_wall_thicker_than_the_shape_is_refused_with_its_bound() {
    let solid = Shape::Shell {
        thickness: 0.5,
        of: Box::new(Shape::Sphere { radius: 0.5 }),
    };
    let error = solid.validate().expect_err("no hollow is left");
    assert_eq!(
        error.to_string(),
        "thickness of the shell is 0.5 m; expected less than half of the smallest side around what is hollowed out, 0.5 m"
    );
}

#[test]
fn a_mirror_turns_what_is_left_to_the_right() {
    let capsule = Shape::Capsule {
        radius: 0.1,
        half_length: 0.5,
    };
    let tilted = capsule.rotated(UnitQuaternion::from_euler_angles(0.0, 0.6, 0.0));
    let mirrored = Shape::Mirrored {
        point: Vec3::new(0.3, 0.0, 0.0),
        normal: Vec3::x_axis(),
        of: Box::new(tilted.clone()),
    };
    for point in points(200) {
        let image = Vec3::new(0.6 - point.x, point.y, point.z);
        let (here, there) = (tilted.surface(point), mirrored.surface(image));
        // Rounding of the way to the plane and back.
        assert!((here.distance - there.distance).abs() < 1.0e-14);
        assert!((here.normal.x + there.normal.x).abs() < 1.0e-14);
    }
}

#[test]
fn impossible_shapes_are_refused() {
    let crossing = Shape::Revolution {
        profile: Profile::Closed {
            corners: vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]],
        },
    };
    let refused = [
        Shape::Sphere { radius: 0.0 },
        Shape::Cylinder {
            radius: 1.0,
            half_length: f64::NAN,
        },
        Shape::Cuboid {
            half_sides: Vec3::new(1.0, -1.0, 1.0),
        },
        Shape::Torus {
            ring_radius: 0.3,
            tube_radius: 0.3,
        },
        Shape::Torus {
            ring_radius: 0.3,
            tube_radius: 0.0,
        },
        Shape::Capsule {
            radius: 0.1,
            half_length: 0.0,
        },
        Shape::Scaled {
            by: -1.0,
            of: Box::new(Shape::Sphere { radius: 1.0 }),
        },
        Shape::Offset {
            by: 0.0,
            of: Box::new(Shape::Sphere { radius: 1.0 }),
        },
        Shape::Mirrored {
            point: Vec3::zeros(),
            normal: Vec3::x_axis(),
            of: Box::new(Shape::Sphere { radius: 0.0 }),
        },
        Shape::Ellipsoid {
            half_axes: Vec3::new(1.0, 0.0, 1.0),
        },
        Shape::Shell {
            thickness: 0.0,
            of: Box::new(Shape::Sphere { radius: 1.0 }),
        },
        Shape::Union { of: vec![] },
        Shape::Revolution {
            profile: Profile::Plate {
                corners: vec![[0.1, 0.0]],
                thickness: 0.1,
            },
        },
        Shape::Revolution {
            profile: Profile::Plate {
                corners: vec![[-0.1, 0.0], [0.1, 0.0]],
                thickness: 0.1,
            },
        },
        crossing,
    ];
    for shape in refused {
        assert!(shape.validate().is_err(), "{shape:?}");
    }
    for (name, shape, _) in registry() {
        assert_eq!(shape.validate(), Ok(()), "{name}");
    }
}
