//! Whether a state read back can be one of a model.

use crate::model::Model;
use crate::state::{Pellets, State};

/// Looks at everything that indices lead into, and at what lists are made from.
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
    let mut meters = state.meters.iter().zip(&setup.meters);
    if let Some((_, meter)) = meters.find(|(record, meter)| !record.is_of(&meter.kind)) {
        let name = &meter.name;
        return Err(format!("meter `{name}` is of another kind"));
    }
    let pellets = &state.pellets;
    check_columns(pellets)?;
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
    let rows = state.searched_position.iter().chain(&pellets.position);
    let mut values = rows.flatten().chain([&state.skin]);
    if !values.all(|value| value.is_finite()) || state.skin < 0.0 {
        return Err("a pellet or the skin is nowhere".into());
    }
    if state.steps_since_search > state.step {
        return Err("its last neighbor search was before its first step".into());
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
