//! A shape hollowed out: what is within a thickness of its surface, on the inside.
//!
//! The outer face stays where it is; the inner one is the parallel surface at the thickness below.
//! The distance is as exact as the shape's own is, inside for the inner face and outside for the outer.

use super::combination::inside_out;
use super::offset::parallel;
use super::{Shape, Surface};
use crate::Vec3;

pub(super) fn surface(thickness: f64, of: &Shape, point: Vec3) -> Surface {
    let outer = of.surface(point);
    let inner = inside_out(parallel(outer, -thickness));
    if inner.distance > outer.distance {
        inner
    } else {
        outer
    }
}
