//! What the contacts of one chunk did in one step; merged in chunk order.

use crate::model::Model;
use pelletflow_core::{Contact, ContactForce, ContactHistory, MaterialPair, Vec3};

/// The other body of a contact, by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Partner {
    Pellet(usize),
    Wall(usize),
}

/// The deepest contact met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DeepestContact {
    pub(crate) ratio: f64,
    pub(crate) pellet: usize,
    pub(crate) partner: Partner,
}

/// Sums and extremes over contacts.
#[derive(Debug, Clone)]
pub(crate) struct ForceTally {
    /// Open contacts.
    pub(crate) open: u64,
    /// Open contacts with walls.
    pub(crate) open_with_walls: u64,
    pub(crate) max_force: f64,
    pub(crate) deepest: Option<DeepestContact>,
    pub(crate) elastic_energy: f64,
    pub(crate) dissipation: f64,
    pub(crate) shear_energy: f64,
    pub(crate) shear_power: f64,
    pub(crate) wall_power: f64,
    pub(crate) wall_force: Vec<Vec3>,
    /// Contacts that closed.
    pub(crate) finished: u64,
    pub(crate) finished_steps: u64,
    pub(crate) fewest_steps: u32,
}

impl ForceTally {
    pub(crate) fn new(walls: usize, max_force_so_far: f64) -> Self {
        Self {
            open: 0,
            open_with_walls: 0,
            max_force: max_force_so_far,
            deepest: None,
            elastic_energy: 0.0,
            dissipation: 0.0,
            shear_energy: 0.0,
            shear_power: 0.0,
            wall_power: 0.0,
            wall_force: vec![Vec3::zeros(); walls],
            finished: 0,
            finished_steps: 0,
            fewest_steps: u32::MAX,
        }
    }

    /// Enters an open contact; `contact` is asked for only where its force may be the greatest so far.
    #[inline]
    pub(crate) fn open(
        &mut self,
        force: &ContactForce,
        contact: impl FnOnce() -> (Contact, MaterialPair, ContactHistory),
        model: &Model,
    ) {
        self.open += 1;
        self.elastic_energy += force.elastic_energy;
        self.dissipation += force.dissipation;
        self.shear_energy += force.shear_energy;
        self.shear_power += force.shear_power;
        // Between two steps the force rises by at most a few percent; only a likely record is looked at closely.
        if force.normal > 0.9 * self.max_force {
            let (contact, pair, history) = contact();
            let peak = model
                .laws()
                .peak_force_near(&contact, &pair, &history, model.sampling());
            self.max_force = self.max_force.max(peak);
        }
    }

    /// Enters the depth of a contact over the radius that it is measured by.
    #[inline]
    pub(crate) fn depth(&mut self, ratio: f64, pellet: usize, partner: Partner) {
        if self.deepest.is_none_or(|deepest| ratio > deepest.ratio) {
            self.deepest = Some(DeepestContact {
                ratio,
                pellet,
                partner,
            });
        }
    }

    /// Enters the end of a contact that was open for a number of steps.
    #[inline]
    pub(crate) fn finish(&mut self, steps: u32) {
        self.finished += 1;
        self.finished_steps += u64::from(steps);
        self.fewest_steps = self.fewest_steps.min(steps);
    }

    /// Both together; the order of merging fixes the bits.
    pub(crate) fn merged(mut self, other: Self) -> Self {
        self.open += other.open;
        self.open_with_walls += other.open_with_walls;
        self.max_force = self.max_force.max(other.max_force);
        if let Some(deepest) = other.deepest {
            self.depth(deepest.ratio, deepest.pellet, deepest.partner);
        }
        self.elastic_energy += other.elastic_energy;
        self.dissipation += other.dissipation;
        self.shear_energy += other.shear_energy;
        self.shear_power += other.shear_power;
        self.wall_power += other.wall_power;
        for (mine, theirs) in self.wall_force.iter_mut().zip(other.wall_force) {
            *mine += theirs;
        }
        self.finished += other.finished;
        self.finished_steps += other.finished_steps;
        self.fewest_steps = self.fewest_steps.min(other.fewest_steps);
        self
    }
}
