//! Triangles of shapes, for looking at; the physics never sees them.
//!
//! Primitives are swept or listed exactly, up to the chords of a circle.
//! Combinations keep the triangles of their parts and cut them where the other part's distance is zero,
//! so that a thin plate stays whole and an edge stays sharp at any size.
//! Surfaces parallel to another are found on a grid.

mod cuboid;
mod cut;
mod level;
mod mesh;
mod plane;
mod sheet;
mod turned;

pub use mesh::Mesh;

use pelletflow_core::shape::Profile;
use pelletflow_core::{Bounds, Shape, Vec3};
use pelletflow_sim::WallShape;

impl Mesh {
    /// The surface of a wall; one without end is shown as far as `bounds` reach [m].
    pub fn of_wall(shape: &WallShape, bounds: &Bounds) -> Self {
        match shape {
            WallShape::Solid(shape) => Self::of(shape, bounds),
            WallShape::Mesh(tree) => sheet::mesh(tree.mesh()),
            WallShape::Baked(baked) => sheet::mesh(baked.mesh()),
        }
    }

    /// The surface of a shape; one without end is shown as far as `bounds` reach [m].
    pub fn of(shape: &Shape, bounds: &Bounds) -> Self {
        match shape {
            Shape::HalfSpace { point, normal } => plane::mesh(*point, *normal, bounds),
            Shape::Sphere { radius } => turned::mesh(&turned::half_circle(*radius)),
            Shape::Cylinder {
                radius,
                half_length,
            } => turned::mesh(&turned::frustum(*radius, *radius, *half_length)),
            Shape::Cone {
                lower_radius,
                upper_radius,
                half_length,
            } => turned::mesh(&turned::frustum(*lower_radius, *upper_radius, *half_length)),
            Shape::Torus {
                ring_radius,
                tube_radius,
            } => turned::mesh(&turned::circle(*ring_radius, *tube_radius)),
            Shape::Capsule {
                radius,
                half_length,
            } => turned::mesh(&turned::stadium(*radius, *half_length)),
            Shape::Ellipsoid { half_axes } => turned::mesh(&turned::half_circle(1.0))
                .mapped(|point| point.component_mul(half_axes)),
            Shape::Cuboid { half_sides } => cuboid::mesh(&Bounds {
                min: -half_sides,
                max: *half_sides,
            }),
            Shape::Revolution { profile } => match profile {
                Profile::Closed { corners } => turned::mesh(corners),
                Profile::Plate { corners, thickness } => {
                    turned::mesh(&turned::plate_outline(corners, *thickness))
                }
            },
            // Fillets are not drawn.
            Shape::Union { of } | Shape::Blend { of, .. } => {
                of.iter().map(|part| Self::of(part, bounds)).collect()
            }
            Shape::Intersection { of } => cut::intersection(of, &shape.bounds().common(bounds)),
            Shape::Difference { of, minus } => {
                cut::difference(of, minus, &shape.bounds().common(bounds))
            }
            Shape::Translated { by, of } => {
                let bounds_of_part = Bounds {
                    min: bounds.min - by,
                    max: bounds.max - by,
                };
                Self::of(of, &bounds_of_part).mapped(|point| point + by)
            }
            Shape::Rotated { by, of } => {
                Self::of(of, &bounds.rotated(&by.inverse())).mapped(|point| by * point)
            }
            Shape::Mirrored { point, normal, of } => {
                let across = |at: Vec3| at - 2.0 * (at - point).dot(normal) * normal.into_inner();
                Self::of(of, &bounds.mirrored(*point, *normal))
                    .mapped(across)
                    .inside_out()
            }
            Shape::Scaled { by, of } => {
                Self::of(of, &bounds.scaled(1.0 / by)).mapped(|point| point * *by)
            }
            Shape::Offset { by, of } => level::mesh(of, *by, &shape.bounds().common(bounds)),
            Shape::Shell { thickness, of } => {
                let hollow = level::mesh(of, -thickness, &of.bounds().common(bounds));
                [Self::of(of, bounds), hollow.inside_out()]
                    .into_iter()
                    .collect()
            }
            // A shape that has no triangles of its own yet is shown by its box rather than not at all.
            other => cuboid::mesh(&other.bounds().common(bounds)),
        }
    }
}

#[cfg(test)]
mod contract;
