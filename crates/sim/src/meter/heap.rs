//! Angle of repose of a heap, from the profile of its surface.
//!
//! The profile method, one of those that Al-Hashemi & Al-Amoudi (2018) compare: the free surface is cut by radial
//! profiles, each is fitted by a straight line, and the slope of the line is the angle. Here a profile is a sector of
//! azimuth; in it the highest pellet of each ring, one largest diameter wide, marks the surface with the top of it.
//! The rounded tip and the scattered toe are left out: the line goes through the part between a fifth and four fifths of
//! the profile's height. The angle is the mean over the sectors, and its scatter their standard deviation.

use super::{Instrument, Values};
use crate::model::Model;
use crate::setup::Setup;
use crate::state::{State, vector};
use pelletflow_core::{UnitVector3, Vec3};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::Range;

/// Profiles about the axis [-].
const SECTORS: usize = 12;
/// Part of a profile's height that is fitted [-].
const FLANK: Range<f64> = 0.2..0.8;
/// Fewest rings that a line is fitted to [-].
const FEWEST_RINGS: usize = 3;

/// Angle of repose of a heap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heap {
    /// Where the axis of the heap meets the ground [m].
    pub point: Vec3,
    /// Direction of the axis, out of the ground [-].
    pub up: UnitVector3<f64>,
}

/// A point of the surface: distance from the axis and height over the ground [m].
#[derive(Debug, Clone, Copy)]
struct Top {
    radius: f64,
    height: f64,
}

impl Heap {
    /// The surface in each sector, ring by ring.
    fn profiles(&self, model: &Model, state: &State) -> Vec<Vec<Top>> {
        let ring_width = model.largest_diameter();
        let pellets = &state.pellets;
        // A pellet that has fallen by half a diameter or more is not part of the surface.
        let speed_squared = model.setup().gravity.norm() * ring_width;
        let east = any_normal_to(self.up);
        let north = self.up.cross(&east);
        let mut profiles = vec![BTreeMap::<usize, Top>::new(); SECTORS];
        for (position, velocity) in pellets.position.iter().zip(&pellets.velocity) {
            if vector(velocity).norm_squared() > speed_squared {
                continue;
            }
            let arm = vector(position) - self.point;
            let (x, y) = (arm.dot(&east), arm.dot(&north));
            let top = Top {
                radius: x.hypot(y),
                height: arm.dot(&self.up) + position[3],
            };
            let turn = (y.atan2(x) / TAU).rem_euclid(1.0);
            let sector = ((turn * SECTORS as f64) as usize).min(SECTORS - 1);
            let ring = profiles[sector].entry((top.radius / ring_width) as usize);
            let highest = ring.or_insert(top);
            if top.height > highest.height {
                *highest = top;
            }
        }
        let surface = |rings: BTreeMap<usize, Top>| rings.into_values().collect();
        profiles.into_iter().map(surface).collect()
    }
}

/// A unit vector at right angles to a direction.
fn any_normal_to(direction: UnitVector3<f64>) -> Vec3 {
    let axis = direction.iamin();
    let mut other = Vec3::zeros();
    other[axis] = 1.0;
    direction.cross(&other).normalize()
}

/// Angle of a profile's flank [rad], falling outward; nothing where too few rings show it.
fn slope(profile: &[Top]) -> Option<f64> {
    let height = greatest_height(profile);
    let flank: Vec<&Top> = profile
        .iter()
        .filter(|top| FLANK.contains(&(top.height / height)))
        .collect();
    if flank.len() < FEWEST_RINGS {
        return None;
    }
    let count = flank.len() as f64;
    let mean_radius = flank.iter().map(|top| top.radius).sum::<f64>() / count;
    let mean_height = flank.iter().map(|top| top.height).sum::<f64>() / count;
    let (mut square, mut product) = (0.0, 0.0);
    for top in flank {
        square += (top.radius - mean_radius).powi(2);
        product += (top.radius - mean_radius) * (top.height - mean_height);
    }
    (square > 0.0).then(|| (-product / square).atan())
}

fn greatest_height(profile: &[Top]) -> f64 {
    profile.iter().map(|top| top.height).fold(0.0, f64::max)
}

impl Instrument for Heap {
    type Record = ();

    const NAME: &'static str = "heap";

    fn mistakes(&self, _setup: &Setup) -> Vec<(&'static str, String)> {
        super::not_finite("point", self.point)
    }

    fn values(&self, (): &(), model: &Model, state: &State) -> Values {
        let profiles = self.profiles(model, state);
        let angles: Vec<f64> = profiles
            .iter()
            .filter_map(|profile| slope(profile))
            .collect();
        let count = angles.len();
        let mean = angles.iter().sum::<f64>() / count.max(1) as f64;
        let squares: f64 = angles.iter().map(|angle| (angle - mean).powi(2)).sum();
        let scatter = (squares / (count.max(2) - 1) as f64).sqrt();
        let height = profiles
            .iter()
            .map(|profile| greatest_height(profile))
            .fold(0.0, f64::max);
        vec![
            ("angle_deg", mean.to_degrees()),
            ("scatter_deg", scatter.to_degrees()),
            ("sectors", count as f64),
            ("height_m", height),
        ]
    }
}
