//! Motion of the pellets: kick by the loads, drift by the velocity.
//!
//! Velocity Verlet in its leapfrog form. Each pellet carries its velocity at the half step, which the drift needs,
//! and at the full step, predicted by the last acceleration, which the contact laws need: damping and friction then
//! see positions and velocities of one instant (Vyas et al. 2024).

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
    let has_rotation = model.has_rotation();
    chunk::map(workspace.is_parallel, work, |mut chunk| {
        let mut tally = translate(&mut chunk, gravity, time_step);
        if has_rotation {
            tally.kinetic += rotate(&mut chunk, time_step);
        }
        tally
    })
    .into_iter()
    .fold(MotionTally::default(), MotionTally::merged)
}

fn translate(chunk: &mut MotionChunk, gravity: Vec3, time_step: f64) -> MotionTally {
    let mut tally = MotionTally::default();
    for (index, load) in chunk.loads.iter().enumerate() {
        let inverse_mass = chunk.velocity[index][3];
        let mass = 1.0 / inverse_mass;
        let acceleration = vector(&load.force) * inverse_mass + gravity;
        let half_kick = 0.5 * time_step * acceleration;
        let before = vector(&chunk.half_step_velocity[index]);
        let now = before + half_kick;
        let after = now + half_kick;
        let position = vector(&chunk.position[index]);
        tally.kinetic += 0.5 * mass * now.norm_squared();
        tally.potential -= mass * gravity.dot(&position);
        let speed_squared = after.norm_squared();
        tally.max_speed_squared = greater_or_nan(tally.max_speed_squared, speed_squared);
        chunk.half_step_velocity[index] = row(after, 0.0);
        chunk.velocity[index] = row(after + half_kick, inverse_mass);
        chunk.position[index] = row(position + time_step * after, chunk.position[index][3]);
    }
    tally
}

/// Turns the pellets of a chunk and gives their energy of spin [J].
fn rotate(chunk: &mut MotionChunk, time_step: f64) -> f64 {
    let mut kinetic = 0.0;
    for (index, load) in chunk.loads.iter().enumerate() {
        let inverse_inertia = chunk.spin[index][3];
        let half_kick = 0.5 * time_step * inverse_inertia * vector(&load.torque);
        let now = vector(&chunk.half_step_spin[index]) + half_kick;
        let after = now + half_kick;
        kinetic += 0.5 * now.norm_squared() / inverse_inertia;
        chunk.half_step_spin[index] = row(after, 0.0);
        chunk.spin[index] = row(after + half_kick, inverse_inertia);
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
