//! Where two or three faces meet: the points of their edge or corner that are nearest to a center.

use super::face::Face;
use crate::{Surface, Vec3};
use nalgebra::Matrix3;

/// Steps to get onto the faces; planes take one, curved faces about four [-].
const MOST_STEPS_ONTO: u32 = 20;
/// Steps along an edge; a straight one takes one, a curved one about six [-].
const MOST_STEPS_ALONG: u32 = 60;
/// Step below which a point is found, over the radius of the ball [-].
const CLOSE: f64 = 1.0e-11;
/// Determinant of the products of normals below which faces count as parallel [-].
const PARALLEL: f64 = 1.0e-9;
/// How far the search may lead astray, in radii of the ball [-].
const ASTRAY: f64 = 4.0;
/// Radius of the ball over a face's radius of curvature up to which the nearest point of an edge is taken to be the only one [-].
const STRAIGHT: f64 = 0.3;
/// Factors by which a step along an edge may shrink and grow from one to the next [-].
const PACES: [f64; 2] = [0.2, 5.0];

/// Calls `visit` with common points of two or three faces that are nearest to `center` and within `reach` [m] of it.
///
/// Around a ball that is as large as a hole a rim comes near at several places; it is looked for from several sides.
pub(super) fn for_each_nearest(
    faces: &[&Face],
    center: Vec3,
    reach: f64,
    mut visit: impl FnMut(Vec3),
) {
    let search = Search {
        faces,
        center,
        reach,
    };
    let mut offer = |start: Vec3| {
        if let Some(place) = search.nearest_from(start)
            && (place - center).norm_squared() < reach * reach
        {
            visit(place);
        }
    };
    offer(center);
    if search.is_curved() {
        for axis in 0..3 {
            for way in [reach, -reach] {
                offer(center + Vec3::ith(axis, way));
            }
        }
    }
}

struct Search<'a> {
    faces: &'a [&'a Face],
    center: Vec3,
    reach: f64,
}

/// A point of all faces.
struct Meeting {
    place: Vec3,
    surfaces: [Option<Surface>; 3],
}

impl Meeting {
    /// The way along the edge of two faces.
    fn along(&self) -> Vec3 {
        match self.surfaces {
            [Some(one), Some(other), None] => one.normal.cross(&other.normal).normalize(),
            _ => Vec3::zeros(),
        }
    }
}

impl Search<'_> {
    /// Whether a face bends within the ball.
    fn is_curved(&self) -> bool {
        self.faces.iter().any(|face| {
            let curvatures = face.surface(self.center).principal_curvatures;
            curvatures
                .iter()
                .any(|curvature| curvature.abs() * self.reach > STRAIGHT)
        })
    }

    /// The nearest common point downhill from a start.
    fn nearest_from(&self, start: Vec3) -> Option<Vec3> {
        let mut here = self.onto(start)?;
        if self.faces.len() > 2 {
            return Some(here.place);
        }
        let uphill = |meeting: &Meeting| (self.center - meeting.place).dot(&meeting.along());
        // On a straight edge the whole way leads to the nearest point.
        let (mut pace, mut slope) = (1.0, uphill(&here));
        for _ in 0..MOST_STEPS_ALONG {
            let step = pace * slope;
            if step.abs() < CLOSE * self.reach {
                return Some(here.place);
            }
            let along = here.along();
            let next = self.onto(here.place + step * along)?;
            let next_slope = uphill(&next) * along.dot(&next.along()).signum();
            let is_nearer = (next.place - self.center).norm_squared()
                < (here.place - self.center).norm_squared();
            // Near the bottom the slope tells what the distance, by rounding, does not.
            if !is_nearer && next_slope.abs() > 0.5 * slope.abs() {
                pace *= PACES[0];
                continue;
            }
            // The slope is taken to change evenly along the edge.
            let change = slope / (slope - next_slope);
            pace = if change.is_finite() && change > 0.0 {
                pace * change.clamp(PACES[0], PACES[1])
            } else {
                pace * PACES[1]
            };
            here = next;
            slope = uphill(&here);
        }
        None
    }

    /// The common point of the faces nearest to a start, by their tangent planes.
    fn onto(&self, start: Vec3) -> Option<Meeting> {
        let mut place = start;
        for _ in 0..MOST_STEPS_ONTO {
            let mut surfaces = [None::<Surface>; 3];
            let mut heights = Vec3::zeros();
            let mut products = Matrix3::identity();
            for (row, face) in self.faces.iter().enumerate() {
                let surface = face.surface(place);
                heights[row] = surface.distance;
                for (column, other) in surfaces.iter().flatten().enumerate() {
                    let product = surface.normal.dot(&other.normal);
                    products[(row, column)] = product;
                    products[(column, row)] = product;
                }
                surfaces[row] = Some(surface);
            }
            if products.determinant() < PARALLEL {
                return None;
            }
            let shares = products.try_inverse()? * heights;
            let step = surfaces
                .iter()
                .flatten()
                .enumerate()
                .fold(Vec3::zeros(), |step, (row, surface)| {
                    step - shares[row] * surface.normal
                });
            place += step;
            if (place - self.center).norm() > ASTRAY * self.reach {
                return None;
            }
            if step.norm() < CLOSE * self.reach {
                return Some(Meeting { place, surfaces });
            }
        }
        None
    }
}
