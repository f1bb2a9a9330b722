//! Axis-aligned boxes.

use crate::Vec3;
use nalgebra::{Matrix3, UnitQuaternion, UnitVector3};

/// An axis-aligned box; infinite where what it holds is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Lowest corner [m].
    pub min: Vec3,
    /// Highest corner [m].
    pub max: Vec3,
}

impl Bounds {
    /// A box about the origin from half of each side [m].
    pub fn about_origin(half_sides: Vec3) -> Self {
        Self {
            min: -half_sides,
            max: half_sides,
        }
    }

    /// All of space.
    pub fn everything() -> Self {
        Self {
            min: Vec3::repeat(f64::NEG_INFINITY),
            max: Vec3::repeat(f64::INFINITY),
        }
    }

    /// A box that holds no point.
    pub fn nothing() -> Self {
        Self {
            min: Vec3::repeat(f64::INFINITY),
            max: Vec3::repeat(f64::NEG_INFINITY),
        }
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn merged(&self, other: &Self) -> Self {
        Self {
            min: self.min.inf(&other.min),
            max: self.max.sup(&other.max),
        }
    }

    /// The part that both hold.
    #[must_use]
    pub fn common(&self, other: &Self) -> Self {
        Self {
            min: self.min.sup(&other.min),
            max: self.max.inf(&other.max),
        }
    }

    /// The box grown on every side by a margin [m].
    #[must_use]
    pub fn grown(&self, margin: f64) -> Self {
        Self {
            min: self.min.add_scalar(-margin),
            max: self.max.add_scalar(margin),
        }
    }

    /// Whether a point is inside.
    pub fn contains(&self, point: Vec3) -> bool {
        (0..3).all(|axis| self.min[axis] <= point[axis] && point[axis] <= self.max[axis])
    }

    /// Whether every side is finite.
    pub fn is_finite(&self) -> bool {
        self.min
            .iter()
            .chain(self.max.iter())
            .all(|value| value.is_finite())
    }

    /// The box moved by a vector [m].
    #[must_use]
    pub fn translated(&self, by: Vec3) -> Self {
        Self {
            min: self.min + by,
            max: self.max + by,
        }
    }

    /// The box with all its lengths, also those from the origin, times a factor [-].
    #[must_use]
    pub fn scaled(&self, by: f64) -> Self {
        Self {
            min: self.min * by,
            max: self.max * by,
        }
    }

    /// A box about this one mirrored in a plane; everything where a side is infinite.
    ///
    /// `on_plane` is a point of the plane [m].
    #[must_use]
    pub fn mirrored(&self, on_plane: Vec3, normal: UnitVector3<f64>) -> Self {
        if !self.is_finite() {
            return Self::everything();
        }
        let normal = normal.into_inner();
        let reflection = Matrix3::identity() - 2.0 * normal * normal.transpose();
        let center = on_plane + reflection * ((self.min + self.max) / 2.0 - on_plane);
        let half_sides = reflection.abs() * ((self.max - self.min) / 2.0);
        Self {
            min: center - half_sides,
            max: center + half_sides,
        }
    }

    /// A box about this one after a turn about the origin; everything where a side is infinite.
    #[must_use]
    pub fn rotated(&self, by: &UnitQuaternion<f64>) -> Self {
        if !self.is_finite() {
            return Self::everything();
        }
        let center = by * ((self.min + self.max) / 2.0);
        let half_sides = by.to_rotation_matrix().matrix().abs() * ((self.max - self.min) / 2.0);
        Self {
            min: center - half_sides,
            max: center + half_sides,
        }
    }
}
