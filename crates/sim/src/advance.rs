//! Motion of the pellets: kick by the loads, drift by the velocity.
//!
//! A leapfrog. Each pellet carries its velocity at the half step, which the drift needs,
//! and the velocity that the contact laws see: predicted by the last acceleration to the full step, so that damping and
//! friction see positions and velocities of one instant (Vyas et al. 2024); only semi-implicit Euler does without.
#![expect(
    clippy::inline_always,
    reason = "what is not inlined is not compiled for the instruction set"
)]

use crate::model::Model;
use crate::share::Share;
use crate::state::{Row, row};
use crate::tally::greater;
use pelletflow_core::instructions::Task;

/// Moves the chunk's pellets by one step.
pub(crate) fn advance(share: &mut Share) {
    let kick = Kick::new(share.model, share.step);
    let instructions = share.model.instructions();
    instructions.run(Translation { share, kick });
    if share.model.has_rotation() {
        instructions.run(Rotation { share, kick });
    }
}

/// Times that the accelerations and velocities of one step act [s].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kick {
    /// Acceleration, up to the full step.
    pub(crate) before: f64,
    /// Acceleration, from the full step on.
    pub(crate) after: f64,
    /// Acceleration, beyond that for the contact laws of the next step.
    pub(crate) prediction: f64,
    /// Velocity.
    pub(crate) drift: f64,
}

impl Kick {
    pub(crate) fn new(model: &Model, step: u64) -> Self {
        let time_step = model.time_step().seconds;
        let integrator = model.setup().integrator;
        Self {
            before: integrator.kick_before(step, time_step),
            after: 0.5 * time_step,
            prediction: integrator.prediction(time_step),
            drift: time_step,
        }
    }
}

struct Translation<'a, 'b> {
    share: &'a mut Share<'b>,
    kick: Kick,
}

impl Task for Translation<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { share, kick } = self;
        let gravity = row(share.model.setup().gravity, 0.0);
        let positions = &share.pellets.position[share.range.clone()];
        let velocities = &share.pellets.velocity[share.range.clone()];
        let (mut kinetic, mut potential, mut fastest) = (0.0, 0.0, 0.0);
        for ((((load, position), velocity), half_step), (next_position, next_velocity)) in share
            .scratch
            .loads
            .iter()
            .zip(positions)
            .zip(velocities)
            .zip(share.half_step_velocity.iter_mut())
            .zip(
                share
                    .next_position
                    .iter_mut()
                    .zip(share.next_velocity.iter_mut()),
            )
        {
            // Whole rows, companions and all: one instruction for four numbers.
            let (inverse_mass, mass) = (velocity[3], half_step[3]);
            let acceleration = moved(&gravity, inverse_mass, &load.force);
            let now = moved(half_step, kick.before, &acceleration);
            let after = moved(&now, kick.after, &acceleration);
            kinetic += 0.5 * mass * squared(&now);
            potential -= mass * dot(&gravity, position);
            fastest = greater(fastest, squared(&after));
            *next_position = with(moved(position, kick.drift, &after), position[3]);
            *next_velocity = with(moved(&after, kick.prediction, &acceleration), inverse_mass);
            *half_step = with(after, mass);
        }
        let tally = &mut share.scratch.tally;
        tally.kinetic = kinetic;
        tally.potential = potential;
        tally.max_speed_squared = fastest;
    }
}

struct Rotation<'a, 'b> {
    share: &'a mut Share<'b>,
    kick: Kick,
}

impl Task for Rotation<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { share, kick } = self;
        let spins = &share.pellets.spin[share.range.clone()];
        let mut kinetic = 0.0;
        for (((load, spin), half_step), next_spin) in share
            .scratch
            .loads
            .iter()
            .zip(spins)
            .zip(share.half_step_spin.iter_mut())
            .zip(share.next_spin.iter_mut())
        {
            let (inverse_inertia, inertia) = (spin[3], half_step[3]);
            let acceleration = moved(&[0.0; 4], inverse_inertia, &load.torque);
            let now = moved(half_step, kick.before, &acceleration);
            let after = moved(&now, kick.after, &acceleration);
            kinetic += 0.5 * inertia * squared(&now);
            *next_spin = with(
                moved(&after, kick.prediction, &acceleration),
                inverse_inertia,
            );
            *half_step = with(after, inertia);
        }
        share.scratch.tally.kinetic += kinetic;
    }
}

#[inline(always)]
pub(crate) fn moved(from: &Row, time: f64, rate: &Row) -> Row {
    [
        from[0] + time * rate[0],
        from[1] + time * rate[1],
        from[2] + time * rate[2],
        from[3] + time * rate[3],
    ]
}

#[inline(always)]
pub(crate) fn with(row: Row, companion: f64) -> Row {
    [row[0], row[1], row[2], companion]
}

#[inline(always)]
pub(crate) fn dot(a: &Row, b: &Row) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub(crate) fn squared(row: &Row) -> f64 {
    dot(row, row)
}
