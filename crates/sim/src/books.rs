//! The accumulating part of the ledgers.

use crate::ledger::{ContactStatistics, PelletTally};
use crate::model::Model;
use pelletflow_core::Vec3;
use serde::{Deserialize, Serialize};

/// Mass, energy and contacts so far.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Books {
    /// Put in by fills and inlets.
    pub inserted: PelletTally,
    /// Now inside.
    pub inside: PelletTally,
    /// Left elsewhere than through an outlet.
    pub lost: PelletTally,
    /// Fed by each inlet.
    pub by_inlet: Vec<PelletTally>,
    /// Left through each outlet.
    pub by_outlet: Vec<PelletTally>,
    /// Mass flow through each outlet, averaged over the last tenth of a second [kg/s].
    pub outlet_flow: Vec<f64>,
    /// Energies at the start of the last step, and sums over the steps.
    pub energy: EnergyBooks,
    /// What contacts have done.
    pub contacts: ContactStatistics,
    /// Force of all pellets on each wall in the last step [N].
    pub wall_force: Vec<Vec3>,
    /// Sum of pellets over all steps [-].
    pub particle_steps: u64,
}

/// Energies at the start of the last step, and sums over the steps [J].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyBooks {
    /// Of motion and spin [J].
    pub kinetic: f64,
    /// In gravity, from the origin [J].
    pub potential: f64,
    /// In normal contact springs [J].
    pub elastic: f64,
    /// In contact springs against sliding, rolling and twisting [J].
    pub shear: f64,
    /// Turned into heat by the normal direction of contacts so far [J].
    pub damped: f64,
    /// Worked on springs, dampers and sliders against sliding, rolling and twisting so far [J].
    pub shear_work: f64,
    /// Brought in by pellets so far, less that taken out [J].
    pub carried_in: f64,
    /// Done by walls so far [J].
    pub wall_work: f64,
    /// The same without regard to sign [J].
    pub wall_work_size: f64,
    /// What the sums grew by in the last step.
    pub powers: Powers,
    /// Greatest throughput at the end of a step so far [J].
    pub greatest_throughput: f64,
}

/// What contacts and walls do in an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Powers {
    /// Turned into heat by the normal direction of contacts [W].
    pub damping: f64,
    /// Worked on springs, dampers and sliders against sliding, rolling and twisting [W].
    pub shear: f64,
    /// Done by walls [W].
    pub walls: f64,
}

impl Books {
    pub(crate) fn new(model: &Model) -> Self {
        let setup = model.setup();
        Self {
            by_inlet: vec![PelletTally::default(); setup.inlets.len()],
            by_outlet: vec![PelletTally::default(); setup.outlets.len()],
            outlet_flow: vec![0.0; setup.outlets.len()],
            wall_force: vec![Vec3::zeros(); setup.walls.len()],
            ..Self::default()
        }
    }
}

impl PelletTally {
    /// Counts one pellet of a mass [kg].
    pub(crate) fn add(&mut self, mass: f64) {
        self.count += 1;
        self.mass += mass;
    }

    /// Takes one pellet of a mass away [kg].
    pub(crate) fn remove(&mut self, mass: f64) {
        self.count -= 1;
        self.mass = if self.count == 0 {
            0.0
        } else {
            self.mass - mass
        };
    }
}

impl EnergyBooks {
    /// In all contact springs [J].
    pub fn stored(&self) -> f64 {
        self.elastic + self.shear
    }

    /// Turned into heat so far [J].
    pub fn dissipated(&self) -> f64 {
        self.damped + self.shear_work - self.shear
    }

    /// What the books miss [J].
    pub fn residual(&self) -> f64 {
        self.kinetic + self.potential + self.stored() + self.dissipated()
            - self.carried_in
            - self.wall_work
    }

    /// Energy that went through the books [J]: the greatest so far, since what swings between motion and height is less at
    /// the top of each swing.
    pub fn throughput(&self) -> f64 {
        self.throughput_now().max(self.greatest_throughput)
    }

    fn throughput_now(&self) -> f64 {
        self.kinetic + self.stored() + self.dissipated() + self.wall_work_size
    }

    /// Enters what was done since the last step, a time before [s]: with half of the power then and half of that now, because
    /// by now the pellets have felt half of the kick of now.
    pub(crate) fn work(&mut self, powers: Powers, time: f64) {
        let last = std::mem::replace(&mut self.powers, powers);
        let half = 0.5 * time;
        self.damped += half * (last.damping + powers.damping);
        self.shear_work += half * (last.shear + powers.shear);
        self.wall_work += half * (last.walls + powers.walls);
        self.wall_work_size += half * (last.walls.abs() + powers.walls.abs());
        self.greatest_throughput = self.throughput();
    }

    /// Enters pellets that come in (`sign` 1) or go out (−1) with these energies [J].
    pub(crate) fn carry(&mut self, sign: f64, kinetic: f64, potential: f64) {
        self.carried_in += sign * (kinetic + potential);
        self.kinetic += sign * kinetic;
        self.potential += sign * potential;
    }
}
