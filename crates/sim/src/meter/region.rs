//! Density, velocity and agitation of the pellets in a box.
//!
//! A pellet counts with all of its volume where its center is inside, and not at all where it is not.
//! Choose a box of many pellets: one layer more or less at a side is then a small part.

use super::{Instrument, Values};
use crate::model::Model;
use crate::setup::Setup;
use crate::state::{State, vector};
use pelletflow_core::{Bounds, Vec3};
use std::f64::consts::PI;

/// Density, velocity and agitation of the pellets whose centers are in a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Region {
    /// The box.
    pub bounds: Bounds,
}

impl Instrument for Region {
    type Record = ();

    const NAME: &'static str = "box";

    fn mistakes(&self, _setup: &Setup) -> Vec<(&'static str, String)> {
        let Bounds { min, max } = self.bounds;
        if !self.bounds.is_finite() {
            return vec![(
                "max",
                "or `min` is not finite; expected two corners in m".into(),
            )];
        }
        let axes = ["x", "y", "z"].into_iter().enumerate();
        axes.filter(|&(axis, _)| min[axis] >= max[axis])
            .map(|(axis, name)| {
                let (low, high) = (min[axis], max[axis]);
                let message = format!(
                    "is {high} m along {name} and `min` {low} m; expected `min` below `max` on every axis, exchange them"
                );
                ("max", message)
            })
            .collect()
    }

    fn values(&self, (): &(), _model: &Model, state: &State) -> Values {
        let pellets = &state.pellets;
        let inside = || {
            (0..pellets.len())
                .filter(|&index| self.bounds.contains(vector(&pellets.position[index])))
        };
        let (mut count, mut mass, mut solid) = (0.0, 0.0, 0.0);
        let mut momentum = Vec3::zeros();
        for index in inside() {
            count += 1.0;
            mass += pellets.mass(index);
            solid += 4.0 / 3.0 * PI * pellets.position[index][3].powi(3);
            momentum += pellets.mass(index) * vector(&pellets.velocity[index]);
        }
        let per_mass = if mass > 0.0 { 1.0 / mass } else { 0.0 };
        let mean = per_mass * momentum;
        let mut squares = 0.0;
        for index in inside() {
            let deviation = vector(&pellets.velocity[index]) - mean;
            squares += pellets.mass(index) * deviation.norm_squared();
        }
        let volume = (self.bounds.max - self.bounds.min).product();
        vec![
            ("bulk_density_kg_per_m3", mass / volume),
            ("solid_fraction", solid / volume),
            ("velocity_x_m_per_s", mean.x),
            ("velocity_y_m_per_s", mean.y),
            ("velocity_z_m_per_s", mean.z),
            ("granular_temperature_m2_per_s2", per_mass * squares / 3.0),
            ("mass_kg", mass),
            ("pellets", count),
        ]
    }
}
