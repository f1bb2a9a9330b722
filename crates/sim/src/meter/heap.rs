//! Angle of repose of a heap, from the profile of its surface.
//!
//! The profile method, one of those that Al-Hashemi & Al-Amoudi (2018) compare: the free surface is cut by radial
//! profiles, each is fitted by a straight line, and the slope of the line is the angle. The surface is marked by the top
//! of the highest pellet in each upright column, one largest diameter wide: columns of one width everywhere, because the
//! highest of many pellets lies nearer to the surface than the highest of few. A profile is a sector of azimuth.
//! The rounded tip and the scattered toe are left out: the line goes through the part between a fifth and four fifths of
//! the way to the foot. That is twice the mean distance from the axis, weighed by height, as in a cone; chosen by distance
//! and not by height, because a choice by what scatters would flatten the line.
//! The angle is the mean over the sectors, and its scatter their standard deviation.

use super::sample::Sample;
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
/// Part of the way from the axis to the foot that is fitted [-].
const FLANK: Range<f64> = 0.2..0.8;
/// Fewest columns that a line is fitted to [-].
const FEWEST_COLUMNS: usize = 5;

/// Angle of repose of a heap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heap {
    /// Where the axis of the heap meets the ground [m].
    pub point: Vec3,
    /// Direction of the axis, out of the ground [-].
    pub up: UnitVector3<f64>,
}

/// A point of the surface: where it is seen from above, and its height over the ground [m].
#[derive(Debug, Clone, Copy)]
struct Top {
    east: f64,
    north: f64,
    height: f64,
}

impl Top {
    /// Distance from the axis [m].
    fn radius(&self) -> f64 {
        self.east.hypot(self.north)
    }

    fn sector(&self) -> usize {
        let turn = (self.north.atan2(self.east) / TAU).rem_euclid(1.0);
        ((turn * SECTORS as f64) as usize).min(SECTORS - 1)
    }
}

impl Heap {
    /// The surface, column by column.
    fn surface(&self, model: &Model, state: &State) -> Vec<Top> {
        let width = model.largest_diameter();
        // A pellet that has fallen by half a diameter or more is not part of the surface.
        let speed_squared = model.setup().gravity.norm() * width;
        let east = any_normal_to(self.up);
        let north = self.up.cross(&east);
        let mut columns = BTreeMap::<[i64; 2], Top>::new();
        let pellets = &state.pellets;
        for (position, velocity) in pellets.position.iter().zip(&pellets.velocity) {
            if vector(velocity).norm_squared() > speed_squared {
                continue;
            }
            let arm = vector(position) - self.point;
            let top = Top {
                east: arm.dot(&east),
                north: arm.dot(&north),
                height: arm.dot(&self.up) + position[3],
            };
            let column = [top.east, top.north].map(|place| (place / width).floor() as i64);
            let highest = columns.entry(column).or_insert(top);
            if top.height > highest.height {
                *highest = top;
            }
        }
        columns.into_values().collect()
    }
}

/// A unit vector at right angles to a direction.
fn any_normal_to(direction: UnitVector3<f64>) -> Vec3 {
    let axis = direction.iamin();
    let mut other = Vec3::zeros();
    other[axis] = 1.0;
    direction.cross(&other).normalize()
}

/// Angle of a profile's flank [rad], falling outward; nothing where too few columns show it.
fn slope(profile: &[Top]) -> Option<f64> {
    let (mut weight, mut moment) = (0.0, 0.0);
    for top in profile {
        weight += top.height;
        moment += top.height * top.radius();
    }
    let foot = 2.0 * moment / weight;
    let flank: Vec<(f64, f64)> = profile
        .iter()
        .map(|top| (top.radius(), top.height))
        .filter(|(radius, _)| FLANK.contains(&(radius / foot)))
        .collect();
    if flank.len() < FEWEST_COLUMNS {
        return None;
    }
    let count = flank.len() as f64;
    let mean_radius = flank.iter().map(|(radius, _)| radius).sum::<f64>() / count;
    let mean_height = flank.iter().map(|(_, height)| height).sum::<f64>() / count;
    let (mut square, mut product) = (0.0, 0.0);
    for (radius, height) in flank {
        square += (radius - mean_radius).powi(2);
        product += (radius - mean_radius) * (height - mean_height);
    }
    (square > 0.0).then(|| (-product / square).atan())
}

impl Instrument for Heap {
    type Record = ();

    const NAME: &'static str = "heap";

    fn mistakes(&self, _setup: &Setup) -> Vec<(&'static str, String)> {
        super::not_finite("point", self.point)
    }

    fn values(&self, (): &(), model: &Model, state: &State) -> Values {
        let mut profiles = vec![Vec::new(); SECTORS];
        let mut greatest_height: f64 = 0.0;
        for top in self.surface(model, state) {
            profiles[top.sector()].push(top);
            greatest_height = greatest_height.max(top.height);
        }
        let slopes = profiles.iter().filter_map(|profile| slope(profile));
        let angles = Sample::new(slopes.map(f64::to_degrees).collect());
        vec![
            ("angle_deg", angles.mean()),
            ("scatter_deg", angles.deviation()),
            ("sectors", angles.count() as f64),
            ("height_m", greatest_height),
        ]
    }
}
