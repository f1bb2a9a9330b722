//! What a contact has done since first touch, followed at every step.
#![expect(
    clippy::inline_always,
    reason = "what is not inlined is not compiled for the instruction set"
)]

use crate::memory::ContactMemories;
use crate::model::Model;
use pelletflow_core::Vec3;
use pelletflow_core::contact::Batch;
use serde::{Deserialize, Serialize};

/// What a contact has done since first touch, in one cache line; empty where there is none.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[repr(align(64))]
pub struct Trace {
    /// Greatest normal force of any one step [N].
    pub sampled_force: f64,
    /// Sum of the normal forces of all steps [N].
    pub normal_forces: f64,
    /// Sum of the sizes of the tangential forces of all steps [N].
    pub tangential_forces: f64,
    /// Sum over all steps of the power taken from motion [W].
    pub powers: f64,
    /// Contact point under the greatest force, in the world [m].
    pub place: [f32; 3],
    /// Speed along the normal at first touch [m/s].
    pub approach_speed: f32,
    /// Speed past each other at first touch [m/s].
    pub sliding_speed: f32,
    /// `R*` under the greatest force [m].
    pub effective_radius: f32,
    /// Greatest force found between two steps [N].
    pub top_force: f32,
    /// Steps from first touch to the greatest force [-].
    pub steps_to_peak: u32,
}

const _: () = assert!(size_of::<Trace>() == 64);

/// Kinetic energy of the approach over the energy in the spring below which a sample counts as the top itself [-]: the
/// force could still rise by 0.6 of that share, as `F ∝ E^(3/5)`.
const AT_TOP: f64 = 5.0e-4;

/// Follows the contact in a lane one step on; `center` is that of its first body [m].
#[inline(always)]
pub(crate) fn follow(
    model: &Model,
    memories: &mut ContactMemories,
    slot: usize,
    (batch, lane): (&Batch, usize),
    center: &[f64; 4],
) {
    let steps = memories.rows[slot].steps;
    let trace = &mut memories.traces[slot];
    let [normal, tangential, power] = batch.exertion(lane);
    trace.normal_forces += normal;
    trace.tangential_forces += tangential;
    trace.powers += power;
    let force = batch.normal_force(lane);
    if steps == 0 {
        trace.begin(batch, lane);
    }
    if force > trace.sampled_force || steps == 0 {
        trace.rise(batch, lane, center, steps);
    } else if steps - 1 == trace.steps_to_peak {
        trace.look_back(model, batch, lane);
    }
}

impl Trace {
    /// Notes how the two bodies meet.
    fn begin(&mut self, batch: &Batch, lane: usize) {
        let contact = batch.contact(lane);
        let approach = -contact.relative_velocity.dot(&contact.normal);
        let sliding = contact.relative_velocity + approach * contact.normal;
        self.approach_speed = approach as f32;
        self.sliding_speed = sliding.norm() as f32;
    }

    /// Notes where the force is greater than ever.
    #[inline(always)]
    fn rise(&mut self, batch: &Batch, lane: usize, center: &[f64; 4], steps: u32) {
        let (normal, effective_radius) = batch.lie(lane);
        let arm = batch.arm(lane);
        self.sampled_force = batch.normal_force(lane);
        self.place = [0, 1, 2].map(|axis| (center[axis] - arm * normal[axis]) as f32);
        self.effective_radius = effective_radius as f32;
        self.steps_to_peak = steps;
    }

    /// Seeks the top of the force that lies behind the first sample that falls.
    #[inline(never)]
    fn look_back(&mut self, model: &Model, batch: &Batch, lane: usize) {
        let contact = batch.contact(lane);
        let speed = contact.relative_velocity.dot(&contact.normal);
        let kinetic = 0.5 * contact.effective_mass * speed.powi(2);
        let is_at_top = kinetic <= AT_TOP * batch.elastic_energy(lane);
        if is_at_top || batch.normal_force(lane) <= 0.0 {
            return;
        }
        let (laws, sampling) = (model.laws(), model.sampling());
        let history = batch.history(lane, laws);
        // It lies up to one and a half steps before this sample.
        let top = laws.peak_force_near(2, &contact, &batch.pair(lane), &history, sampling);
        self.top_force = self.top_force.max(top as f32);
    }

    /// Greatest normal force, between steps too [N].
    pub fn peak_force(&self) -> f64 {
        self.sampled_force.max(f64::from(self.top_force))
    }

    /// Contact point under the greatest force [m].
    pub fn place(&self) -> Vec3 {
        Vec3::from(self.place.map(f64::from))
    }
}
