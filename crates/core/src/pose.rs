//! Where a body stands: a rotation, then a translation.

use crate::Vec3;
use nalgebra::UnitQuaternion;
use serde::{Deserialize, Serialize};

/// Rotation and translation of a body; used as `world_from_body`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Turn from the body's axes to the world's [-].
    pub rotation: UnitQuaternion<f64>,
    /// Origin of the body in the world [m].
    pub translation: Vec3,
}

impl Pose {
    /// The pose that changes nothing.
    pub fn identity() -> Self {
        Self {
            rotation: UnitQuaternion::identity(),
            translation: Vec3::zeros(),
        }
    }

    /// The pose of a body that first takes another and then this one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self {
            rotation: self.rotation * first.rotation,
            translation: self.point(first.translation),
        }
    }

    /// A point of the body, seen from the world [m].
    pub fn point(&self, point_in_body: Vec3) -> Vec3 {
        self.rotation * point_in_body + self.translation
    }

    /// A point of the world, seen from the body [m].
    pub fn inverse_point(&self, point_in_world: Vec3) -> Vec3 {
        self.rotation
            .inverse_transform_vector(&(point_in_world - self.translation))
    }

    /// A direction of the body, seen from the world; keeps its length [unit of the argument].
    pub fn direction(&self, direction_in_body: Vec3) -> Vec3 {
        self.rotation * direction_in_body
    }
}
