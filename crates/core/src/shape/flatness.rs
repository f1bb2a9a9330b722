//! Which shapes have plane faces only.

use super::Shape;

impl Shape {
    /// The kind of its first part with a curved face, as scenes name it; none where all faces are plane.
    pub fn curved_part(&self) -> Option<&'static str> {
        match self {
            Self::HalfSpace { .. } | Self::Cuboid { .. } => None,
            Self::Sphere { .. } => Some("sphere"),
            Self::Cylinder { .. } => Some("cylinder"),
            Self::Cone { .. } => Some("cone"),
            Self::Torus { .. } => Some("torus"),
            Self::Capsule { .. } => Some("capsule"),
            Self::Ellipsoid { .. } => Some("ellipsoid"),
            Self::Revolution { .. } => Some("revolution"),
            Self::Offset { .. } => Some("offset"),
            Self::Blend { .. } => Some("blend"),
            Self::Union { of } | Self::Intersection { of } => of.iter().find_map(Self::curved_part),
            Self::Difference { of, minus } => of.curved_part().or_else(|| minus.curved_part()),
            Self::Translated { of, .. }
            | Self::Rotated { of, .. }
            | Self::Mirrored { of, .. }
            | Self::Scaled { of, .. }
            | Self::Shell { of, .. } => of.curved_part(),
        }
    }
}
