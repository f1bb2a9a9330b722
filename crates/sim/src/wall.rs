//! Walls: a shape with a material, a motion, a belt speed and a schedule.

use crate::motion::Motion;
use crate::schedule::Schedule;
use crate::wall_shape::WallShape;
use pelletflow_core::{Bounds, Pose, Vec3};

/// A piece of equipment.
#[derive(Debug, Clone, PartialEq)]
pub struct Wall {
    /// Name in the scene.
    pub name: String,
    /// Index of its material [-].
    pub material: usize,
    /// What it is made of, in its own frame, which is the world's before it moves.
    pub shape: WallShape,
    /// How it moves.
    pub motion: Motion,
    /// Velocity of its surface beside its motion, as of a belt; only the part along the surface acts [m/s].
    pub surface_velocity: Vec3,
    /// When it is there.
    pub schedule: Schedule,
}

/// Where a wall is in one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WallNow {
    pub(crate) pose: Pose,
    pub(crate) is_present: bool,
}

impl Wall {
    /// Where the wall is at a time [s].
    pub(crate) fn at(&self, time: f64) -> WallNow {
        WallNow {
            pose: self.motion.pose(time),
            is_present: self.schedule.is_present(time),
        }
    }

    /// Whether no point of its surface ever moves.
    pub(crate) fn is_still(&self) -> bool {
        !self.motion.is_moving() && self.surface_velocity == Vec3::zeros()
    }

    /// Center of the wall's box before it moves; the origin where the wall has no end [m].
    pub fn center(&self) -> Vec3 {
        let bounds = self.shape.bounds();
        if bounds.is_finite() {
            (bounds.min + bounds.max) / 2.0
        } else {
            Vec3::zeros()
        }
    }

    /// The wall's box in the world, at a pose; infinite where the wall has no end [m].
    pub fn bounds(&self, pose: &Pose) -> Bounds {
        let bounds = self.shape.bounds();
        if !self.motion.is_moving() {
            return bounds;
        }
        let turned = bounds.rotated(&pose.rotation);
        Bounds {
            min: turned.min + pose.translation,
            max: turned.max + pose.translation,
        }
    }

    /// Velocity of the wall's surface at a point [m] with a normal [-], belt included [m/s].
    pub(crate) fn surface_velocity_at(&self, point: Vec3, normal: Vec3, time: f64) -> Vec3 {
        let along_surface = self.surface_velocity - self.surface_velocity.dot(&normal) * normal;
        self.motion.velocity(point, time) + along_surface
    }
}
