//! Where a ball touches a surface of revolution: the nearest points of its profile.

use super::Touches;
use crate::shape::revolution::{self, HalfPlaneSurface};
use crate::{Profile, Vec3};

/// A profile about the z axis, made ready.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Turned {
    profile: Profile,
    sides: Vec<Side>,
    is_closed: bool,
    /// Of a plate [m].
    half_thickness: f64,
}

/// A side of a profile, as `[radius, z]` [m].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Side {
    start: [f64; 2],
    end: [f64; 2],
    way: [f64; 2],
    /// 1 over the square of its length, or 0 where it has none [1/m²].
    inverse_square: f64,
    /// To its right, or out of a closed profile.
    normal: [f64; 2],
    /// Turning makes it a line inside the solid.
    is_on_axis: bool,
    /// Whether the profile juts out where the side ends and the next begins.
    juts_at_end: bool,
}

impl Turned {
    pub(super) fn new(profile: &Profile) -> Self {
        let corners = profile.corners();
        let (is_closed, half_thickness) = match profile {
            Profile::Closed { .. } => (true, 0.0),
            Profile::Plate { thickness, .. } => (false, thickness / 2.0),
        };
        let winding = revolution::winding(corners);
        let count = corners.len() - usize::from(!is_closed);
        let way = |index: usize| {
            let (start, end) = (corners[index], corners[(index + 1) % corners.len()]);
            [end[0] - start[0], end[1] - start[1]]
        };
        let sides = (0..count).map(|index| {
            let (way, next) = (way(index), way((index + 1) % count));
            let squared = way[0] * way[0] + way[1] * way[1];
            let out = if is_closed { winding } else { 1.0 };
            let length = squared.sqrt();
            let (start, end) = (corners[index], corners[(index + 1) % corners.len()]);
            let turn = way[0] * next[1] - way[1] * next[0];
            Side {
                start,
                end,
                way,
                inverse_square: if squared > 0.0 { 1.0 / squared } else { 0.0 },
                normal: [out * way[1] / length, -out * way[0] / length],
                is_on_axis: start[0] == 0.0 && end[0] == 0.0,
                juts_at_end: !is_closed || winding * turn > 0.0,
            }
        });
        Self {
            profile: profile.clone(),
            sides: sides.collect(),
            is_closed,
            half_thickness,
        }
    }

    /// Offers every point of the profile that is nearer to the center than those about it.
    ///
    /// On a surface of revolution those lie in the half-plane of the center; across the axis a point is farther than those
    /// beside it.
    pub(super) fn offer(&self, center: Vec3, touches: &mut Touches) {
        let point = [revolution::from_axis(center), center.z];
        let reach = touches.reach() + self.half_thickness;
        if self.is_closed {
            let nearest = self.nearest_squared(point);
            if nearest == 0.0 || self.holds(point) {
                touches.offer(revolution::surface(&self.profile, center));
                return;
            }
            if nearest >= reach * reach {
                return;
            }
        }
        let count = self.sides.len();
        for (index, side) in self.sides.iter().enumerate() {
            let along = side.along(point);
            if (0.0..=1.0).contains(&along) {
                if let Some(face) = side.face(point, self.is_closed) {
                    self.offer_grown(center, face, touches);
                }
            } else if along > 1.0 {
                let is_last = index + 1 == count && !self.is_closed;
                let next = &self.sides[(index + 1) % count];
                if is_last || side.juts_at_end && next.along(point) < 0.0 {
                    self.offer_grown(center, corner(side.end, point), touches);
                }
            } else if index == 0 && !self.is_closed {
                self.offer_grown(center, corner(side.start, point), touches);
            }
        }
    }

    fn offer_grown(&self, center: Vec3, flat: HalfPlaneSurface, touches: &mut Touches) {
        let distance = flat.distance - self.half_thickness;
        if distance >= touches.reach() {
            return;
        }
        let is_round = flat.meridian_curvature.is_infinite() && self.half_thickness > 0.0;
        let grown = HalfPlaneSurface {
            distance,
            meridian_curvature: if is_round {
                1.0 / self.half_thickness
            } else {
                flat.meridian_curvature
            },
            ..flat
        };
        touches.offer(revolution::lifted(center, &grown));
    }

    /// Square of the distance to the nearest side that is a surface [m²].
    fn nearest_squared(&self, point: [f64; 2]) -> f64 {
        let mut nearest = f64::INFINITY;
        for side in self.sides.iter().filter(|side| !side.is_on_axis) {
            let along = side.along(point).clamp(0.0, 1.0);
            let [r, z] = [0, 1].map(|axis| point[axis] - side.start[axis] - along * side.way[axis]);
            let squared = r * r + z * z;
            nearest = if squared < nearest { squared } else { nearest };
        }
        nearest
    }

    /// Whether a point is inside a closed profile.
    fn holds(&self, [r, z]: [f64; 2]) -> bool {
        let crossed = self.sides.iter().filter(|side| {
            (side.start[1] > z) != (side.end[1] > z)
                && r < side.start[0] + (z - side.start[1]) / side.way[1] * side.way[0]
        });
        crossed.count() % 2 == 1
    }
}

impl Side {
    /// Where the foot of a point is: 0 at the start, 1 at the end [-].
    #[inline]
    fn along(&self, point: [f64; 2]) -> f64 {
        let [r, z] = [point[0] - self.start[0], point[1] - self.start[1]];
        (r * self.way[0] + z * self.way[1]) * self.inverse_square
    }

    /// The side seen from a point whose foot is on it; that of a closed profile is not seen from behind.
    fn face(&self, point: [f64; 2], is_closed: bool) -> Option<HalfPlaneSurface> {
        if self.is_on_axis {
            return None;
        }
        let height = (point[0] - self.start[0]) * self.normal[0]
            + (point[1] - self.start[1]) * self.normal[1];
        if height >= 0.0 {
            return Some(HalfPlaneSurface::flat(height, self.normal));
        }
        // A side without length has no height.
        let behind = self.normal.map(|component| -component);
        (height < 0.0 && !is_closed).then(|| HalfPlaneSurface::flat(-height, behind))
    }
}

fn corner(corner: [f64; 2], point: [f64; 2]) -> HalfPlaneSurface {
    let offset = [point[0] - corner[0], point[1] - corner[1]];
    let distance = (offset[0] * offset[0] + offset[1] * offset[1]).sqrt();
    HalfPlaneSurface {
        distance,
        normal: offset.map(|component| component / distance),
        meridian_curvature: f64::INFINITY,
    }
}
