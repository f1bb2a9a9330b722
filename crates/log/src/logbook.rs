//! What a run knows of what it has recorded.

use crate::recording::Due;
use crate::worst_hits::{WORST_HITS, WorstHits};
use pelletflow_sim::{RunPlan, Simulation};
use serde::{Deserialize, Serialize};

/// What later entries of a recording depend on, beside the simulation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Logbook {
    pub(crate) frame_due: Due,
    pub(crate) meters_due: Due,
    /// Which walls are there.
    pub(crate) is_present: Vec<bool>,
    /// Step of the last frame [-].
    pub(crate) last_frame: Option<u64>,
    /// Step of the last meter reading [-].
    pub(crate) last_reading: Option<u64>,
    pub(crate) worst_hits: WorstHits,
    /// Hits in the last sketch [-].
    pub(crate) sketched: u64,
}

impl Logbook {
    /// Of a run of which nothing is recorded yet.
    pub(crate) fn new(simulation: &Simulation, plan: &RunPlan) -> Self {
        let step = simulation.model().time_step().seconds;
        let start = simulation.time();
        Self {
            frame_due: Due::every(plan.frame_interval, step, start),
            meters_due: Due::every(plan.meter_interval, step, start),
            is_present: simulation.walls().map(|wall| wall.is_present).collect(),
            last_frame: None,
            last_reading: None,
            worst_hits: WorstHits::new(WORST_HITS),
            sketched: 0,
        }
    }

    /// Whether it can be that of a simulation; what does not fit.
    pub(crate) fn check(&self, simulation: &Simulation) -> Result<(), String> {
        let (told, walls) = (self.is_present.len(), simulation.walls().count());
        if told == walls {
            Ok(())
        } else {
            Err(format!("it tells of {told} walls, the scene of {walls}"))
        }
    }

    /// Moment at which something is due [s].
    pub(crate) fn next_due(&self) -> f64 {
        self.frame_due.next().min(self.meters_due.next())
    }
}
