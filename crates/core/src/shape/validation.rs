//! Which shapes can be.

use super::Shape;
use crate::Vec3;

/// A shape that cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// A length that must be positive is not.
    #[error("{what} is {value} m; expected more than 0")]
    NotPositive {
        /// Which length.
        what: &'static str,
        /// Its value [m].
        value: f64,
    },
    /// A factor that leaves nothing.
    #[error("the factor of the scaling is {value}; expected more than 0")]
    FactorNotPositive {
        /// Its value [-].
        value: f64,
    },
    /// A length that leaves no room for the shape it belongs to.
    #[error("{what} is {value} m; expected less than {limit_name}, {limit} m")]
    TooLarge {
        /// Which length.
        what: &'static str,
        /// Its value [m].
        value: f64,
        /// What it must stay below.
        limit_name: &'static str,
        /// The value of that [m].
        limit: f64,
    },
    /// A profile with too few corners.
    #[error(
        "the profile has {count} corners; expected at least {least}: of a polygon three, of a plate with a thickness two"
    )]
    TooFewCorners {
        /// How many there are [-].
        count: usize,
        /// How many are needed [-].
        least: usize,
    },
    /// A profile that crosses the axis.
    #[error("corner {index} of the profile has radius {radius} m; expected 0 or more")]
    NegativeRadius {
        /// Which corner, counted from 0 [-].
        index: usize,
        /// Its radius [m].
        radius: f64,
    },
    /// A closed profile whose sides cross each other.
    #[error("sides {first} and {second} of the profile cross; list the corners in order around it")]
    CrossingSides {
        /// One side, counted from 0 [-].
        first: usize,
        /// The other side [-].
        second: usize,
    },
    /// A value that is not a number or not finite.
    #[error("{what} is not finite")]
    NotFinite {
        /// Which value.
        what: &'static str,
    },
    /// A combination of nothing.
    #[error("a {what} needs at least one part")]
    NoParts {
        /// Which combination.
        what: &'static str,
    },
}

impl Shape {
    /// Checks every length and every part.
    ///
    /// # Errors
    /// The first thing found that makes the shape impossible.
    pub fn validate(&self) -> Result<(), ShapeError> {
        match self {
            Self::HalfSpace { point, .. } => finite("point of the half-space", *point),
            Self::Sphere { radius } => positive("radius of the sphere", *radius),
            Self::Cylinder {
                radius,
                half_length,
            } => {
                positive("radius of the cylinder", *radius)?;
                positive("half length of the cylinder", *half_length)
            }
            Self::Cone {
                lower_radius,
                upper_radius,
                half_length,
            } => {
                positive("half length of the cone", *half_length)?;
                positive("larger radius of the cone", lower_radius.max(*upper_radius))?;
                not_negative("lower radius of the cone", *lower_radius)?;
                not_negative("upper radius of the cone", *upper_radius)
            }
            Self::Torus {
                ring_radius,
                tube_radius,
            } => {
                positive("ring radius of the torus", *ring_radius)?;
                positive("tube radius of the torus", *tube_radius)?;
                below(
                    "tube radius of the torus",
                    *tube_radius,
                    "its ring radius",
                    *ring_radius,
                )
            }
            Self::Capsule {
                radius,
                half_length,
            } => {
                positive("radius of the capsule", *radius)?;
                positive("half length of the capsule", *half_length)
            }
            Self::Ellipsoid { half_axes } => half_axes
                .iter()
                .try_for_each(|half_axis| positive("half-axis of the ellipsoid", *half_axis)),
            Self::Cuboid { half_sides } => half_sides
                .iter()
                .try_for_each(|half_side| positive("half side of the box", *half_side)),
            Self::Revolution { profile } => profile.validate(),
            Self::Union { of } => parts("union", of),
            Self::Intersection { of } => parts("intersection", of),
            Self::Difference { of, minus } => of.validate().and_then(|()| minus.validate()),
            Self::Blend { radius, of } => {
                positive("radius of the blend", *radius).and_then(|()| parts("blend", of))
            }
            Self::Translated { by, of } => finite("translation", *by).and_then(|()| of.validate()),
            Self::Rotated { of, .. } => of.validate(),
            Self::Mirrored { point, of, .. } => {
                finite("point of the mirror", *point).and_then(|()| of.validate())
            }
            Self::Scaled { by, of } => factor(*by).and_then(|()| of.validate()),
            Self::Offset { by, of } => {
                positive("length of the offset", *by).and_then(|()| of.validate())
            }
            Self::Shell { thickness, of } => {
                positive("thickness of the shell", *thickness)?;
                of.validate()?;
                room_within(of, *thickness)
            }
        }
    }
}

pub(super) fn positive(what: &'static str, value: f64) -> Result<(), ShapeError> {
    if !value.is_finite() {
        return Err(ShapeError::NotFinite { what });
    }
    if value > 0.0 {
        Ok(())
    } else {
        Err(ShapeError::NotPositive { what, value })
    }
}

fn not_negative(what: &'static str, value: f64) -> Result<(), ShapeError> {
    if value >= 0.0 {
        Ok(())
    } else {
        Err(ShapeError::NotPositive { what, value })
    }
}

fn factor(value: f64) -> Result<(), ShapeError> {
    if !value.is_finite() {
        return Err(ShapeError::NotFinite {
            what: "factor of the scaling",
        });
    }
    if value > 0.0 {
        Ok(())
    } else {
        Err(ShapeError::FactorNotPositive { value })
    }
}

fn below(
    what: &'static str,
    value: f64,
    limit_name: &'static str,
    limit: f64,
) -> Result<(), ShapeError> {
    if value < limit {
        Ok(())
    } else {
        Err(ShapeError::TooLarge {
            what,
            value,
            limit_name,
            limit,
        })
    }
}

/// Whether a wall leaves a hollow, judged by the box around the shape; one without end has room.
///
/// A shape that fills its box poorly may be solid at less.
fn room_within(of: &Shape, thickness: f64) -> Result<(), ShapeError> {
    let bounds = of.bounds();
    if !bounds.is_finite() {
        return Ok(());
    }
    below(
        "thickness of the shell",
        thickness,
        "half of the smallest side around what is hollowed out",
        (bounds.max - bounds.min).min() / 2.0,
    )
}

fn finite(what: &'static str, vector: Vec3) -> Result<(), ShapeError> {
    if vector.iter().all(|value| value.is_finite()) {
        Ok(())
    } else {
        Err(ShapeError::NotFinite { what })
    }
}

fn parts(what: &'static str, of: &[Shape]) -> Result<(), ShapeError> {
    if of.is_empty() {
        return Err(ShapeError::NoParts { what });
    }
    of.iter().try_for_each(Shape::validate)
}
