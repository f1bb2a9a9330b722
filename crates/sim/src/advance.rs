//! Motion of the pellets: kick by the loads, drift by the velocity.
//!
//! A leapfrog. Each pellet carries its velocity at the half step, which the drift needs,
//! and the velocity that the contact laws see: predicted by the last acceleration to the full step, so that damping and
//! friction see positions and velocities of one instant (Vyas et al. 2024); only semi-implicit Euler does without.

use crate::chunk;
use crate::model::Model;
use crate::state::{Row, State, row, vector};
use crate::workspace::{Load, Workspace};
use pelletflow_core::Vec3;

/// What moving the pellets of one chunk showed.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct MotionTally {
    /// Kinetic energy at the start of the step [J].
    pub(crate) kinetic: f64,
    /// Potential energy at the start of the step [J].
    pub(crate) potential: f64,
    /// Square of the greatest speed; not a number if any is not [m²/s²].
    pub(crate) max_speed_squared: f64,
}

struct MotionChunk<'a> {
    position: &'a mut [Row],
    velocity: &'a mut [Row],
    spin: &'a mut [Row],
    half_step_velocity: &'a mut [Row],
    half_step_spin: &'a mut [Row],
    loads: &'a [Load],
}

/// Advances every pellet by one step.
pub(crate) fn advance(model: &Model, state: &mut State, workspace: &Workspace) -> MotionTally {
    let pellets = &mut state.pellets;
    let size = chunk::size(pellets.len());
    let work: Vec<MotionChunk> = pellets
        .position
        .chunks_mut(size)
        .zip(pellets.velocity.chunks_mut(size))
        .zip(pellets.spin.chunks_mut(size))
        .zip(pellets.half_step_velocity.chunks_mut(size))
        .zip(pellets.half_step_spin.chunks_mut(size))
        .zip(workspace.loads.chunks(size))
        .map(
            |(((((position, velocity), spin), half_step_velocity), half_step_spin), loads)| {
                MotionChunk {
                    position,
                    velocity,
                    spin,
                    half_step_velocity,
                    half_step_spin,
                    loads,
                }
            },
        )
        .collect();
    let gravity = model.setup().gravity;
    let time_step = model.time_step().seconds;
    let integrator = model.setup().integrator;
    let kick = Kick {
        before: integrator.kick_before(state.step, time_step),
        after: 0.5 * time_step,
        prediction: integrator.prediction(time_step),
        drift: time_step,
    };
    let has_rotation = model.has_rotation();
    chunk::map(workspace.is_parallel, work, |mut chunk| {
        let mut tally = translate(&mut chunk, gravity, &kick);
        if has_rotation {
            tally.kinetic += rotate(&mut chunk, &kick);
        }
        tally
    })
    .into_iter()
    .fold(MotionTally::default(), MotionTally::merged)
}

/// Times that the accelerations and velocities of one step act [s].
struct Kick {
    /// Acceleration, up to the full step.
    before: f64,
    /// Acceleration, from the full step on.
    after: f64,
    /// Acceleration, beyond that for the contact laws of the next step.
    prediction: f64,
    /// Velocity.
    drift: f64,
}

fn translate(chunk: &mut MotionChunk, gravity: Vec3, kick: &Kick) -> MotionTally {
    let mut tally = MotionTally::default();
    for (index, load) in chunk.loads.iter().enumerate() {
        let inverse_mass = chunk.velocity[index][3];
        let mass = 1.0 / inverse_mass;
        let acceleration = vector(&load.force) * inverse_mass + gravity;
        let before = vector(&chunk.half_step_velocity[index]);
        let now = before + kick.before * acceleration;
        let after = now + kick.after * acceleration;
        let position = vector(&chunk.position[index]);
        tally.kinetic += 0.5 * mass * now.norm_squared();
        tally.potential -= mass * gravity.dot(&position);
        let speed_squared = after.norm_squared();
        tally.max_speed_squared = greater_or_nan(tally.max_speed_squared, speed_squared);
        chunk.half_step_velocity[index] = row(after, 0.0);
        chunk.velocity[index] = row(after + kick.prediction * acceleration, inverse_mass);
        chunk.position[index] = row(position + kick.drift * after, chunk.position[index][3]);
    }
    tally
}

/// Turns the pellets of a chunk and gives their energy of spin [J].
fn rotate(chunk: &mut MotionChunk, kick: &Kick) -> f64 {
    let mut kinetic = 0.0;
    for (index, load) in chunk.loads.iter().enumerate() {
        let inverse_inertia = chunk.spin[index][3];
        let acceleration = inverse_inertia * vector(&load.torque);
        let now = vector(&chunk.half_step_spin[index]) + kick.before * acceleration;
        let after = now + kick.after * acceleration;
        kinetic += 0.5 * now.norm_squared() / inverse_inertia;
        chunk.half_step_spin[index] = row(after, 0.0);
        chunk.spin[index] = row(after + kick.prediction * acceleration, inverse_inertia);
    }
    kinetic
}

impl MotionTally {
    fn merged(self, other: Self) -> Self {
        Self {
            kinetic: self.kinetic + other.kinetic,
            potential: self.potential + other.potential,
            max_speed_squared: greater_or_nan(self.max_speed_squared, other.max_speed_squared),
        }
    }
}

/// The greater of two numbers, or NaN if one is: `f64::max` would drop it.
fn greater_or_nan(a: f64, b: f64) -> f64 {
    if a.is_nan() || a >= b { a } else { b }
}
