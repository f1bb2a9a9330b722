//! One case of a study: an integrator and a step.

use super::{AccuracyError, AccuracyRequest};
use pelletflow_core::Vec3;
use pelletflow_sim::{Integrator, Model, Setup, SetupError, Simulation, StepError, StepRequest};
use std::time::Instant;

/// A relative error and how sure it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The error [-].
    pub value: f64,
    /// Half the width of its 95 % confidence interval; 0 where it is that of one run [-].
    pub half_width: f64,
}

impl Estimate {
    /// The largest error that cannot be ruled out [-].
    pub fn bound(&self) -> f64 {
        self.value + self.half_width
    }
}

/// A case and how it came out.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// How forces became motion.
    pub integrator: Integrator,
    /// The step [s].
    pub time_step: f64,
    /// Steps per contact of the fastest hit expected [-].
    pub steps_per_contact: f64,
    /// Steps of one run, each with one force evaluation per contact [-].
    pub steps: u64,
    /// Time of one run by the wall clock [s].
    pub wall_time: f64,
    /// Relative errors, in the order of the study's quantities [-].
    pub errors: Vec<Estimate>,
}

impl Trial {
    pub(super) fn new(
        integrator: Integrator,
        time_step: f64,
        steps_per_contact: f64,
        outcomes: &[Outcome],
        errors: impl FnOnce(&[Outcome]) -> Vec<Estimate>,
    ) -> Self {
        let wall_times: f64 = outcomes.iter().map(|outcome| outcome.wall_time).sum();
        Self {
            integrator,
            time_step,
            steps_per_contact,
            steps: outcomes.first().map_or(0, |outcome| outcome.steps),
            wall_time: wall_times / outcomes.len() as f64,
            errors: errors(outcomes),
        }
    }

    /// The largest error that cannot be ruled out, over all quantities [-].
    pub fn worst(&self) -> f64 {
        self.errors.iter().map(Estimate::bound).fold(0.0, f64::max)
    }
}

/// Keys of the quantities that runs are compared by, as in the summary.
pub(super) const KEYS: [&str; 4] = [
    "contacts.max_force_n",
    "energy.dissipated_j",
    "energy.kinetic_j",
    "mass.discharged",
];

/// Why a run has no outcome.
pub(super) enum Failure {
    Setup(SetupError),
    Step(StepError),
}

/// What one run came to.
pub(super) struct Outcome {
    pub(super) values: [f64; KEYS.len()],
    pub(super) contact_steps: u64,
    pub(super) diameter: f64,
    steps: u64,
    wall_time: f64,
    /// Centers by number of the pellet.
    places: Vec<(u32, Vec3)>,
}

impl Outcome {
    /// Root mean square distance of the pellets' places [m]; none where the pellets inside are not the same.
    pub(super) fn distance(&self, other: &Self) -> Option<f64> {
        if self.places.len() != other.places.len() {
            return None;
        }
        let mut sum = 0.0;
        for ((id, place), (other_id, other_place)) in self.places.iter().zip(&other.places) {
            if id != other_id {
                return None;
            }
            sum += (place - other_place).norm_squared();
        }
        Some((sum / (self.places.len() as f64).max(1.0)).sqrt())
    }
}

/// Shortest contact expected in a setup [s].
pub(super) fn shortest_contact(setup: &Setup) -> Result<f64, AccuracyError> {
    let model = Model::new(setup.clone()).map_err(AccuracyError::Setup)?;
    Ok(model.time_step().shortest_contact)
}

/// Runs a setup with an integrator and a step [s].
pub(super) fn run(
    setup: &Setup,
    integrator: Integrator,
    time_step: f64,
    request: &AccuracyRequest,
) -> Result<Outcome, Failure> {
    // All runs end at one moment.
    let steps = (request.end_time / time_step).ceil().max(1.0);
    let setup = Setup {
        integrator,
        step: StepRequest::Fixed(request.end_time / steps),
        // Nobody asks what the hits were.
        hits: None,
        ..setup.clone()
    };
    let first = |mut mistakes: Vec<SetupError>| Failure::Setup(mistakes.swap_remove(0));
    let model = Model::new(setup).map_err(first)?;
    let diameter = model.largest_diameter();
    let mut simulation = Simulation::new(model, request.threads).map_err(first)?;
    let began = Instant::now();
    simulation.advance(steps as u64).map_err(Failure::Step)?;
    let wall_time = began.elapsed().as_secs_f64();
    let contacts = simulation.contact_statistics();
    let energy = simulation.energy_ledger();
    let mut places: Vec<_> = simulation
        .pellets()
        .map(|pellet| (pellet.id, pellet.position))
        .collect();
    places.sort_unstable_by_key(|&(id, _)| id);
    Ok(Outcome {
        values: [
            contacts.max_force,
            energy.dissipated,
            energy.kinetic,
            simulation.mass_ledger().discharged.mass,
        ],
        contact_steps: contacts.contact_steps,
        diameter,
        steps: simulation.step_count(),
        wall_time,
        places,
    })
}
