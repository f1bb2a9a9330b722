//! Where a ball touches a surface of revolution: the nearest points of its profile.

use super::Touches;
use crate::shape::revolution::{self, HalfPlaneSurface};
use crate::{Profile, Vec3};

/// Offers every point of a turned profile that is nearer to the center than those about it.
///
/// On a surface of revolution those lie in the half-plane of the center; across the axis a point is farther than those beside it.
pub(super) fn offer(profile: &Profile, center: Vec3, touches: &mut Touches) {
    let half_thickness = match profile {
        Profile::Closed { .. } => {
            let surface = revolution::surface(profile, center);
            if surface.distance >= touches.reach() {
                return;
            }
            if surface.distance <= 0.0 {
                touches.offer(surface);
                return;
            }
            0.0
        }
        Profile::Plate { thickness, .. } => thickness / 2.0,
    };
    let point = [revolution::from_axis(center), center.z];
    for flat in nearest_points(profile, point) {
        let grown = HalfPlaneSurface {
            distance: flat.distance - half_thickness,
            meridian_curvature: if flat.meridian_curvature.is_infinite() && half_thickness > 0.0 {
                1.0 / half_thickness
            } else {
                flat.meridian_curvature
            },
            ..flat
        };
        touches.offer(revolution::lifted(center, &grown));
    }
}

/// The points of the line of a profile that are nearer to a point `[radius, z]` than those about them.
fn nearest_points(
    profile: &Profile,
    point: [f64; 2],
) -> impl Iterator<Item = HalfPlaneSurface> + '_ {
    let corners = profile.corners();
    let (sides, outward) = match profile {
        Profile::Closed { .. } => (corners.len(), Some(revolution::winding(corners))),
        Profile::Plate { .. } => (corners.len() - 1, None),
    };
    let side = move |index: usize| Side::new(corners[index], corners[(index + 1) % corners.len()]);
    (0..sides).flat_map(move |index| {
        let here = side(index);
        let along = here.along(point);
        let face = ((0.0..=1.0).contains(&along) && !here.is_on_axis())
            .then(|| here.face(point, along, outward))
            .flatten();
        // The corner at the end of this side, if it juts out toward the point.
        let is_last = index + 1 == sides && outward.is_none();
        let is_end =
            along > 1.0 && (is_last || side((index + 1) % sides).juts(&here, point, outward));
        let is_first = index == 0 && outward.is_none() && along < 0.0;
        let end = is_end.then(|| corner(here.end, point));
        let start = is_first.then(|| corner(here.start, point));
        face.into_iter().chain(end).chain(start)
    })
}

/// A side of a profile, as `[radius, z]` [m].
struct Side {
    start: [f64; 2],
    end: [f64; 2],
    way: [f64; 2],
}

impl Side {
    fn new(start: [f64; 2], end: [f64; 2]) -> Self {
        Self {
            start,
            end,
            way: [end[0] - start[0], end[1] - start[1]],
        }
    }

    /// Turning makes it a line inside the solid.
    fn is_on_axis(&self) -> bool {
        self.start[0] == 0.0 && self.end[0] == 0.0
    }

    /// Whether the corner between the side before and this one is nearer to a point than both sides are.
    fn juts(&self, before: &Self, point: [f64; 2], outward: Option<f64>) -> bool {
        let turn = before.way[0] * self.way[1] - before.way[1] * self.way[0];
        self.along(point) < 0.0 && outward.is_none_or(|winding| winding * turn > 0.0)
    }

    /// Where the foot of a point is: 0 at the start, 1 at the end [-].
    fn along(&self, point: [f64; 2]) -> f64 {
        let [r, z] = [point[0] - self.start[0], point[1] - self.start[1]];
        let squared_length = self.way[0] * self.way[0] + self.way[1] * self.way[1];
        if squared_length > 0.0 {
            (r * self.way[0] + z * self.way[1]) / squared_length
        } else {
            0.0
        }
    }

    /// The side seen from a point whose foot is on it; from behind it is not seen.
    ///
    /// `outward` is the winding of a closed profile; a plate is seen from both sides.
    fn face(&self, point: [f64; 2], along: f64, outward: Option<f64>) -> Option<HalfPlaneSurface> {
        let length = self.way[0].hypot(self.way[1]);
        let normal = [self.way[1] / length, -self.way[0] / length];
        let height = (point[0] - self.start[0] - along * self.way[0]) * normal[0]
            + (point[1] - self.start[1] - along * self.way[1]) * normal[1];
        let sign = outward.unwrap_or(1.0_f64.copysign(height));
        (sign * height >= 0.0)
            .then(|| HalfPlaneSurface::flat(height.abs(), normal.map(|component| sign * component)))
    }
}

fn corner(corner: [f64; 2], point: [f64; 2]) -> HalfPlaneSurface {
    let offset = [point[0] - corner[0], point[1] - corner[1]];
    let distance = offset[0].hypot(offset[1]);
    HalfPlaneSurface {
        distance,
        normal: offset.map(|component| component / distance),
        meridian_curvature: f64::INFINITY,
    }
}
