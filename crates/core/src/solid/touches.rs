//! The few places at which a ball touches a solid.

use crate::Surface;
use crate::Vec3;

/// Most touches of one ball with one solid [-]: three in the corner of a box, four in the point of a pyramid.
pub const MOST_TOUCHES: usize = 4;

/// Distance between two points of a surface, over the radius of the ball, below which the ball feels them as one [-].
///
/// A finely cut curve must not be counted once for each of its facets. The two faces of a corner of 174 degrees are just
/// felt as two.
const ONE_PATCH: f64 = 0.1;

/// Points of a solid within reach of a ball, each nearer than all others about it; the nearest first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touches {
    reach: f64,
    surfaces: [Surface; MOST_TOUCHES],
    count: usize,
}

impl Touches {
    /// None yet, for a ball of that radius [m].
    pub fn none(reach: f64) -> Self {
        let nowhere = Surface {
            distance: f64::INFINITY,
            normal: Vec3::z(),
            principal_curvatures: [0.0; 2],
        };
        Self {
            reach,
            surfaces: [nowhere; MOST_TOUCHES],
            count: 0,
        }
    }

    /// Radius of the ball [m].
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The surfaces touched, seen from the center of the ball, the nearest first.
    pub fn as_slice(&self) -> &[Surface] {
        &self.surfaces[..self.count]
    }

    /// Adds a surface seen from the center of the ball, if it is within reach and not the neighbor of a nearer one.
    pub fn offer(&mut self, surface: Surface) {
        if surface.distance >= self.reach {
            return;
        }
        let nearness = ONE_PATCH * self.reach;
        let way = |surface: &Surface| surface.distance * surface.normal;
        let is_neighbor =
            |other: &Surface| (way(other) - way(&surface)).norm_squared() < nearness * nearness;
        if let Some(place) = self.as_slice().iter().position(is_neighbor) {
            if self.surfaces[place].distance <= surface.distance {
                return;
            }
            self.surfaces.copy_within(place + 1..self.count, place);
            self.count -= 1;
        }
        let place = self
            .as_slice()
            .partition_point(|other| other.distance <= surface.distance);
        if place == MOST_TOUCHES {
            return;
        }
        self.count = (self.count + 1).min(MOST_TOUCHES);
        self.surfaces.copy_within(place..self.count - 1, place + 1);
        self.surfaces[place] = surface;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(distance: f64, normal: Vec3) -> Surface {
        Surface {
            distance,
            normal: normal.normalize(),
            principal_curvatures: [0.0; 2],
        }
    }

    #[test]
    fn the_nearest_comes_first_and_what_is_out_of_reach_not_at_all() {
        let mut touches = Touches::none(1.0);
        for (distance, normal) in [
            (0.9, Vec3::x()),
            (0.5, Vec3::y()),
            (1.0, Vec3::z()),
            (0.7, -Vec3::x()),
        ] {
            touches.offer(at(distance, normal));
        }
        let distances: Vec<f64> = touches
            .as_slice()
            .iter()
            .map(|touch| touch.distance)
            .collect();
        assert_eq!(distances, [0.5, 0.7, 0.9]);
    }

    #[test]
    fn neighbors_are_felt_as_the_nearest_of_them() {
        let mut touches = Touches::none(1.0);
        for (distance, lean) in [(0.95, 0.05), (0.94, 0.0), (0.96, -0.05)] {
            touches.offer(at(distance, Vec3::new(lean, 0.0, 1.0)));
        }
        assert_eq!(touches.as_slice(), [at(0.94, Vec3::z())]);
    }

    #[test]
    fn of_too_many_the_farthest_is_left_out() {
        let mut touches = Touches::none(1.0);
        let ways = [Vec3::x(), Vec3::y(), Vec3::z(), -Vec3::x(), -Vec3::y()];
        for (place, way) in ways.into_iter().enumerate() {
            touches.offer(at(0.9 - 0.1 * place as f64, way));
        }
        let distances: Vec<f64> = touches
            .as_slice()
            .iter()
            .map(|touch| touch.distance)
            .collect();
        assert_eq!(distances.len(), MOST_TOUCHES);
        assert!(distances.iter().all(|&distance| distance < 0.85));
    }
}
