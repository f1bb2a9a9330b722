//! The step, on one page: the physics in order.

use crate::advance::{MotionTally, advance};
use crate::error::StepError;
use crate::exchange::exchange;
use crate::forces::sum_loads;
use crate::health;
use crate::inlet;
use crate::meter;
use crate::model::Model;
use crate::neighbors;
use crate::profile::{Profile, Stage};
use crate::state::State;
use crate::tally::ForceTally;
use crate::wall::WallNow;
use crate::workspace::Workspace;

/// Advances the state by one time step.
///
/// # Errors
/// The physics failed; the state is that before the pellets moved, except after a loss.
pub(crate) fn step(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
) -> Result<(), StepError> {
    let mut profile = std::mem::take(&mut workspace.profile);
    let result = stages(model, state, workspace, &mut profile);
    workspace.profile = profile;
    result
}

fn stages(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    profile: &mut Profile,
) -> Result<(), StepError> {
    // Walls move: where each is now follows from the time alone.
    let time = state.step as f64 * model.time_step().seconds;
    profile.time(Stage::Walls, || {
        prescribe_walls(model, time, &mut workspace.walls);
        health::check_gates(model, state, &workspace.walls)
    })?;

    // Neighbors, if a pellet may have come near a new one; then pellets also come and go.
    if neighbors::is_search_due(model, state) || inlet::is_any_due(model, state) {
        let kept = profile.time(Stage::Exchange, || exchange(model, state, &workspace.walls))?;
        profile.time(Stage::Search, || {
            neighbors::search(model, state, workspace, &kept);
        });
        profile.time(Stage::Meters, || meter::list(model, state));
        health::check_energy(model, state)?;
    }

    // Contacts and forces.
    let contacts = profile.time(Stage::Forces, || sum_loads(model, state, workspace));
    health::check_overlap(model, state, &contacts)?;

    // Bodies move.
    let motion = profile.time(Stage::Motion, || advance(model, state, workspace));
    health::check_finite(model, state, &motion)?;

    // Meters watch and the books are kept.
    profile.time(Stage::Meters, || {
        meter::watch(model, state, &workspace.walls, &contacts.wall_touches);
    });
    enter(model, state, contacts, &motion);
    Ok(())
}

/// Puts every wall where it belongs at a time [s].
pub(crate) fn prescribe_walls(model: &Model, time: f64, walls: &mut Vec<WallNow>) {
    walls.clear();
    walls.extend(model.setup().walls.iter().map(|wall| wall.at(time)));
}

fn enter(model: &Model, state: &mut State, contacts: ForceTally, motion: &MotionTally) {
    let time_step = model.time_step().seconds;
    let books = &mut state.books;
    books.energy.kinetic = motion.kinetic;
    books.energy.potential = motion.potential;
    books.energy.elastic = contacts.elastic_energy;
    if state.step == 0 {
        // Points of a settled bed start with their springs loaded.
        books.energy.carried_in += contacts.elastic_energy;
    }
    books.energy.shear = contacts.shear_energy;
    books.energy.damped += time_step * contacts.dissipation;
    books.energy.shear_work += time_step * contacts.shear_power;
    books.energy.wall_work += time_step * contacts.wall_power;
    books.energy.wall_work_size += time_step * contacts.wall_power.abs();
    books.particle_steps += state.pellets.len() as u64;
    books.contacts.enter(&contacts, state.pellets.len());
    books.wall_force = contacts.wall_force;
    state.moved_since_search += time_step * motion.max_speed_squared.sqrt();
    state.steps_since_search += 1;
    state.step += 1;
}
