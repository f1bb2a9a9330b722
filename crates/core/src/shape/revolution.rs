//! Surfaces of revolution: a profile in the half-plane (radius, z), turned about the z axis.

use super::{ShapeError, Surface};
use crate::{Bounds, Vec3};
use serde::{Deserialize, Serialize};

/// The cross-section of a body of revolution, as corners `[radius, z]` [m].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "profile", rename_all = "kebab-case")]
pub enum Profile {
    /// A closed polygon; the solid is inside it. The corners may run either way round.
    Closed {
        /// Corners `[radius, z]`, in order around the polygon [m].
        corners: Vec<[f64; 2]>,
    },
    /// An open line given a thickness, as a plate is; its ends are round.
    Plate {
        /// Corners `[radius, z]`, in order along the plate's middle [m].
        corners: Vec<[f64; 2]>,
        /// Thickness of the plate [m].
        thickness: f64,
    },
}

impl Profile {
    /// The corners `[radius, z]` [m].
    pub fn corners(&self) -> &[[f64; 2]] {
        match self {
            Self::Closed { corners } | Self::Plate { corners, .. } => corners,
        }
    }

    pub(super) fn validate(&self) -> Result<(), ShapeError> {
        let least = match self {
            Self::Closed { .. } => 3,
            Self::Plate { .. } => 2,
        };
        let corners = self.corners();
        if corners.len() < least {
            return Err(ShapeError::TooFewCorners {
                count: corners.len(),
                least,
            });
        }
        for (index, &[radius, z]) in corners.iter().enumerate() {
            if !(radius.is_finite() && z.is_finite()) {
                return Err(ShapeError::NotFinite {
                    what: "a corner of the profile",
                });
            }
            if radius < 0.0 {
                return Err(ShapeError::NegativeRadius { index, radius });
            }
        }
        match self {
            Self::Plate { thickness, .. } => {
                super::validation::positive("thickness of the profile", *thickness)
            }
            Self::Closed { corners } => no_crossing(corners),
        }
    }

    pub(super) fn bounds(&self) -> Bounds {
        let margin = match self {
            Self::Closed { .. } => 0.0,
            Self::Plate { thickness, .. } => thickness / 2.0,
        };
        let mut radius: f64 = 0.0;
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for &[r, z] in self.corners() {
            radius = radius.max(r);
            low = low.min(z);
            high = high.max(z);
        }
        Bounds {
            min: Vec3::new(-radius, -radius, low),
            max: Vec3::new(radius, radius, high),
        }
        .grown(margin)
    }
}

pub(crate) fn surface(profile: &Profile, point: Vec3) -> Surface {
    match profile {
        Profile::Closed { corners } => turned(point, |r, z| polygon_surface(corners, r, z)),
        Profile::Plate { corners, thickness } => {
            turned(point, |r, z| plate_surface(corners, thickness / 2.0, r, z))
        }
    }
}

/// What a profile says of a point of the half-plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HalfPlaneSurface {
    pub(crate) distance: f64,
    /// Way out of the solid, as `[radial, axial]`.
    pub(crate) normal: [f64; 2],
    /// Curvature of the profile line at the nearest point, positive where it bulges, infinite at a sharp corner [1/m].
    pub(crate) meridian_curvature: f64,
}

impl HalfPlaneSurface {
    pub(crate) fn flat(distance: f64, normal: [f64; 2]) -> Self {
        Self {
            distance,
            normal,
            meridian_curvature: 0.0,
        }
    }
}

/// Distance from the z axis [m]; the library's own hypotenuse guards against overflow, at several times the cost.
pub(crate) fn from_axis(point: Vec3) -> f64 {
    (point.x * point.x + point.y * point.y).sqrt()
}

/// Turns a surface of the half-plane about the z axis.
pub(super) fn turned(
    point: Vec3,
    half_plane_surface: impl Fn(f64, f64) -> HalfPlaneSurface,
) -> Surface {
    lifted(point, &half_plane_surface(from_axis(point), point.z))
}

/// What the half-plane of a point says of it, in space, with the curvature of the turn.
pub(crate) fn lifted(point: Vec3, flat: &HalfPlaneSurface) -> Surface {
    let from_axis = from_axis(point);
    let (cos, sin) = if from_axis > 0.0 {
        (point.x / from_axis, point.y / from_axis)
    } else {
        (1.0, 0.0)
    };
    let [radial, axial] = flat.normal;
    let surface_radius = from_axis - flat.distance * radial;
    let turn_curvature = if surface_radius > 0.0 {
        radial / surface_radius
    } else {
        // On the axis every way along the surface is a meridian.
        flat.meridian_curvature
    };
    Surface {
        distance: flat.distance,
        normal: Vec3::new(radial * cos, radial * sin, axial),
        principal_curvatures: [flat.meridian_curvature, turn_curvature],
    }
}

/// The point of a line of corners nearest to `(r, z)`.
struct Nearest {
    offset: [f64; 2],
    squared: f64,
    side: [f64; 2],
    is_corner: bool,
}

