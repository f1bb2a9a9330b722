//! Shapes as signed distances: negative inside, unit gradient (the paper's equations 1–5).
//!
//! To add one: write its file with a `surface` and a `bounds` function, then add its variant
//! to [`Shape`] and its arm to the two matches below; the contract tests then loop over it.

mod combination;
mod cone;
mod cuboid;
mod cylinder;
mod half_space;
mod placement;
mod revolution;
mod sphere;

pub use revolution::Profile;

use crate::{Bounds, Vec3};
use nalgebra::{UnitQuaternion, UnitVector3};
use serde::{Deserialize, Serialize};

/// A solid in space, described by its signed distance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Shape {
    /// Everything on the far side of a plane.
    HalfSpace {
        /// A point of the plane [m].
        point: Vec3,
        /// Direction out of the solid [-].
        normal: UnitVector3<f64>,
    },
    /// A ball about the origin.
    Sphere {
        /// Radius [m].
        radius: f64,
    },
    /// A solid cylinder about the z axis, centered at the origin.
    Cylinder {
        /// Radius [m].
        radius: f64,
        /// Half of the length along z [m].
        half_length: f64,
    },
    /// A solid frustum about the z axis, centered at the origin.
    Cone {
        /// Radius at the lower end, z = −`half_length` [m].
        lower_radius: f64,
        /// Radius at the upper end, z = +`half_length` [m].
        upper_radius: f64,
        /// Half of the length along z [m].
        half_length: f64,
    },
    /// A box about the origin, aligned with the axes.
    Cuboid {
        /// Half of each side [m].
        half_sides: Vec3,
    },
    /// A profile in the (radius, z) plane, turned about the z axis.
    Revolution {
        /// The profile.
        profile: Profile,
    },
    /// All of several shapes together.
    Union {
        /// The parts; at least one.
        of: Vec<Shape>,
    },
    /// What several shapes have in common.
    Intersection {
        /// The parts; at least one.
        of: Vec<Shape>,
    },
    /// One shape with another cut away.
    Difference {
        /// What is cut.
        of: Box<Shape>,
        /// What is taken away.
        minus: Box<Shape>,
    },
    /// A shape moved.
    Translated {
        /// The way it is moved [m].
        by: Vec3,
        /// What is moved.
        of: Box<Shape>,
    },
    /// A shape turned about the origin.
    Rotated {
        /// The turn [-].
        by: UnitQuaternion<f64>,
        /// What is turned.
        of: Box<Shape>,
    },
}

/// What a shape says of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Signed distance to the surface, negative inside [m].
    pub distance: f64,
    /// Unit gradient of the distance: the way out of the solid [-].
    pub normal: Vec3,
    /// Mean curvature of the surface at its point nearest to the query, positive where the solid
    /// bulges and negative where it is hollow [1/m]. A sharp edge counts as flat: its true radius is unknown.
    pub mean_curvature: f64,
}

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
    /// A profile with too few corners.
    #[error("the profile has {count} corners; expected at least {least}")]
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
    /// Distance, normal and mean curvature at a point [m].
    pub fn surface(&self, point: Vec3) -> Surface {
        match self {
            Self::HalfSpace {
                point: on_plane,
                normal,
            } => half_space::surface(*on_plane, *normal, point),
            Self::Sphere { radius } => sphere::surface(*radius, point),
            Self::Cylinder {
                radius,
                half_length,
            } => cylinder::surface(*radius, *half_length, point),
            Self::Cone {
                lower_radius,
                upper_radius,
                half_length,
            } => cone::surface(*lower_radius, *upper_radius, *half_length, point),
            Self::Cuboid { half_sides } => cuboid::surface(*half_sides, point),
            Self::Revolution { profile } => revolution::surface(profile, point),
            Self::Union { of } => combination::union(of, point),
            Self::Intersection { of } => combination::intersection(of, point),
            Self::Difference { of, minus } => combination::difference(of, minus, point),
            Self::Translated { by, of } => placement::translated(*by, of, point),
            Self::Rotated { by, of } => placement::rotated(*by, of, point),
        }
    }

    /// Signed distance alone [m].
    pub fn distance(&self, point: Vec3) -> f64 {
        self.surface(point).distance
    }

    /// A box that holds the whole solid [m].
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::HalfSpace { point, normal } => half_space::bounds(*point, *normal),
            Self::Sphere { radius } => Bounds::about_origin(Vec3::repeat(*radius)),
            Self::Cylinder {
                radius,
                half_length,
            } => Bounds::about_origin(Vec3::new(*radius, *radius, *half_length)),
            Self::Cone {
                lower_radius,
                upper_radius,
                half_length,
            } => {
                let radius = lower_radius.max(*upper_radius);
                Bounds::about_origin(Vec3::new(radius, radius, *half_length))
            }
            Self::Cuboid { half_sides } => Bounds::about_origin(*half_sides),
            Self::Revolution { profile } => profile.bounds(),
            Self::Union { of } => of
                .iter()
                .map(Self::bounds)
                .reduce(|a, b| a.merged(&b))
                .unwrap_or_else(Bounds::nothing),
            Self::Intersection { of } => of
                .iter()
                .map(Self::bounds)
                .reduce(|a, b| a.common(&b))
                .unwrap_or_else(Bounds::nothing),
            Self::Difference { of, .. } => of.bounds(),
            Self::Translated { by, of } => {
                let bounds = of.bounds();
                Bounds {
                    min: bounds.min + by,
                    max: bounds.max + by,
                }
            }
            Self::Rotated { by, of } => of.bounds().rotated(by),
        }
    }

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
            Self::Cuboid { half_sides } => half_sides
                .iter()
                .try_for_each(|half_side| positive("half side of the box", *half_side)),
            Self::Revolution { profile } => profile.validate(),
            Self::Union { of } => parts("union", of),
            Self::Intersection { of } => parts("intersection", of),
            Self::Difference { of, minus } => of.validate().and_then(|()| minus.validate()),
            Self::Translated { by, of } => finite("translation", *by).and_then(|()| of.validate()),
            Self::Rotated { of, .. } => of.validate(),
        }
    }

    /// The shape moved by a vector [m].
    #[must_use]
    pub fn translated(self, by: Vec3) -> Self {
        Self::Translated {
            by,
            of: Box::new(self),
        }
    }

    /// The shape turned about the origin.
    #[must_use]
    pub fn rotated(self, by: UnitQuaternion<f64>) -> Self {
        Self::Rotated {
            by,
            of: Box::new(self),
        }
    }
}

fn positive(what: &'static str, value: f64) -> Result<(), ShapeError> {
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

#[cfg(test)]
mod contract;
