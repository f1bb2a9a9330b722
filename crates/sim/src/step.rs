//! The step, on one page: the physics in order.

use crate::advance::advance;
use crate::books::Powers;
use crate::error::StepError;
use crate::exchange::exchange;
use crate::free_flight;
use crate::health;
use crate::hit;
use crate::inlet;
use crate::meter;
use crate::model::Model;
use crate::neighbors;
use crate::pair_contacts;
use crate::profile::{Profile, Stage};
use crate::share::each_chunk;
use crate::state::State;
use crate::wall::WallNow;
use crate::wall_contacts;
use crate::workspace::Workspace;

/// Advances the state by one time step, or by up to `most` where nothing is near anything; gives how many.
///
/// # Errors
/// The physics failed; the pellets are where they were before the step, except after a loss.
pub(crate) fn step(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    most: u64,
) -> Result<u64, StepError> {
    let mut profile = std::mem::take(&mut workspace.profile);
    let result = stages(model, state, workspace, &mut profile, most);
    workspace.profile = profile;
    result
}

fn stages(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    profile: &mut Profile,
    most: u64,
) -> Result<u64, StepError> {
    // Walls move: where each is now follows from the time alone.
    let time = state.step as f64 * model.time_step().seconds;
    profile.sample(state.step, Stage::Walls, || {
        prescribe_walls(model, time, &mut workspace.walls);
        health::check_gates(model, state, &workspace.walls)
    })?;

    // Neighbors, if a pellet may have come near a new one or many have changed places; then pellets also come and go.
    let is_search_due = neighbors::is_search_due(model, state)
        || inlet::is_any_due(model, state)
        || neighbors::is_order_due(model, state, workspace.is_parallel);
    if is_search_due {
        let kept = profile.time(Stage::Exchange, || {
            let kept = exchange(model, state, &workspace.walls)?;
            hit::end_leaving(model, state, workspace, &kept);
            Ok(kept)
        })?;
        profile.time(Stage::Search, || {
            neighbors::search(model, state, workspace, &kept);
            pair_contacts::note_lists(state, workspace);
        });
        profile.time(Stage::Meters, || meter::list(model, state));
        health::check_energy(model, state)?;
    }

    let flown = free_flight::fly(model, state, workspace, most)?;
    if flown > 0 {
        return Ok(flown);
    }

    // Contacts become forces and forces motion: of each chunk by itself, from rows as they are to rows as they will be.
    each_chunk(model, state, workspace, profile, |share| {
        share.stage(Stage::PairContacts, pair_contacts::add_forces);
        share.stage(Stage::WallContacts, wall_contacts::add_forces);
        share.stage(Stage::Motion, advance);
    });
    health::check_overlap(model, state, &workspace.tally)?;
    health::check_speed(model, state, workspace)?;

    // Contacts that ended become hits, bodies move, meters watch and the books are kept.
    hit::enter(model, state, workspace);
    state.pellets.exchange_rows(model, &mut workspace.next);
    profile.sample(state.step, Stage::Meters, || {
        meter::watch(
            model,
            state,
            &workspace.walls,
            &workspace.tally.wall_touches,
        );
    });
    enter(model, state, workspace);
    Ok(1)
}

/// Puts every wall where it belongs at a time [s].
pub(crate) fn prescribe_walls(model: &Model, time: f64, walls: &mut Vec<WallNow>) {
    walls.clear();
    walls.extend(model.setup().walls.iter().map(|wall| wall.at(time)));
}

/// Enters the tally of one step into the books.
pub(crate) fn enter(model: &Model, state: &mut State, workspace: &Workspace) {
    let time_step = model.time_step().seconds;
    let tally = &workspace.tally;
    let did = &tally.totals;
    let books = &mut state.books;
    books.energy.kinetic = tally.kinetic;
    books.energy.potential = tally.potential;
    books.energy.elastic = did.elastic_energy;
    books.energy.shear = did.shear_energy;
    let powers = Powers {
        damping: did.dissipation,
        shear: did.shear_power,
        walls: tally.wall_power,
    };
    if state.step == 0 {
        // Points of a settled bed start with their springs loaded.
        books.energy.carried_in += did.elastic_energy;
        books.energy.powers = powers;
    } else {
        books.energy.work(powers, time_step);
    }
    books.particle_steps += state.pellets.len() as u64;
    books.contacts.enter(tally, state.pellets.len());
    books.wall_force.clone_from(&tally.wall_force);
    state.moved_since_search += time_step * tally.max_speed_squared.sqrt();
    state.steps_since_search += 1;
    state.step += 1;
}
