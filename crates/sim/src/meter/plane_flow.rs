//! Flow through a plane, or through a disc of it.
//!
//! A pellet crosses where its center is on the other side than a step before, so each crossing counts once, whatever
//! the step. Only pellets that were near the plane at the last neighbor search are looked at: between two searches
//! none moves by more than the skin.

use super::{Instrument, Values, Watched, averaged};
use crate::ledger::{MOST_COUNTED, PelletTally};
use crate::model::Model;
use crate::setup::Setup;
use crate::state::{Row, State, vector};
use pelletflow_core::{UnitVector3, Vec3};
use serde::{Deserialize, Serialize};

/// Mass and pellets that pass a plane or a disc of it, by direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneFlow {
    /// A point of the plane; the center of the disc [m].
    pub point: Vec3,
    /// Direction that counts as forward [-].
    pub normal: UnitVector3<f64>,
    /// Radius of the disc; infinite for the whole plane [m].
    pub radius: f64,
}

/// What has passed, and who may pass next.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Crossings {
    forward: PelletTally,
    backward: PelletTally,
    /// Net, averaged [kg/s].
    mass_flow: f64,
    /// Net, averaged [1/s].
    pellet_flow: f64,
    near: Vec<Near>,
}

/// A pellet near the plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Near {
    /// Place in storage.
    index: usize,
    is_beyond: bool,
}

impl PlaneFlow {
    /// Height of a center over the plane [m].
    fn height(&self, position: &Row) -> f64 {
        self.normal.dot(&(vector(position) - self.point))
    }

    /// Whether a pellet that has just changed sides did so within the disc.
    fn is_through(&self, state: &State, index: usize) -> bool {
        // The velocity that moved it: it takes the center back to the plane.
        let velocity = vector(&state.pellets.half_step_velocity[index]);
        let position = &state.pellets.position[index];
        let since = self.height(position) / self.normal.dot(&velocity);
        let crossing = vector(position) - since * velocity;
        (crossing - self.point).norm() <= self.radius
    }
}

impl Instrument for PlaneFlow {
    type Record = Crossings;

    const NAME: &'static str = "plane-flow";

    fn mistakes(&self, _setup: &Setup) -> Vec<(&'static str, String)> {
        let mut mistakes = super::not_finite("point", self.point);
        if self.radius.is_nan() || self.radius <= 0.0 {
            let message = format!("is {} m; expected more than 0", self.radius);
            mistakes.push(("radius", message));
        }
        mistakes
    }

    fn fits(&self, record: &Crossings, pellets: usize) -> bool {
        record.forward.count.max(record.backward.count) <= MOST_COUNTED
            && record.near.iter().all(|near| near.index < pellets)
    }

    fn list(&self, record: &mut Crossings, _model: &Model, state: &State) {
        let positions = state.pellets.position.iter().enumerate();
        record.near.clear();
        record
            .near
            .extend(positions.filter_map(|(index, position)| {
                let height = self.height(position);
                let is_near = height.abs() <= state.skin
                    && (vector(position) - self.point).norm() <= self.radius + 2.0 * state.skin;
                is_near.then_some(Near {
                    index,
                    is_beyond: height > 0.0,
                })
            }));
    }

    fn watch(&self, record: &mut Crossings, step: &Watched) {
        let pellets = &step.state.pellets;
        let (mut mass, mut count) = (0.0, 0.0);
        for near in &mut record.near {
            let is_beyond = self.height(&pellets.position[near.index]) > 0.0;
            if is_beyond == near.is_beyond {
                continue;
            }
            near.is_beyond = is_beyond;
            if self.is_through(step.state, near.index) {
                let (tally, sign) = if is_beyond {
                    (&mut record.forward, 1.0)
                } else {
                    (&mut record.backward, -1.0)
                };
                tally.add(pellets.mass(near.index));
                mass += sign * pellets.mass(near.index);
                count += sign;
            }
        }
        let time = step.time_step();
        record.mass_flow = averaged(record.mass_flow, mass / time, time);
        record.pellet_flow = averaged(record.pellet_flow, count / time, time);
    }

    fn values(&self, record: &Crossings, _model: &Model, _state: &State) -> Values {
        let Crossings {
            forward, backward, ..
        } = record;
        vec![
            ("mass_flow_kg_per_s", record.mass_flow),
            ("pellet_flow_per_s", record.pellet_flow),
            ("mass_kg", forward.mass - backward.mass),
            ("pellets", forward.count as f64 - backward.count as f64),
            ("forward_kg", forward.mass),
            ("forward_pellets", forward.count as f64),
            ("backward_kg", backward.mass),
            ("backward_pellets", backward.count as f64),
        ]
    }
}
