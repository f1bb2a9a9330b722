//! All that a restart needs.

use crate::books::Books;
use crate::hit::HitLedger;
use crate::memory::ContactMemories;
use crate::meter::Record;
use crate::model::Model;
use crate::workspace::NextRows;
use pelletflow_core::Vec3;
use serde::{Deserialize, Serialize};

/// Three components and one companion, so that a pellet's share of an array is one half of a cache line.
pub type Row = [f64; 4];

/// The vector part of a row.
#[inline]
pub(crate) fn vector(row: &Row) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}

/// A row of a vector and its companion.
#[inline]
pub(crate) fn row(vector: Vec3, companion: f64) -> Row {
    [vector.x, vector.y, vector.z, companion]
}

/// Everything that a step changes and that the next one needs.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Steps taken [-].
    pub step: u64,
    /// The pellets, in storage order.
    pub pellets: Pellets,
    /// What each listed contact remembers, chunk by chunk, aligned with the neighbor lists.
    pub contacts: Vec<ChunkContacts>,
    /// Positions at the last neighbor search, from which the lists follow [m].
    pub searched_position: Vec<Row>,
    /// Reach of those lists beyond the pellets [m]; 0 before the first search.
    pub skin: f64,
    /// Bound of how far any pellet has moved since then [m].
    pub moved_since_search: f64,
    /// Steps since then [-].
    pub steps_since_search: u64,
    /// Mass, energy and contacts so far.
    pub books: Books,
    /// All hits so far.
    pub hits: HitLedger,
    /// What each meter has gathered, in the order of the setup.
    pub(crate) meters: Vec<Record>,
}

/// Pellets as columns; one index is one pellet.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Pellets {
    /// Permanent number [-].
    pub id: Vec<u32>,
    /// Index of the kind [-].
    pub kind: Vec<u16>,
    /// Center and radius: `x, y, z, R` [m].
    pub position: Vec<Row>,
    /// Velocity at the full step [m/s], and the inverse mass [1/kg].
    pub velocity: Vec<Row>,
    /// Spin at the full step [rad/s], and the inverse moment of inertia [1/(kg·m²)].
    pub spin: Vec<Row>,
    /// Velocity half a step earlier, which the leapfrog carries [m/s], and the mass [kg].
    pub half_step_velocity: Vec<Row>,
    /// Spin half a step earlier [rad/s], and the moment of inertia [kg·m²].
    pub half_step_spin: Vec<Row>,
    /// Step before which it came [-].
    pub born: Vec<u64>,
    /// Greatest force of a hit that has ended [N].
    pub hardest_hit: Vec<f64>,
}

/// What the contacts of one chunk remember.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ChunkContacts {
    /// With other pellets.
    pub pellet: ContactMemories,
    /// With walls.
    pub wall: ContactMemories,
    /// Normals of the contacts with walls in the last step, by which each knows its own again [-].
    pub wall_normals: Vec<Vec3>,
}

/// A pellet about to be stored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NewPellet {
    pub(crate) kind: usize,
    pub(crate) radius: f64,
    pub(crate) mass: f64,
    pub(crate) position: Vec3,
    pub(crate) velocity: Vec3,
    pub(crate) spin: Vec3,
}

impl Pellets {
    /// How many there are [-].
    pub fn len(&self) -> usize {
        self.id.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.id.is_empty()
    }

    /// Mass of one [kg].
    pub fn mass(&self, index: usize) -> f64 {
        1.0 / self.velocity[index][3]
    }

    /// Adds one before a step; `behind` is what its last kick lacks of its velocity [m/s].
    pub(crate) fn push(&mut self, id: u32, step: u64, new: &NewPellet, behind: Vec3) {
        let inverse_mass = 1.0 / new.mass;
        self.id.push(id);
        self.kind.push(new.kind as u16);
        self.position.push(row(new.position, new.radius));
        self.velocity.push(row(new.velocity, inverse_mass));
        self.spin
            .push(row(new.spin, 2.5 * inverse_mass / new.radius.powi(2)));
        self.half_step_velocity
            .push(row(new.velocity - behind, new.mass));
        self.half_step_spin
            .push(row(new.spin, 0.4 * new.mass * new.radius.powi(2)));
        self.born.push(step);
        self.hardest_hit.push(0.0);
    }

    /// Exchanges the rows that a step of a model moves with those of the next instant.
    pub(crate) fn exchange_rows(&mut self, model: &Model, next: &mut NextRows) {
        std::mem::swap(&mut self.position, &mut next.position);
        std::mem::swap(&mut self.velocity, &mut next.velocity);
        if model.has_rotation() {
            std::mem::swap(&mut self.spin, &mut next.spin);
        }
    }

    /// Keeps the rows named, in that order.
    pub(crate) fn select(&mut self, order: &[u32]) {
        let is_unchanged = order.len() == self.len() && order.is_sorted();
        if is_unchanged {
            return;
        }
        select(&mut self.id, order);
        select(&mut self.kind, order);
        select(&mut self.position, order);
        select(&mut self.velocity, order);
        select(&mut self.spin, order);
        select(&mut self.half_step_velocity, order);
        select(&mut self.half_step_spin, order);
        select(&mut self.born, order);
        select(&mut self.hardest_hit, order);
    }
}

fn select<T: Copy>(column: &mut Vec<T>, order: &[u32]) {
    if order.is_sorted() {
        // No row comes to a place that is still to be read.
        for (place, &index) in order.iter().enumerate() {
            column[place] = column[index as usize];
        }
        column.truncate(order.len());
    } else {
        *column = order.iter().map(|&index| column[index as usize]).collect();
    }
}
