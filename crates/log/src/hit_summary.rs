//! The hits of a run in numbers.

use pelletflow_sim::Simulation;
use serde::{Deserialize, Serialize};

/// Contacts followed from first touch to release, and those still open at the end.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HitSummary {
    /// How many [-].
    pub count: u64,
    /// How many of them are recorded in full [-].
    pub recorded: u64,
    /// Force from which on every hit is recorded in full [N]; where there is none, only those are that no hit of one of
    /// their pellets had reached before.
    pub threshold_n: Option<f64>,
    /// Normal impulse of all [N·s].
    pub normal_impulse_n_s: f64,
    /// Tangential impulse of all, by its size [N·s].
    pub tangential_impulse_n_s: f64,
    /// Energy that they took from motion [J].
    pub lost_energy_j: f64,
}

impl HitSummary {
    pub(crate) fn of(simulation: &Simulation) -> Option<Self> {
        let request = simulation.model().setup().hits.as_ref()?;
        let total = simulation.hits_with_open().total();
        Some(Self {
            count: total.count,
            recorded: total.kept,
            threshold_n: request.threshold.is_finite().then_some(request.threshold),
            normal_impulse_n_s: total.normal_impulse,
            tangential_impulse_n_s: total.tangential_impulse,
            lost_energy_j: total.lost_energy,
        })
    }
}
