//! Model, state and workspace together.

use crate::error::{SetupError, StepError};
use crate::ledger::{ContactStatistics, EnergyLedger, MassLedger};
use crate::model::Model;
use crate::pellet::PelletView;
use pelletflow_core::Pose;

/// A run in memory.
#[derive(Debug)]
pub struct Simulation {
    model: Model,
}

/// A wall at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallView {
    /// Index of the wall in the setup [-].
    pub index: usize,
    /// Where it is: `world_from_body`.
    pub pose: Pose,
    /// Whether it is there.
    pub is_present: bool,
}

/// What a meter reads.
#[derive(Debug, Clone, PartialEq)]
pub struct MeterReading {
    /// Name in the scene.
    pub name: String,
    /// What kind of meter it is, as in the scene: `mass-flow`, `wall-force`.
    pub kind: &'static str,
    /// Quantity with its unit in the name, such as `mass_flow_kg_per_s`, and its value.
    pub values: Vec<(&'static str, f64)>,
}

/// Wall-clock time of one part of the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// Which part.
    pub name: &'static str,
    /// Time spent so far [s].
    pub seconds: f64,
}

/// Work that was left out.
#[derive(Debug, Clone, PartialEq)]
pub struct Skipped {
    /// What was skipped.
    pub what: &'static str,
    /// Why it could be.
    pub reason: String,
    /// What it saved, in words with a number.
    pub saved: String,
}

impl Simulation {
    /// Places the fills and readies the first step; `threads` of 0 means one per core [-].
    ///
    /// # Errors
    /// Every fill that does not fit, with its key.
    pub fn new(model: Model, threads: usize) -> Result<Self, Vec<SetupError>> {
        let _ = threads;
        Ok(Self { model })
    }

    /// Advances by one time step.
    ///
    /// # Errors
    /// The physics failed; the run cannot go on.
    pub fn step(&mut self) -> Result<(), StepError> {
        Ok(())
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        0.0
    }

    /// Steps taken [-].
    pub fn step_count(&self) -> u64 {
        0
    }

    /// Threads at work [-].
    pub fn threads(&self) -> usize {
        1
    }

    /// Pellets inside [-].
    pub fn pellet_count(&self) -> usize {
        0
    }

    /// Pellets inside, in storage order, which changes; sort by id where order matters.
    pub fn pellets(&self) -> impl ExactSizeIterator<Item = PelletView> + '_ {
        std::iter::empty::<PelletView>()
            .collect::<Vec<_>>()
            .into_iter()
    }

    /// Walls, in the order of the setup.
    pub fn walls(&self) -> impl ExactSizeIterator<Item = WallView> + '_ {
        std::iter::empty::<WallView>()
            .collect::<Vec<_>>()
            .into_iter()
    }

    /// Where every pellet went.
    pub fn mass_ledger(&self) -> MassLedger {
        MassLedger::default()
    }

    /// Where the energy went.
    pub fn energy_ledger(&self) -> EnergyLedger {
        EnergyLedger::default()
    }

    /// What contacts have done.
    pub fn contact_statistics(&self) -> ContactStatistics {
        ContactStatistics::default()
    }

    /// What the meters read, in the order of the setup.
    pub fn meter_readings(&self) -> Vec<MeterReading> {
        Vec::new()
    }

    /// Wall-clock time of each part of the step so far.
    pub fn phases(&self) -> Vec<Phase> {
        Vec::new()
    }

    /// Work that was left out so far.
    pub fn skipped(&self) -> Vec<Skipped> {
        Vec::new()
    }

    /// Sum of pellets over all steps taken [-].
    pub fn particle_steps(&self) -> u64 {
        0
    }

    /// Hash of the state in order of pellet number, as 32 hexadecimal digits: equal only for equal bits.
    pub fn state_hash(&self) -> String {
        String::new()
    }
}
