//! Whether a state read back can be one of a model.

use crate::ledger::MOST_COUNTED;
use crate::model::Model;
use crate::setup::Setup;
use crate::state::{Pellets, Row, State};

/// Looks at everything that indices lead into, at what lists are made from, and at what is counted on.
///
/// # Errors
/// What does not fit.
pub(super) fn check(model: &Model, state: &State) -> Result<(), String> {
    let setup = model.setup();
    let books = &state.books;
    let counts = [
        ("inlets", books.by_inlet.len(), setup.inlets.len()),
        ("outlets", books.by_outlet.len(), setup.outlets.len()),
        ("outlets", books.outlet_flow.len(), setup.outlets.len()),
        ("walls", books.wall_force.len(), setup.walls.len()),
        ("meters", state.meters.len(), setup.meters.len()),
    ];
    for (what, found, expected) in counts {
        same(what, found, expected)?;
    }
    let pellets = &state.pellets;
    let mut meters = state.meters.iter().zip(&setup.meters);
    let misfit = meters.find(|(record, meter)| !record.fits(&meter.kind, pellets.len()));
    if let Some((_, meter)) = misfit {
        let name = &meter.name;
        return Err(format!("meter `{name}` cannot have gathered what it holds"));
    }
    check_columns(pellets)?;
    check_counts(state)?;
    if !state.hits.fits(setup.walls.len()) {
        return Err("it counts hits that there are none of".into());
    }
    let kinds = setup.pellets.len();
    if let Some(kind) = pellets
        .kind
        .iter()
        .find(|&&kind| usize::from(kind) >= kinds)
    {
        return Err(format!("a pellet is of kind {kind} of {kinds}"));
    }
    let listed = state.searched_position.len();
    if state.step > 0 || listed > 0 {
        same("listed pellets", listed, pellets.len())?;
    }
    let mut rows = state.searched_position.iter().chain(&pellets.position);
    if !rows.all(|row| is_there(setup, row)) {
        return Err(
            "a pellet is nowhere near the domain, or of a size that there is none of".into(),
        );
    }
    if !(state.skin.is_finite() && state.skin >= 0.0) {
        return Err(format!("the skin of its lists is {} m", state.skin));
    }
    if state.steps_since_search > state.step {
        return Err("its last neighbor search was before its first step".into());
    }
    Ok(())
}

/// Whether a pellet can be where a row tells, and as large: cells of the neighbor search are made from both.
fn is_there(setup: &Setup, row: &Row) -> bool {
    let bounds = setup.domain.bounds;
    // A pellet that left the domain since it was last looked for is not far.
    let margin = (bounds.max - bounds.min).max();
    let is_near =
        |axis: usize| (bounds.min[axis] - margin..=bounds.max[axis] + margin).contains(&row[axis]);
    let diameters = setup.pellets.iter().map(|kind| kind.size.max_diameter());
    let largest = diameters.fold(0.0, f64::max);
    (0..3).all(is_near) && row[3] > 0.0 && row[3] <= largest
}

/// Looks at everything that a step adds to or takes from.
fn check_counts(state: &State) -> Result<(), String> {
    let (step, books, contacts) = (state.step, &state.books, &state.books.contacts);
    let ways = books.by_inlet.iter().chain(&books.by_outlet);
    let tallies = ways.chain([&books.inserted, &books.lost]);
    let mut counts = tallies.map(|tally| tally.count).chain([
        step,
        books.particle_steps,
        contacts.finished,
        contacts.contact_steps,
    ]);
    if let Some(count) = counts.find(|&count| count > MOST_COUNTED) {
        return Err(format!(
            "it counts {count} of something; expected at most {MOST_COUNTED}"
        ));
    }
    if books.inside.count != state.pellets.len() as u64 {
        let (told, found) = (books.inside.count, state.pellets.len());
        return Err(format!(
            "its books tell of {told} pellets inside, and it has {found}"
        ));
    }
    if let Some(born) = state.pellets.born.iter().find(|&&born| born > step) {
        return Err(format!(
            "a pellet came before step {born}, after its step {step}"
        ));
    }
    Ok(())
}

fn check_columns(pellets: &Pellets) -> Result<(), String> {
    let Pellets {
        id,
        kind,
        position,
        velocity,
        spin,
        half_step_velocity,
        half_step_spin,
        born,
        hardest_hit,
    } = pellets;
    let rows = [position, velocity, spin, half_step_velocity, half_step_spin];
    let columns = [kind.len(), born.len(), hardest_hit.len()];
    for found in rows.map(Vec::len).into_iter().chain(columns) {
        same("pellets", found, id.len())?;
    }
    Ok(())
}

fn same(what: &str, found: usize, expected: usize) -> Result<(), String> {
    if found == expected {
        Ok(())
    } else {
        Err(format!("it has {found} {what}, the scene {expected}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::NewPellet;
    use pelletflow_core::Vec3;

    /// A state of one pellet after ten steps.
    fn state() -> State {
        let mut state = State {
            step: 10,
            ..State::default()
        };
        let pellet = NewPellet {
            kind: 0,
            radius: 0.006,
            mass: 0.003,
            position: Vec3::zeros(),
            velocity: Vec3::zeros(),
            spin: Vec3::zeros(),
        };
        state.pellets.push(0, 4, &pellet, Vec3::zeros());
        state.books.inside.count = 1;
        state
    }

    #[test]
    fn counts_that_a_step_would_overflow_are_refused() {
        assert_eq!(check_counts(&state()), Ok(()));
        let forgeries: [fn(&mut State); 5] = [
            |state| state.step = u64::MAX,
            |state| state.books.contacts.contact_steps = u64::MAX,
            |state| state.books.inserted.count = MOST_COUNTED + 1,
            |state| state.books.inside.count = 0,
            |state| state.pellets.born[0] = 11,
        ];
        for (number, forge) in forgeries.iter().enumerate() {
            let mut state = state();
            forge(&mut state);
            assert!(check_counts(&state).is_err(), "forgery {number}");
        }
    }
}
