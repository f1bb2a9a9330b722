//! Walls met by stepping along a ray as far as nothing can be: their shapes are distances.

use crate::camera::Ray;
use pelletflow::core::{Bounds, Pose, Vec3};
use pelletflow::sim::{Setup, WallShape};

/// Distance that counts as a touch, over the diagonal of the picture [-].
const TOUCH_SHARE: f64 = 2.0e-5;
/// Steps of one ray at most [-].
const STEPS: usize = 160;

/// The walls of one moment, without the part before a plane.
pub(crate) struct Walls<'a> {
    present: Vec<(Pose, &'a WallShape)>,
    bounds: Bounds,
    /// Where y is less than this, the walls are cut away [m].
    cut: f64,
    touch: f64,
}

/// A point of a wall.
pub(crate) struct WallPoint {
    /// Way along the ray [m].
    pub(crate) distance: f64,
    pub(crate) normal: Vec3,
    /// Whether it lies in the cut, and not on the wall's own surface.
    pub(crate) is_cut: bool,
}

impl<'a> Walls<'a> {
    /// The walls that are there at a time [s], as far as the bounds reach.
    pub(crate) fn at(setup: &'a Setup, time: f64, bounds: &Bounds, cut: f64) -> Self {
        let touch = TOUCH_SHARE * (bounds.max - bounds.min).norm();
        let present = setup
            .walls
            .iter()
            .filter(|wall| wall.schedule.is_present(time))
            .map(|wall| (wall.motion.pose(time), &wall.shape))
            .collect();
        Self {
            present,
            bounds: bounds.grown(10.0 * touch),
            cut,
            touch,
        }
    }

    /// The first point on a ray within a distance [m].
    pub(crate) fn first_hit(&self, ray: &Ray, reach: f64) -> Option<WallPoint> {
        let mut distance = self.entry(ray)?;
        for _ in 0..STEPS {
            if distance >= reach {
                return None;
            }
            let point = ray.at(distance);
            let free = self.distance(point);
            if free < self.touch {
                return Some(self.point(point, distance));
            }
            distance += free;
            if !self.bounds.grown(self.touch).contains(ray.at(distance)) {
                return None;
            }
        }
        None
    }

    /// Whether light comes freely along a ray from a point of a surface, within a distance [m].
    pub(crate) fn is_free(&self, ray: &Ray, reach: f64) -> bool {
        let mut distance = 20.0 * self.touch;
        for _ in 0..STEPS {
            let point = ray.at(distance);
            if distance >= reach || !self.bounds.contains(point) {
                return true;
            }
            let free = self.distance(point);
            if free < self.touch {
                return false;
            }
            distance += free;
        }
        true
    }

    fn distance(&self, point: Vec3) -> f64 {
        self.of_walls(point).max(self.cut - point.y)
    }

    fn of_walls(&self, point: Vec3) -> f64 {
        self.present
            .iter()
            .map(|(pose, shape)| shape.distance(pose.inverse_point(point)))
            .fold(f64::INFINITY, f64::min)
    }

    fn point(&self, point: Vec3, distance: f64) -> WallPoint {
        let is_cut = self.cut - point.y > self.of_walls(point);
        let nearest = self
            .present
            .iter()
            .map(|(pose, shape)| (pose, shape.surface(pose.inverse_point(point))))
            .reduce(|a, b| if b.1.distance < a.1.distance { b } else { a });
        let normal = match nearest {
            Some((pose, surface)) if !is_cut => pose.direction(surface.normal),
            _ => -Vec3::y(),
        };
        WallPoint {
            distance,
            normal,
            is_cut,
        }
    }

    /// Where a ray enters the bounds [m].
    fn entry(&self, ray: &Ray) -> Option<f64> {
        let (mut enter, mut leave) = (0.0_f64, f64::INFINITY);
        for axis in 0..3 {
            let inverse = 1.0 / ray.direction[axis];
            let a = (self.bounds.min[axis] - ray.origin[axis]) * inverse;
            let b = (self.bounds.max[axis] - ray.origin[axis]) * inverse;
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (enter < leave).then_some(enter)
    }
}
