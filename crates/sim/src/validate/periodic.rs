//! Periodic axes: what of a setup does not repeat itself.

use crate::error::SetupError;
use crate::setup::Setup;
use crate::wall::Wall;
use pelletflow_core::{Bounds, Vec3};

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];
/// Points along each side of the part of a border at which a wall is looked at [-].
const POINTS: u32 = 40;
/// Moments at which a wall that moves is looked at [s].
const MOMENTS: [f64; 4] = [0.0, 0.21, 1.3, 7.9];
/// Difference between two borders that is rounding, over the reach of a pellet [-].
const NEGLIGIBLE: f64 = 1.0e-6;

/// Every mistake of the periodic axes of a setup that has no other mistakes; lengths in [m].
pub(crate) fn mistakes(setup: &Setup, largest_diameter: f64, skin: f64) -> Vec<SetupError> {
    let axes = (0..3).filter(|&axis| setup.domain.is_periodic[axis]);
    axes.flat_map(|axis| {
        let narrow = narrow(setup, axis, largest_diameter, skin);
        let walls = setup.walls.iter();
        let broken =
            walls.filter_map(move |wall| broken(setup, wall, axis, largest_diameter / 2.0 + skin));
        narrow.into_iter().chain(broken)
    })
    .collect()
}

/// A box in which a pellet could meet two images of another, or itself.
fn narrow(setup: &Setup, axis: usize, largest_diameter: f64, skin: f64) -> Option<SetupError> {
    let length = (setup.domain.bounds.max - setup.domain.bounds.min)[axis];
    let least = 2.0 * (largest_diameter + skin);
    (length < least).then(|| {
        SetupError::new(
            "domain.periodic",
            format!(
                "the domain is {length:.4} m long along its periodic axis {}; expected at least {least:.4} m, twice the largest \
                 diameter and the skin of the neighbor lists: lengthen the domain or take smaller pellets",
                AXES[axis]
            ),
        )
    })
}

/// A wall that a pellet would meet differently after coming round; `reach` is how near a wall counts [m].
fn broken(setup: &Setup, wall: &Wall, axis: usize, reach: f64) -> Option<SetupError> {
    let moments = if wall.motion.is_moving() {
        &MOMENTS[..]
    } else {
        &MOMENTS[..1]
    };
    moments.iter().find_map(|&time| {
        let pose = wall.at(time).pose;
        let distance = |point| wall.shape.distance(pose.inverse_point(point)).min(reach);
        let domain = setup.domain.bounds;
        let along = Vec3::ith(axis, (domain.max - domain.min)[axis]);
        let inward = Vec3::ith(axis, reach / 16.0);
        let border = border(&domain, &wall.bounds(&pose).grown(reach), axis)?;
        // A pellet near either border, and its image beyond the other, which the wall must not meet differently.
        let places = points(&border, axis).flat_map(|low| {
            let high = low + along;
            [
                (low, high),
                (low + inward, high + inward),
                (high, low),
                (high - inward, low - inward),
            ]
        });
        let (point, _) = places.into_iter().find(|&(point, image)| {
            let (seen, unseen) = (distance(point), distance(image));
            // Inside the wall no pellet comes to either side.
            unseen < reach
                && seen.max(unseen) > 0.0
                && (seen - unseen).abs() > NEGLIGIBLE * reach
        })?;
        Some(SetupError::new(
            format!("walls.{}.shape", wall.name),
            format!(
                "the wall is not the same on both borders of the periodic axis {}: a pellet at ({:.4}, {:.4}, {:.4}) m would meet \
                 it at another distance after coming round; let the wall go straight through both borders, or keep it away \
                 from them by a pellet's radius and the skin, {reach:.4} m",
                AXES[axis], point.x, point.y, point.z
            ),
        ))
    })
}

/// The part of the lower border of an axis that lies in a box across it; none where it is empty.
fn border(domain: &Bounds, near: &Bounds, axis: usize) -> Option<Bounds> {
    let mut border = domain.common(near);
    if (0..3).any(|other| other != axis && border.min[other] > border.max[other]) {
        return None;
    }
    border.min[axis] = domain.min[axis];
    border.max[axis] = domain.min[axis];
    Some(border)
}

/// Points spread evenly over a border.
fn points(border: &Bounds, axis: usize) -> impl Iterator<Item = Vec3> {
    let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
    let (low, size) = (border.min, border.max - border.min);
    let share = |index: u32| f64::from(index) / f64::from(POINTS - 1);
    (0..POINTS).flat_map(move |i| {
        (0..POINTS).map(move |j| {
            let mut point = low;
            point[first] += share(i) * size[first];
            point[second] += share(j) * size[second];
            point
        })
    })
}
