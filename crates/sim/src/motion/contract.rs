//! What every motion promises: its velocity is the rate of its pose, and within its bound.

use super::{Interpolation, Motion, MotionTable, Swing};
use nalgebra::UnitVector3;
use pelletflow_core::{Bounds, Vec3};

fn axis(x: f64, y: f64, z: f64) -> UnitVector3<f64> {
    UnitVector3::new_normalize(Vec3::new(x, y, z))
}

fn table(interpolation: Interpolation) -> MotionTable {
    MotionTable {
        moments: vec![0.1, 0.4, 0.5, 1.1, 2.0],
        displacements: [
            [0.0, 0.0, 0.1],
            [0.3, 0.0, 0.1],
            [0.5, 0.1, -0.1],
            [0.5, -0.4, -0.2],
            [0.1, 0.0, -0.5],
        ]
        .map(Vec3::from)
        .to_vec(),
        angles: vec![0.0, 1.0, 3.0, 3.5, 2.0],
        center: Vec3::new(0.2, -0.3, 0.1),
        axis: axis(1.0, 2.0, -1.0),
        interpolation,
    }
}

/// One of each kind, and kinds inside others.
fn motions() -> Vec<Motion> {
    let rotating = Motion::Rotating {
        center: Vec3::new(0.3, 0.1, 0.0),
        axis: axis(0.0, 1.0, 1.0),
        rate: -7.0,
        start: 0.2,
        end: 1.5,
    };
    let vibrating = Motion::Vibrating {
        amplitude: Vec3::new(0.01, 0.0, 0.03),
        frequency: 4.0,
        swing: Some(Swing {
            center: Vec3::new(0.0, 0.5, 0.0),
            axis: axis(1.0, 0.0, 0.2),
            angle: -0.3,
        }),
    };
    let translating = Motion::Translating {
        velocity: Vec3::new(0.0, -2.0, 0.5),
        start: 0.3,
        end: f64::INFINITY,
    };
    let smooth = Motion::Table(table(Interpolation::Smooth));
    vec![
        Motion::Fixed,
        Motion::Vibrating {
            amplitude: Vec3::new(0.0, 0.02, 0.0),
            frequency: 10.0,
            swing: None,
        },
        Motion::Table(table(Interpolation::Linear)),
        Motion::Combined {
            motions: vec![rotating.clone(), vibrating.clone()],
        },
        Motion::Combined {
            motions: vec![
                vibrating.clone(),
                rotating.clone(),
                smooth.clone(),
                Motion::Combined {
                    motions: vec![translating.clone(), rotating.clone()],
                },
            ],
        },
        rotating,
        vibrating,
        translating,
        smooth,
    ]
}

/// Moments between the kinks of all the motions above [s].
const MOMENTS: [f64; 9] = [0.04, 0.17, 0.26, 0.34, 0.45, 0.77, 1.33, 1.7, 2.4];

#[test]
fn velocity_and_spin_are_the_rate_of_the_pose() {
    let step = 1.0e-5;
    for motion in motions() {
        for time in MOMENTS {
            let point = Vec3::new(0.4, -0.7, 0.9);
            let in_body = motion.pose(time).inverse_point(point);
            let at = |time: f64| motion.pose(time).point(in_body);
            let rate = (at(time + step) - at(time - step)) / (2.0 * step);
            // The third derivative, at most ω³ r = 10⁵ m/s³, times step²/6, and rounding over the step.
            let error = (motion.velocity(point, time) - rate).norm();
            assert!(error < 1.0e-5, "{motion:?} at {time}: {error}");
            let turned = motion.pose(time + step).rotation / motion.pose(time - step).rotation;
            let spin = turned.scaled_axis() / (2.0 * step);
            let error = (motion.spin(time) - spin).norm();
            assert!(error < 1.0e-5, "{motion:?} at {time}: {error}");
        }
    }
}

#[test]
fn no_point_of_a_wall_is_faster_than_the_bound() {
    let body = Bounds {
        min: Vec3::new(-0.2, 0.0, 0.1),
        max: Vec3::new(0.3, 0.4, 0.6),
    };
    let domain = Bounds::about_origin(Vec3::repeat(1.0e3));
    for motion in motions() {
        let bound = motion.greatest_speed(&body, &domain);
        assert!(bound.is_finite());
        for sample in 0..2400 {
            let time = 1.0e-3 * f64::from(sample);
            for corner in [body.min, body.max, (body.min + body.max) / 2.0] {
                let point = motion.pose(time).point(corner);
                let speed = motion.velocity(point, time).norm();
                assert!(
                    speed <= bound * (1.0 + 1.0e-12),
                    "{motion:?}: {speed} > {bound}"
                );
            }
        }
    }
}

#[test]
fn a_table_goes_through_its_rows_and_waits_at_both_ends() {
    for interpolation in [Interpolation::Linear, Interpolation::Smooth] {
        let table = table(interpolation);
        let motion = Motion::Table(table.clone());
        let from_center = |time: f64| motion.pose(time).point(table.center) - table.center;
        for (row, &moment) in table.moments.iter().enumerate() {
            assert!((from_center(moment) - table.displacements[row]).norm() < 1.0e-15);
        }
        for (outside, row) in [(-1.0, 0), (9.0, 4)] {
            assert!((from_center(outside) - table.displacements[row]).norm() < 1.0e-15);
            assert_eq!(motion.velocity(Vec3::zeros(), outside), Vec3::zeros());
        }
    }
}

#[test]
fn a_smooth_table_has_no_jump_of_velocity_and_no_overshoot() {
    let table = table(Interpolation::Smooth);
    let motion = Motion::Table(table.clone());
    for &moment in &table.moments {
        let point = Vec3::new(1.0, 1.0, 1.0);
        let jump =
            motion.velocity(point, moment + 1.0e-9) - motion.velocity(point, moment - 1.0e-9);
        // Accelerations of some 100 m/s² over 2 ns.
        assert!(jump.norm() < 1.0e-5, "at {moment}: {jump}");
    }
    for (row, ends) in table.moments.windows(2).enumerate() {
        let [from, to] = [table.displacements[row], table.displacements[row + 1]];
        for share in 0..=50 {
            let time = ends[0] + (ends[1] - ends[0]) * f64::from(share) / 50.0;
            let at = motion.pose(time).point(table.center) - table.center;
            let is_between = (0..3).all(|axis| {
                let [low, high] = [from[axis].min(to[axis]), from[axis].max(to[axis])];
                (low - 1.0e-15..=high + 1.0e-15).contains(&at[axis])
            });
            assert!(is_between, "at {time}: {at}");
        }
    }
}

#[test]
fn a_screw_on_a_shaking_frame_turns_about_the_axis_that_shakes() {
    let center = Vec3::new(0.2, 0.0, 0.0);
    let amplitude = Vec3::new(0.0, 0.0, 0.01);
    let screw = Motion::Combined {
        motions: vec![
            Motion::Rotating {
                center,
                axis: Vec3::y_axis(),
                rate: 20.0,
                start: 0.0,
                end: f64::INFINITY,
            },
            Motion::Vibrating {
                amplitude,
                frequency: 5.0,
                swing: None,
            },
        ],
    };
    // A quarter of a swing later the axis is up by the amplitude, and stands still for an instant.
    let time = 0.05;
    assert!((screw.pose(time).point(center) - center - amplitude).norm() < 1.0e-15);
    assert!(screw.velocity(center + amplitude, time).norm() < 1.0e-14);
}
