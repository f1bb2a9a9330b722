//! Shapes joined by a fillet: the hollow that a ball of its radius leaves as it rolls along where they meet.
//!
//! The ball's center runs where it touches two parts, at the distance r from both; the fillet is what it cannot reach.
//! At a point x between the two, e the nearest place of the center, the distance is r − |x − e|.
//! That is exact where both parts are plane. Where one bends, as around the edge of a box, it falls short by a little.

use super::{Shape, Surface, combination};
use crate::Vec3;
use nalgebra::Matrix2;

/// Steps to find the center of the ball; planes take one [-].
const MOST_STEPS: u32 = 16;
/// Step below which it is found, over the radius [-].
const CLOSE: f64 = 1.0e-12;
/// Square of the sine of the angle between two faces below which they are one [-].
const PARALLEL: f64 = 1.0e-9;

pub(super) fn surface(radius: f64, of: &[Shape], point: Vec3) -> Surface {
    let mut nearest = combination::union(of, point);
    for (index, one) in of.iter().enumerate() {
        for other in &of[..index] {
            if let Some(fillet) = fillet(radius, [one, other], point)
                && fillet.distance < nearest.distance
            {
                nearest = fillet;
            }
        }
    }
    nearest
}

/// The fillet between two parts, where the point is between its ball and where they meet.
fn fillet(radius: f64, parts: [&Shape; 2], point: Vec3) -> Option<Surface> {
    let mut at = point;
    for _ in 0..MOST_STEPS {
        let [one, other] = parts.map(|part| part.surface(at));
        let common = one.normal.dot(&other.normal);
        if 1.0 - common * common < PARALLEL {
            return None;
        }
        // Nearest common point of the planes tangent to both at the distance r: point + Σ λ n.
        let lacks =
            [one, other].map(|part| radius - part.distance - part.normal.dot(&(point - at)));
        let [first, second] = Matrix2::new(1.0, common, common, 1.0)
            .try_inverse()
            .map(|inverse| (inverse * nalgebra::Vector2::from(lacks)).into())?;
        if first <= 0.0 || second <= 0.0 {
            return None;
        }
        let next = point + first * one.normal + second * other.normal;
        let step = (next - at).norm();
        at = next;
        if step < CLOSE * radius {
            let way = at - point;
            let from_center = way.norm();
            return Some(Surface {
                distance: radius - from_center,
                normal: way / from_center,
                principal_curvatures: [-1.0 / radius, 0.0],
            });
        }
    }
    None
}