fn nearest_on_side(start: [f64; 2], end: [f64; 2], r: f64, z: f64) -> Nearest {
    let side = [end[0] - start[0], end[1] - start[1]];
    let to_point = [r - start[0], z - start[1]];
    let squared_length = side[0] * side[0] + side[1] * side[1];
    let along = if squared_length > 0.0 {
        (to_point[0] * side[0] + to_point[1] * side[1]) / squared_length
    } else {
        0.0
    };
    let clamped = along.clamp(0.0, 1.0);
    let offset = [
        to_point[0] - clamped * side[0],
        to_point[1] - clamped * side[1],
    ];
    Nearest {
        offset,
        squared: offset[0] * offset[0] + offset[1] * offset[1],
        side,
        is_corner: !(0.0..=1.0).contains(&along),
    }
}

/// Signed distance to a closed polygon.
pub(super) fn polygon_surface(corners: &[[f64; 2]], r: f64, z: f64) -> HalfPlaneSurface {
    let mut nearest: Option<Nearest> = None;
    let mut is_inside = false;
    let mut twice_area = 0.0;
    let mut start = corners[corners.len() - 1];
    for &end in corners {
        twice_area += start[0] * end[1] - end[0] * start[1];
        // A side on the axis is no surface: turning makes it a line inside the solid.
        if start[0] > 0.0 || end[0] > 0.0 {
            let candidate = nearest_on_side(start, end, r, z);
            if nearest
                .as_ref()
                .is_none_or(|best| candidate.squared < best.squared)
            {
                nearest = Some(candidate);
            }
        }
        if (start[1] > z) != (end[1] > z)
            && r < start[0] + (z - start[1]) / (end[1] - start[1]) * (end[0] - start[0])
        {
            is_inside = !is_inside;
        }
        start = end;
    }
    let nearest = nearest.expect("a validated profile has a corner off the axis");
    let length = nearest.squared.sqrt();
    let sign = if is_inside { -1.0 } else { 1.0 };
    // On the surface itself the way to the point has no direction; the side's own normal has.
    let side_length = nearest.side[0].hypot(nearest.side[1]);
    let normal = if length > 1.0e-12 * side_length {
        [
            sign * nearest.offset[0] / length,
            sign * nearest.offset[1] / length,
        ]
    } else {
        let out = twice_area.signum() / side_length;
        [out * nearest.side[1], -out * nearest.side[0]]
    };
    HalfPlaneSurface {
        distance: sign * length,
        normal,
        meridian_curvature: if nearest.is_corner {
            sign * f64::INFINITY
        } else {
            0.0
        },
    }
}

/// Signed distance to an open line of corners, given a thickness.
fn plate_surface(corners: &[[f64; 2]], half_thickness: f64, r: f64, z: f64) -> HalfPlaneSurface {
    let nearest = corners
        .windows(2)
        .map(|side| nearest_on_side(side[0], side[1], r, z))
        .reduce(|best, other| {
            if other.squared < best.squared {
                other
            } else {
                best
            }
        })
        .expect("a validated plate has two corners");
    let length = nearest.squared.sqrt();
    let side_length = nearest.side[0].hypot(nearest.side[1]);
    let normal = if length > 1.0e-12 * side_length {
        [nearest.offset[0] / length, nearest.offset[1] / length]
    } else {
        [
            nearest.side[1] / side_length,
            -nearest.side[0] / side_length,
        ]
    };
    HalfPlaneSurface {
        distance: length - half_thickness,
        normal,
        meridian_curvature: if nearest.is_corner {
            1.0 / half_thickness
        } else {
            0.0
        },
    }
}

/// Which way round a polygon runs: 1 counterclockwise as seen with the radius to the right and z up, −1 clockwise.
pub(crate) fn winding(corners: &[[f64; 2]]) -> f64 {
    let twice_area: f64 = corners
        .iter()
        .zip(corners.iter().cycle().skip(1))
        .map(|(start, end)| start[0] * end[1] - end[0] * start[1])
        .sum();
    twice_area.signum()
}

fn no_crossing(corners: &[[f64; 2]]) -> Result<(), ShapeError> {
    let count = corners.len();
    let side = |index: usize| (corners[index], corners[(index + 1) % count]);
    for first in 0..count {
        for second in first + 2..count {
            let are_adjacent = first == 0 && second == count - 1;
            if !are_adjacent && cross(side(first), side(second)) {
                return Err(ShapeError::CrossingSides { first, second });
            }
        }
    }
    Ok(())
}

type Side = ([f64; 2], [f64; 2]);

fn cross(a: Side, b: Side) -> bool {
    let turn = |o: [f64; 2], p: [f64; 2], q: [f64; 2]| {
        (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0])
    };
    let splits = |line: Side, other: Side| {
        turn(line.0, line.1, other.0) * turn(line.0, line.1, other.1) < 0.0
    };
    splits(a, b) && splits(b, a)
}
