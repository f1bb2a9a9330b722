//! Shapes as signed distances: negative inside, unit gradient (the paper's equations 1–5).
//!
//! To add one: write its file with a `surface` function, then add its variant to [`Shape`], its arm to the two
//! matches below and to the one in `validation.rs`, and its row to `contract/registry.rs`; the contract tests then loop over it.

mod blend;
mod capsule;
pub(crate) mod combination;
mod cone;
mod cuboid;
mod cylinder;
mod ellipsoid;
mod flatness;
mod half_space;
pub(crate) mod offset;
mod placement;
pub(crate) mod revolution;
mod shell;
mod sphere;
mod torus;
mod validation;

pub use revolution::Profile;
pub use validation::ShapeError;

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
    /// A ring about the z axis, round in its cross-section, centered at the origin.
    Torus {
        /// Radius of the circle along the middle of the tube [m].
        ring_radius: f64,
        /// Radius of the tube, less than that of the ring [m].
        tube_radius: f64,
    },
    /// A cylinder about the z axis with balls for ends, centered at the origin.
    Capsule {
        /// Radius of the cylinder and of its ends [m].
        radius: f64,
        /// Half of the length along z between the centers of the ends [m].
        half_length: f64,
    },
    /// A ball about the origin, stretched along the axes.
    Ellipsoid {
        /// Half of each axis [m].
        half_axes: Vec3,
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
    /// All of several shapes together, each two joined by a fillet in the corner where they meet.
    Blend {
        /// Radius of the fillets [m].
        radius: f64,
        /// The parts; at least one.
        of: Vec<Shape>,
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
    /// A shape seen in a plane mirror.
    Mirrored {
        /// A point of the plane [m].
        point: Vec3,
        /// Direction across the plane [-].
        normal: UnitVector3<f64>,
        /// What is mirrored.
        of: Box<Shape>,
    },
    /// A shape made larger or smaller about the origin, alike in all directions.
    Scaled {
        /// The factor of all lengths [-].
        by: f64,
        /// What is scaled.
        of: Box<Shape>,
    },
    /// A shape and everything within a length of it; its edges become round.
    Offset {
        /// That length [m].
        by: f64,
        /// What is grown.
        of: Box<Shape>,
    },
    /// A shape hollowed out, closed on all sides; its outer face stays where it is.
    Shell {
        /// Thickness of the wall that is left [m].
        thickness: f64,
        /// What is hollowed out.
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
    /// Principal curvatures of the surface at its point nearest to the query, positive where the solid
    /// bulges, negative where it is hollow, and infinite across a sharp edge [1/m].
    pub principal_curvatures: [f64; 2],
}

impl Surface {
    /// Mean curvature at the nearest point [1/m]. A sharp edge counts as flat: its true radius is unknown.
    pub fn mean_curvature(&self) -> f64 {
        let [first, second] = self.principal_curvatures;
        let mean = f64::midpoint(first, second);
        if mean.is_finite() { mean } else { 0.0 }
    }
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
            Self::Torus {
                ring_radius,
                tube_radius,
            } => torus::surface(*ring_radius, *tube_radius, point),
            Self::Capsule {
                radius,
                half_length,
            } => capsule::surface(*radius, *half_length, point),
            Self::Ellipsoid { half_axes } => ellipsoid::surface(*half_axes, point),
            Self::Cuboid { half_sides } => cuboid::surface(*half_sides, point),
            Self::Revolution { profile } => revolution::surface(profile, point),
            Self::Union { of } => combination::union(of, point),
            Self::Intersection { of } => combination::intersection(of, point),
            Self::Difference { of, minus } => combination::difference(of, minus, point),
            Self::Blend { radius, of } => blend::surface(*radius, of, point),
            Self::Translated { by, of } => placement::translated(*by, of, point),
            Self::Rotated { by, of } => placement::rotated(*by, of, point),
            Self::Mirrored {
                point: on_plane,
                normal,
                of,
            } => placement::mirrored(*on_plane, *normal, of, point),
            Self::Scaled { by, of } => placement::scaled(*by, of, point),
            Self::Offset { by, of } => offset::surface(*by, of, point),
            Self::Shell { thickness, of } => shell::surface(*thickness, of, point),
        }
    }

    /// Signed distance alone [m].
    pub fn distance(&self, point: Vec3) -> f64 {
        self.surface(point).distance
    }

    /// A box that holds the whole solid [m].
    pub fn bounds(&self) -> Bounds {
        self.bounds_within(0.0)
    }

    /// A box that holds every point whose distance is at most this [m].
    ///
    /// Beside an edge where the distance falls short of the true one, that is more than the solid's box grown.
    fn bounds_within(&self, distance: f64) -> Bounds {
        let all = |of: &[Self], together: fn(&Bounds, &Bounds) -> Bounds| {
            of.iter()
                .map(|part| part.bounds_within(distance))
                .reduce(|a, b| together(&a, &b))
                .unwrap_or_else(Bounds::nothing)
        };
        let solid = match self {
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
            Self::Torus {
                ring_radius,
                tube_radius,
            } => {
                let radius = ring_radius + tube_radius;
                Bounds::about_origin(Vec3::new(radius, radius, *tube_radius))
            }
            Self::Capsule {
                radius,
                half_length,
            } => Bounds::about_origin(Vec3::new(*radius, *radius, half_length + radius)),
            Self::Ellipsoid { half_axes } => Bounds::about_origin(*half_axes),
            Self::Cuboid { half_sides } => Bounds::about_origin(*half_sides),
            Self::Revolution { profile } => profile.bounds(),
            // A fillet fills a corner between parts; it stays within the box about them.
            Self::Union { of } | Self::Blend { of, .. } => return all(of, Bounds::merged),
            Self::Intersection { of } => return all(of, Bounds::common),
            Self::Difference { of, .. } | Self::Shell { of, .. } => {
                return of.bounds_within(distance);
            }
            Self::Translated { by, of } => return of.bounds_within(distance).translated(*by),
            Self::Rotated { by, of } => return of.bounds_within(distance).rotated(by),
            Self::Mirrored { point, normal, of } => {
                return of.bounds_within(distance).mirrored(*point, *normal);
            }
            Self::Scaled { by, of } => return of.bounds_within(distance / by).scaled(*by),
            Self::Offset { by, of } => return of.bounds_within(distance + by),
        };
        solid.grown(distance)
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

#[cfg(test)]
mod contract;
