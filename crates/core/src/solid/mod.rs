//! Solids: shapes made ready to be touched.
//!
//! A [`Shape`] answers with one distance, which is that of the nearest point where the shape is simple and a lower bound
//! around the edges of some combinations. A pellet asks for more: every place at which it touches, each where it really is.
//! In a corner it touches two faces at once, and at a sharp edge the edge itself.
//! A place is touched where the surface is nearer to the center than everywhere about it.

mod blended;
mod carved;
mod face;
mod grown;
mod meeting;
mod polygon;
mod similarity;
mod together;
mod touches;
mod tree;
mod turned;

pub use touches::{MOST_TOUCHES, Touches};

use crate::{Shape, Vec3};
use blended::Blended;
use carved::Carved;
use similarity::Similarity;
use together::Together;
use turned::Turned;

/// A shape made ready to be touched.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    part: Part,
}

/// How the touches of a part of a solid are found.
#[derive(Debug, Clone, PartialEq)]
enum Part {
    /// It bulges everywhere, or is smooth: the nearest point is the only one.
    Single(Shape),
    /// A profile about the z axis.
    Turned(Turned),
    /// A part moved, turned, mirrored or scaled.
    Placed { at: Similarity, of: Box<Part> },
    /// A part and everything within a length of it [m].
    Grown { by: f64, of: Box<Part> },
    /// Parts together.
    Together(Together),
    /// Parts joined by a fillet.
    Blended(Blended),
    /// With edges where its faces meet.
    Carved(Carved),
}

impl Solid {
    /// Takes a shape apart.
    pub fn new(shape: &Shape) -> Self {
        Self {
            part: Part::new(shape),
        }
    }

    /// Whether a ball can touch it at more than one place.
    pub fn is_touched_at_many(&self) -> bool {
        self.part.is_touched_at_many()
    }

    /// Where a ball of radius `reach` [m] about `center` [m] touches.
    pub fn touches(&self, center: Vec3, reach: f64) -> Touches {
        let mut touches = Touches::none(reach);
        self.part.offer(center, &mut touches);
        touches
    }
}

impl Part {
    fn new(shape: &Shape) -> Self {
        match shape {
            Shape::Revolution { profile } => Self::Turned(Turned::new(profile)),
            Shape::Union { of } => Self::Together(Together::new(of)),
            Shape::Blend { of, .. } => Self::Blended(Blended::new(shape, of)),
            Shape::Intersection { .. } | Shape::Difference { .. } | Shape::Shell { .. } => {
                Self::Carved(Carved::new(shape))
            }
            Shape::Translated { by, of } => Self::placed(&Similarity::translation(*by), of),
            Shape::Rotated { by, of } => Self::placed(&Similarity::rotation(*by), of),
            Shape::Mirrored { point, normal, of } => {
                Self::placed(&Similarity::mirroring(*point, *normal), of)
            }
            Shape::Scaled { by, of } => Self::placed(&Similarity::scaling(*by), of),
            Shape::Offset { by, of } => match Self::new(of) {
                Self::Single(_) => Self::Single(shape.clone()),
                part => Self::Grown {
                    by: *by,
                    of: Box::new(part),
                },
            },
            _ => Self::Single(shape.clone()),
        }
    }

    /// Placements in a row become one.
    fn placed(outer: &Similarity, shape: &Shape) -> Self {
        match Self::new(shape) {
            Self::Placed { at: inner, of } => Self::Placed {
                at: outer.after(&inner),
                of,
            },
            part => Self::Placed {
                at: *outer,
                of: Box::new(part),
            },
        }
    }

    fn is_touched_at_many(&self) -> bool {
        match self {
            Self::Single(_) => false,
            Self::Placed { of, .. } => of.is_touched_at_many(),
            _ => true,
        }
    }

    fn offer(&self, center: Vec3, touches: &mut Touches) {
        match self {
            Self::Single(shape) => touches.offer(shape.surface(center)),
            Self::Turned(turned) => turned.offer(center, touches),
            Self::Placed { at, of } => {
                let mut own = Touches::none(touches.reach() / at.scale());
                of.offer(at.inverse_point(center), &mut own);
                for &surface in own.as_slice() {
                    touches.offer(at.surface(surface));
                }
            }
            Self::Grown { by, of } => grown::offer(*by, of, center, touches),
            Self::Together(parts) => parts.offer(center, touches),
            Self::Blended(blended) => blended.offer(center, touches),
            Self::Carved(carved) => carved.offer(center, touches),
        }
    }

    /// Distance up to a bound [m]: the bound itself where the part is farther away.
    fn distance_within(&self, point: Vec3, bound: f64) -> f64 {
        let mut touches = Touches::none(bound);
        self.offer(point, &mut touches);
        touches
            .as_slice()
            .first()
            .map_or(bound, |touch| touch.distance)
    }
}

#[cfg(test)]
mod contract;
