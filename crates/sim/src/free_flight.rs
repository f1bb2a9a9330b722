//! Free flight: while no pellet is near anything, many steps are taken at once, with the bits of as many single ones.

use crate::advance::{Kick, dot, moved, squared, with};
use crate::chunk;
use crate::error::StepError;
use crate::health;
use crate::model::Model;
use crate::neighbors;
use crate::state::{State, row};
use crate::step::enter;
use crate::tally::greater;
use crate::workspace::{Load, Workspace};

/// Most steps at once [-].
const MOST_STEPS: usize = 64;

/// Flies for at most `most` steps, and gives how many it took: none where something is near or has to be looked at.
///
/// # Errors
/// Some pellet's speed is not finite or past the limit, at the end of the flight; what is told of it is from the beginning.
pub(crate) fn fly(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    most: u64,
) -> Result<u64, StepError> {
    if !is_free(model, state, workspace) {
        return Ok(0);
    }
    let most = most
        .min(MOST_STEPS as u64)
        .min(neighbors::steps_before_look(state.step));
    let steps = steps_before_search(model, state, most);
    if steps == 0 {
        return Ok(0);
    }
    let walls = model.setup().walls.len();
    workspace.tally.begin(walls, &state.books.contacts);
    for chunk in &mut workspace.chunks {
        chunk.loads.fill(Load::default());
    }
    let fastest = advance(model, state, workspace, steps as usize);
    health::check_speed(model, state, workspace)?;
    state.pellets.exchange_rows(model, &mut workspace.next);
    let time_step = model.time_step().seconds;
    for speed_squared in &fastest[..steps as usize - 1] {
        state.books.particle_steps += state.pellets.len() as u64;
        state.moved_since_search += time_step * speed_squared.sqrt();
        state.steps_since_search += 1;
        state.step += 1;
    }
    enter(model, state, workspace);
    workspace.free_steps += steps;
    Ok(steps)
}

/// Whether no list names anything, and nothing else has to be done step by step.
fn is_free(model: &Model, state: &State, workspace: &Workspace) -> bool {
    let setup = model.setup();
    setup.skips.free_flight
        && workspace.is_free
        && state.step > 0
        && setup.meters.is_empty()
        && setup.inlets.is_empty()
        && setup
            .walls
            .iter()
            .all(|wall| wall.schedule.changes().is_empty())
}

/// Steps that may be taken before neighbors must be sought, at most `most` [-].
fn steps_before_search(model: &Model, state: &State, most: u64) -> u64 {
    let time_step = model.time_step().seconds;
    let velocities = state.pellets.half_step_velocity.iter();
    let fastest = velocities.map(squared).fold(0.0, greater).sqrt();
    let gained = time_step * model.setup().gravity.norm();
    let mut steps = most;
    while steps > 0 {
        let ahead = steps as f64 * time_step * (fastest + steps as f64 * gained);
        if !neighbors::is_search_due_after(model, state, ahead, steps) {
            break;
        }
        steps /= 2;
    }
    steps
}

/// What flying showed of the pellets of one chunk.
struct Flown {
    kinetic: f64,
    potential: f64,
    /// Square of the greatest speed after each step [m²/s²].
    fastest: [f64; MOST_STEPS],
}

/// Advances every pellet; gives the square of the greatest speed after each step [m²/s²].
fn advance(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    steps: usize,
) -> [f64; MOST_STEPS] {
    let kick = Kick::new(model, state.step);
    let gravity = row(model.setup().gravity, 0.0);
    let nothing = Load::default();
    let has_rotation = model.has_rotation();
    let pellets = &mut state.pellets;
    let size = chunk::size(pellets.len());
    workspace.next.resize(pellets.len());
    let next = &mut workspace.next;
    let chunks = chunk::ranges(pellets.len())
        .zip(pellets.half_step_velocity.chunks_mut(size))
        .zip(pellets.half_step_spin.chunks_mut(size))
        .zip(next.position.chunks_mut(size))
        .zip(next.velocity.chunks_mut(size))
        .zip(next.spin.chunks_mut(size));
    let (positions, velocities, spins) = (&pellets.position, &pellets.velocity, &pellets.spin);
    let flown = chunk::map(
        workspace.is_parallel,
        chunks.collect(),
        |(((((range, half_step), half_step_spin), next_position), next_velocity), next_spin)| {
            let mut flown = Flown {
                kinetic: 0.0,
                potential: 0.0,
                fastest: [0.0; MOST_STEPS],
            };
            let mut of_spin = 0.0;
            for (local, index) in range.enumerate() {
                let (mut position, mut after) = (positions[index], half_step[local]);
                let (mass, inverse_mass) = (after[3], velocities[index][3]);
                // The very operations of a step without contacts, for the sake of signed zeros too.
                let acceleration = moved(&gravity, inverse_mass, &nothing.force);
                let (mut now, mut before) = (after, position);
                for fastest in &mut flown.fastest[..steps] {
                    now = moved(&after, kick.before, &acceleration);
                    after = moved(&now, kick.after, &acceleration);
                    before = position;
                    position = moved(&position, kick.drift, &after);
                    *fastest = greater(*fastest, squared(&after));
                }
                flown.kinetic += 0.5 * mass * squared(&now);
                flown.potential -= mass * dot(&gravity, &before);
                half_step[local] = with(after, mass);
                next_position[local] = with(position, positions[index][3]);
                let velocity = moved(&after, kick.prediction, &acceleration);
                next_velocity[local] = with(velocity, inverse_mass);
                if has_rotation {
                    // Nothing turns it: every kick leaves the spin as it is, and so does the prediction.
                    let (inertia, inverse_inertia) = (half_step_spin[local][3], spins[index][3]);
                    let spin = moved(&half_step_spin[local], kick.before, &nothing.torque);
                    of_spin += 0.5 * inertia * squared(&spin);
                    half_step_spin[local] = with(spin, inertia);
                    next_spin[local] = with(spin, inverse_inertia);
                }
            }
            flown.kinetic += of_spin;
            flown
        },
    );
    let mut fastest = [0.0; MOST_STEPS];
    let tally = &mut workspace.tally;
    for chunk in &flown {
        tally.kinetic += chunk.kinetic;
        tally.potential += chunk.potential;
        for (all, own) in fastest.iter_mut().zip(&chunk.fastest) {
            *all = greater(*all, *own);
        }
    }
    tally.max_speed_squared = fastest[steps - 1];
    fastest
}
