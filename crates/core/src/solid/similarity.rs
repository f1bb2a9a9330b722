//! A move, a turn, a mirroring and a change of size in one.

use crate::{Bounds, Surface, Vec3};
use nalgebra::{Matrix3, UnitQuaternion, UnitVector3};

/// What takes a shape from its own frame to where it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Similarity {
    /// Turn, with or without a mirroring.
    turn: Matrix3<f64>,
    /// Factor of all lengths.
    scale: f64,
    translation: Vec3,
}

impl Similarity {
    pub(super) fn identity() -> Self {
        Self {
            turn: Matrix3::identity(),
            scale: 1.0,
            translation: Vec3::zeros(),
        }
    }

    pub(super) fn translation(by: Vec3) -> Self {
        Self {
            translation: by,
            ..Self::identity()
        }
    }

    pub(super) fn rotation(by: UnitQuaternion<f64>) -> Self {
        Self {
            turn: by.to_rotation_matrix().into_inner(),
            ..Self::identity()
        }
    }

    pub(super) fn scaling(by: f64) -> Self {
        Self {
            scale: by,
            ..Self::identity()
        }
    }

    /// `on_plane` is a point of the mirror [m].
    pub(super) fn mirroring(on_plane: Vec3, normal: UnitVector3<f64>) -> Self {
        let normal = normal.into_inner();
        Self {
            turn: Matrix3::identity() - 2.0 * normal * normal.transpose(),
            scale: 1.0,
            translation: 2.0 * on_plane.dot(&normal) * normal,
        }
    }

    /// First another, then this one.
    pub(super) fn after(&self, first: &Self) -> Self {
        Self {
            turn: self.turn * first.turn,
            scale: self.scale * first.scale,
            translation: self.point(first.translation),
        }
    }

    /// Factor of all lengths [-].
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    fn point(&self, point: Vec3) -> Vec3 {
        self.scale * (self.turn * point) + self.translation
    }

    /// A point where the shape stands, seen from the shape's own frame [m].
    pub(super) fn inverse_point(&self, point: Vec3) -> Vec3 {
        self.turn.tr_mul(&(point - self.translation)) / self.scale
    }

    /// A surface of the shape's own frame, seen from where the shape stands.
    pub(super) fn surface(&self, surface: Surface) -> Surface {
        Surface {
            distance: self.scale * surface.distance,
            normal: self.turn * surface.normal,
            principal_curvatures: surface
                .principal_curvatures
                .map(|curvature| curvature / self.scale),
        }
    }

    /// A box about another one of the shape's own frame; everything where a side is infinite.
    pub(super) fn bounds(&self, bounds: &Bounds) -> Bounds {
        if !bounds.is_finite() {
            return Bounds::everything();
        }
        let center = self.point((bounds.min + bounds.max) / 2.0);
        let half_sides = self.scale * self.turn.abs() * ((bounds.max - bounds.min) / 2.0);
        Bounds {
            min: center - half_sides,
            max: center + half_sides,
        }
    }
}
