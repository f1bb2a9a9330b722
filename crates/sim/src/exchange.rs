//! Inlets, outlets and the border of the domain: who comes and who goes, and who comes round a periodic axis.
//!
//! Done only where neighbors are searched anew: between two searches no pellet moves by more than half the skin,
//! so nothing slips past an outlet or the border unseen.

use crate::error::StepError;
use crate::inlet;
use crate::meter;
use crate::model::Model;
use crate::state::{State, row, vector};
use crate::wall::WallNow;
use pelletflow_core::Vec3;

/// Lets pellets out and in; gives the rows to keep.
///
/// # Errors
/// A pellet has left the domain elsewhere than through an outlet, or an inlet cannot hold its rate.
pub(crate) fn exchange(
    model: &Model,
    state: &mut State,
    walls: &[WallNow],
) -> Result<Vec<u32>, StepError> {
    wrap(model, state);
    let mass_before: Vec<f64> = state
        .books
        .by_outlet
        .iter()
        .map(|outlet| outlet.mass)
        .collect();
    let mut kept = Vec::with_capacity(state.pellets.len());
    let mut lost = None;
    for index in 0..state.pellets.len() {
        let position = vector(&state.pellets.position[index]);
        let outlet = model
            .setup()
            .outlets
            .iter()
            .position(|outlet| outlet.region.distance(position) < 0.0);
        if let Some(outlet) = outlet {
            leave(model, state, index);
            meter::discharge(model, state, index);
            let mass = state.pellets.mass(index);
            state.books.by_outlet[outlet].add(mass);
        } else if model.setup().domain.bounds.contains(position) {
            kept.push(index as u32);
        } else {
            leave(model, state, index);
            let mass = state.pellets.mass(index);
            state.books.lost.add(mass);
            lost.get_or_insert_with(|| loss(model, state, walls, index, position));
        }
    }
    if let Some(loss) = lost {
        return Err(loss);
    }
    average_flows(model, state, &mass_before);
    for index in 0..model.setup().inlets.len() {
        inlet::feed(model, state, walls, index, &mut kept)?;
    }
    Ok(kept)
}

/// Brings back what has left through a periodic side; what that changes of its potential energy is carried.
fn wrap(model: &Model, state: &mut State) {
    let Some(periodic) = model.periodic() else {
        return;
    };
    for index in 0..state.pellets.len() {
        let position = vector(&state.pellets.position[index]);
        let wrapped = periodic.wrapped(position);
        if wrapped != position {
            let (_, before) = energies(model, state, index);
            state.pellets.position[index] = row(wrapped, state.pellets.position[index][3]);
            let (_, after) = energies(model, state, index);
            state.books.energy.carry(1.0, 0.0, after - before);
        }
    }
}

fn average_flows(model: &Model, state: &mut State, mass_before: &[f64]) {
    let elapsed = state.steps_since_search as f64 * model.time_step().seconds;
    if elapsed > 0.0 {
        let books = &mut state.books;
        for ((flow, outlet), before) in books
            .outlet_flow
            .iter_mut()
            .zip(&books.by_outlet)
            .zip(mass_before)
        {
            *flow = meter::averaged(*flow, (outlet.mass - before) / elapsed, elapsed);
        }
    }
}

fn leave(model: &Model, state: &mut State, index: usize) {
    let (kinetic, potential) = energies(model, state, index);
    state.books.energy.carry(-1.0, kinetic, potential);
    let mass = state.pellets.mass(index);
    state.books.inside.remove(mass);
}

/// Kinetic and potential energy of one pellet [J].
pub(crate) fn energies(model: &Model, state: &State, index: usize) -> (f64, f64) {
    let pellets = &state.pellets;
    let mass = pellets.mass(index);
    let translation = mass * vector(&pellets.velocity[index]).norm_squared();
    let rotation = vector(&pellets.spin[index]).norm_squared() / pellets.spin[index][3];
    let potential = -mass * model.setup().gravity.dot(&vector(&pellets.position[index]));
    (0.5 * (translation + rotation), potential)
}

fn loss(
    model: &Model,
    state: &State,
    walls: &[WallNow],
    index: usize,
    position: Vec3,
) -> StepError {
    let nearest = model
        .setup()
        .walls
        .iter()
        .zip(walls)
        .filter(|(_, now)| now.is_present)
        .map(|(wall, now)| {
            (
                &wall.name,
                wall.shape.distance(now.pose.inverse_point(position)),
            )
        })
        .min_by(|a, b| a.1.total_cmp(&b.1));
    StepError::Lost {
        pellet: state.pellets.id[index],
        position,
        speed: vector(&state.pellets.velocity[index]).norm(),
        nearest_wall: nearest.map_or_else(
            || String::from("none"),
            |(name, distance)| format!("`{name}` at {distance:.4} m"),
        ),
        step: state.step,
        time: state.step as f64 * model.time_step().seconds,
    }
}
