//! What a simulation had counted before a run began.

use crate::checkpoint::Spent;
use pelletflow_sim::{Phase, Simulation};

/// What a simulation had counted before the run began.
#[derive(Debug, Clone)]
pub(crate) struct CountsBefore {
    /// Pellets times steps [-].
    pub(crate) particle_steps: u64,
    /// Contacts times steps [-].
    pub(crate) contact_steps: u64,
    /// Time of each part of the step.
    pub(crate) phases: Vec<Phase>,
}

impl CountsBefore {
    pub(crate) fn of(simulation: &Simulation) -> Self {
        Self {
            particle_steps: simulation.particle_steps(),
            contact_steps: simulation.contact_statistics().contact_steps,
            phases: simulation.phases(),
        }
    }

    /// Of a run that goes on now and had taken something before it was interrupted.
    pub(crate) fn going_on(simulation: &Simulation, spent: &Spent) -> Self {
        let mut phases = simulation.phases();
        for (phase, spent) in phases.iter_mut().zip(&spent.phases) {
            phase.seconds -= spent;
        }
        Self {
            particle_steps: spent.particle_steps_before,
            contact_steps: spent.contact_steps_before,
            phases,
        }
    }

    /// What the run has taken of what a simulation counts; the rest is left at nothing.
    pub(crate) fn spent(&self, simulation: &Simulation) -> Spent {
        let phases = simulation.phases().into_iter().zip(&self.phases);
        Spent {
            phases: phases
                .map(|(now, before)| now.seconds - before.seconds)
                .collect(),
            particle_steps_before: self.particle_steps,
            contact_steps_before: self.contact_steps,
            ..Spent::default()
        }
    }
}
