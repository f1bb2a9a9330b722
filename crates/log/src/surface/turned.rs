//! Bodies of revolution: a closed polygon of `[radius, z]` swept about the z axis.

use super::Mesh;
use pelletflow_core::Vec3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Sides of a circle [-]; its chords are 0.12 % of the radius inside it.
const SIDES: usize = 64;
/// Sides of a half circle in the profile [-].
const HALF_CIRCLE_SIDES: usize = 32;
/// Turn of the profile from which a corner counts as sharp [rad].
const SHARP_TURN: f64 = 0.4;

/// Profile of a ball.
pub(super) fn half_circle(radius: f64) -> Vec<[f64; 2]> {
    (0..=HALF_CIRCLE_SIDES)
        .map(|index| {
            let angle = PI * index as f64 / HALF_CIRCLE_SIDES as f64 - FRAC_PI_2;
            // The sine of a rounded π is not zero, and a pole has to be on the axis.
            let is_pole = index == 0 || index == HALF_CIRCLE_SIDES;
            let from_axis = if is_pole { 0.0 } else { radius * angle.cos() };
            [from_axis, radius * angle.sin()]
        })
        .collect()
}

/// Profile of a torus.
pub(super) fn circle(ring_radius: f64, tube_radius: f64) -> Vec<[f64; 2]> {
    (0..SIDES)
        .map(|side| {
            let (sin, cos) = (TAU * side as f64 / SIDES as f64).sin_cos();
            [ring_radius + tube_radius * cos, tube_radius * sin]
        })
        .collect()
}

/// Profile of a capsule: the two halves of a ball's, pulled apart.
pub(super) fn stadium(radius: f64, half_length: f64) -> Vec<[f64; 2]> {
    let ball = half_circle(radius);
    let middle = ball.len() / 2;
    let lower = ball[..=middle].iter().map(|&[r, z]| [r, z - half_length]);
    let upper = ball[middle..].iter().map(|&[r, z]| [r, z + half_length]);
    lower.chain(upper).collect()
}

/// Profile of a cylinder or cone.
pub(super) fn frustum(lower_radius: f64, upper_radius: f64, half_length: f64) -> Vec<[f64; 2]> {
    vec![
        [0.0, -half_length],
        [lower_radius, -half_length],
        [upper_radius, half_length],
        [0.0, half_length],
    ]
}

/// Outline of a line of corners given a thickness: along one side, around the end, and back.
pub(super) fn plate_outline(corners: &[[f64; 2]], thickness: f64) -> Vec<[f64; 2]> {
    let back: Vec<[f64; 2]> = corners.iter().rev().copied().collect();
    let mut outline = Vec::new();
    for line in [corners, back.as_slice()] {
        push_right_side(line, thickness / 2.0, &mut outline);
    }
    for corner in &mut outline {
        corner[0] = corner[0].max(0.0);
    }
    outline.dedup();
    outline
}

/// The line moved to its right, with an arc about each corner that it turns left at, and about its end.
fn push_right_side(line: &[[f64; 2]], offset: f64, outline: &mut Vec<[f64; 2]>) {
    let headings: Vec<f64> = line
        .windows(2)
        .map(|side| (side[1][1] - side[0][1]).atan2(side[1][0] - side[0][0]))
        .collect();
    let at = |corner: [f64; 2], heading: f64, length: f64| {
        let angle = heading - FRAC_PI_2;
        [
            corner[0] + length * angle.cos(),
            corner[1] + length * angle.sin(),
        ]
    };
    outline.push(at(line[0], headings[0], offset));
    for (corner, heading) in line[1..].iter().zip(headings.windows(2)) {
        let turn = wrapped(heading[1] - heading[0]);
        if turn > 0.0 {
            push_arc(*corner, heading[0], turn, offset, &at, outline);
        } else {
            // The inner side of a bend: the two moved sides meet where the bend is halved.
            let miter = offset / (turn / 2.0).cos().max(0.1);
            outline.push(at(*corner, heading[0] + turn / 2.0, miter));
        }
    }
    let last = headings[headings.len() - 1];
    push_arc(line[line.len() - 1], last, PI, offset, &at, outline);
}

fn push_arc(
    center: [f64; 2],
    heading: f64,
    turn: f64,
    radius: f64,
    at: &impl Fn([f64; 2], f64, f64) -> [f64; 2],
    outline: &mut Vec<[f64; 2]>,
) {
    // Coarser than a circle about the axis: a plate is thin, and its rim is hardly seen.
    let pieces = (turn / 0.8).ceil().max(1.0) as usize;
    for piece in 0..=pieces {
        let share = piece as f64 / pieces as f64;
        outline.push(at(center, heading + share * turn, radius));
    }
}

fn wrapped(angle: f64) -> f64 {
    if angle > PI {
        angle - TAU
    } else if angle <= -PI {
        angle + TAU
    } else {
        angle
    }
}

/// The polygon turned once about the z axis.
pub(super) fn mesh(corners: &[[f64; 2]]) -> Mesh {
    let mut corners = corners.to_vec();
    if signed_area(&corners) < 0.0 {
        corners.reverse();
    }
    let circle: Vec<(f64, f64)> = (0..SIDES)
        .map(|side| (TAU * side as f64 / SIDES as f64).sin_cos())
        .collect();
    let ring = |[radius, z]: [f64; 2]| -> Vec<Vec3> {
        circle
            .iter()
            .map(|(sin, cos)| Vec3::new(radius * cos, radius * sin, z))
            .collect()
    };
    let mut mesh = Mesh::default();
    let count = corners.len();
    for index in 0..count {
        let (before, here) = (corners[(index + count - 1) % count], corners[index]);
        let after = corners[(index + 1) % count];
        let (lower, upper) = (ring(here), ring(after));
        for side in 0..SIDES {
            let next = (side + 1) % SIDES;
            if here[0] > 0.0 {
                mesh.triangles.push([lower[side], lower[next], upper[next]]);
            }
            if after[0] > 0.0 {
                mesh.triangles.push([lower[side], upper[next], upper[side]]);
            }
        }
        if here[0] > 0.0 && turn(before, here, after).abs() > SHARP_TURN {
            mesh.push_outline(&lower);
        }
    }
    mesh
}

fn turn(before: [f64; 2], here: [f64; 2], after: [f64; 2]) -> f64 {
    let heading = |from: [f64; 2], to: [f64; 2]| (to[1] - from[1]).atan2(to[0] - from[0]);
    wrapped(heading(here, after) - heading(before, here))
}

fn signed_area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(|(a, b)| (a[0] * b[1] - b[0] * a[1]) / 2.0)
        .sum()
}
