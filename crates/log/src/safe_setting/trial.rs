//! One run in memory, scored.

use super::SafeSettingError;
use crate::breakage::{Breakage, BreakageRequest, breakage};
use crate::course::stride;
use crate::ending::end_of;
use crate::hits::RecordedHits;
use pelletflow_impact::StrengthLaw;
use pelletflow_sim::{HitRequest, Model, RunPlan, Setup, SetupError, Simulation};
use std::ops::ControlFlow;

/// A run and how it is scored.
pub(super) struct Trial<'a> {
    pub(super) plan: &'a RunPlan,
    pub(super) breakage: &'a BreakageRequest,
    pub(super) threads: usize,
    /// Value of the setting, for messages.
    pub(super) value: f64,
}

impl Trial<'_> {
    /// Runs to the end; `watch` is told which part is done [-].
    pub(super) fn run(
        &self,
        mut setup: Setup,
        watch: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<Breakage, SafeSettingError> {
        // Where every blow leaves a trace all of them are kept, else those that are harder than all before.
        let has_damage = matches!(&self.breakage.law, StrengthLaw::Energy(_));
        setup.hits = Some(HitRequest {
            threshold: if has_damage { 0.0 } else { f64::INFINITY },
        });
        let invalid = |errors: Vec<SetupError>| SafeSettingError::Setup {
            value: self.value,
            reason: errors
                .iter()
                .map(ToString::to_string)
                .collect::<Vec<_>>()
                .join("\n"),
        };
        let model = Model::new(setup).map_err(invalid)?;
        let step = model.time_step().seconds;
        let mut simulation = Simulation::new(model, self.threads).map_err(invalid)?;
        while end_of(&simulation, self.plan).is_none() {
            let next = self.plan.end_time;
            simulation
                .advance(stride(simulation.time(), next, step))
                .map_err(|source| SafeSettingError::Run {
                    value: self.value,
                    source,
                })?;
            if watch(simulation.time() / self.plan.end_time).is_break() {
                return Err(SafeSettingError::Interrupted);
            }
        }
        let recorded = RecordedHits::of(&mut simulation);
        if recorded.classes.is_empty() {
            return Err(SafeSettingError::NoHits { value: self.value });
        }
        Ok(breakage(&recorded, self.breakage)?)
    }
}
