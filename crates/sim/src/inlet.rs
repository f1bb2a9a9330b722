//! Feeders: pellets at random places of a region, at a rate that is held.

use crate::error::StepError;
use crate::exchange::energies;
use crate::model::Model;
use crate::random::{Draw, Purpose};
use crate::setup::{Inlet, Rate};
use crate::state::{NewPellet, State, vector};
use crate::wall::WallNow;
use pelletflow_core::Vec3;

/// Places tried for a pellet before it waits for the next search [-].
const TRIES: u32 = 60;
/// Time of feeding that an inlet may owe before the run fails [s].
const PATIENCE: f64 = 0.5;
/// Share of a region that pellets put in at random may fill [-]; the jamming limit of random addition is 0.38.
const RANDOM_FILLING: f64 = 0.2;

/// Puts in the pellets that are due at an inlet, as far as there is room.
///
/// # Errors
/// More is owed than the inlet feeds in half a second.
pub(crate) fn feed(
    model: &Model,
    state: &mut State,
    walls: &[WallNow],
    index: usize,
    kept: &mut Vec<u32>,
) -> Result<(), StepError> {
    let inlet = &model.setup().inlets[index];
    let time = state.step as f64 * model.time_step().seconds;
    let mut near = pellets_near(inlet, state, kept);
    loop {
        let fed = state.books.by_inlet[index];
        let new = next_pellet(model, index, fed.count);
        let owed = owed(inlet, time, fed.count, fed.mass);
        // Half a pellet early on average is half a pellet late on average: the rate is not biased.
        let due = match inlet.rate {
            Rate::Mass(_) => 0.5 * new.mass,
            Rate::Count(_) => 0.5,
        };
        if owed < due {
            return Ok(());
        }
        let Some(position) = free_place(model, state, walls, index, &new, &near) else {
            return check_patience(inlet, owed, new.mass, time);
        };
        let new = NewPellet { position, ..new };
        near.push((position, new.radius));
        kept.push(state.pellets.len() as u32);
        insert(model, state, &new);
        state.books.by_inlet[index].add(new.mass);
    }
}

/// Stores a new pellet and enters it in the books.
pub(crate) fn insert(model: &Model, state: &mut State, new: &NewPellet) {
    let id = state.books.inserted.count as u32;
    let setup = model.setup();
    let time_step = model.time_step().seconds;
    // All that is there at the first step starts at the full step.
    let behind = if state.step == 0 {
        Vec3::zeros()
    } else {
        setup.integrator.prediction(time_step) * setup.gravity
    };
    state.pellets.push(id, state.step, new, behind);
    let (kinetic, potential) = energies(model, state, state.pellets.len() - 1);
    state.books.energy.carry(1.0, kinetic, potential);
    state.books.inserted.add(new.mass);
    state.books.inside.add(new.mass);
}

/// Whether an inlet owes a pellet, so that a search is worth its cost.
pub(crate) fn is_any_due(model: &Model, state: &State) -> bool {
    let time = state.step as f64 * model.time_step().seconds;
    model
        .setup()
        .inlets
        .iter()
        .zip(&state.books.by_inlet)
        .any(|(inlet, fed)| {
            let owed = owed(inlet, time, fed.count, fed.mass);
            match inlet.rate {
                Rate::Mass(_) => owed >= model.mean_mass(inlet.pellets),
                Rate::Count(_) => owed >= 1.0,
            }
        })
}

/// Greatest rate that an inlet's region can pass on [kg/s].
pub(crate) fn capacity(inlet: &Inlet, gravity: Vec3, density: f64) -> f64 {
    let size = inlet.region.bounds().max - inlet.region.bounds().min;
    let speed = inlet.velocity.norm();
    let fall = gravity.norm();
    let way = if speed > 0.0 {
        size.dot(&inlet.velocity.abs()) / speed
    } else if fall > 0.0 {
        size.dot(&gravity.abs()) / fall
    } else {
        return 0.0;
    };
    let along = if speed > 0.0 {
        gravity.dot(&inlet.velocity).max(0.0) / speed
    } else {
        fall
    };
    let clearing_time = 2.0 * way / (speed + (speed * speed + 2.0 * along * way).sqrt());
    RANDOM_FILLING * density * size.product() / clearing_time
}

/// What is due by now and not yet fed, in kg or in pellets.
fn owed(inlet: &Inlet, time: f64, fed_count: u64, fed_mass: f64) -> f64 {
    let feeding_time = (time.min(inlet.end) - inlet.start).max(0.0);
    match inlet.rate {
        Rate::Mass(rate) => rate * feeding_time - fed_mass,
        Rate::Count(rate) => rate * feeding_time - fed_count as f64,
    }
}

fn next_pellet(model: &Model, index: usize, serial: u64) -> NewPellet {
    let inlet = &model.setup().inlets[index];
    let kind = &model.setup().pellets[inlet.pellets];
    let mut draw = Draw::new(model.setup().seed, Purpose::InletSize(index), serial);
    let radius = kind.size.draw(&mut draw) / 2.0;
    NewPellet {
        kind: inlet.pellets,
        radius,
        mass: model.mass(inlet.pellets, radius),
        position: Vec3::zeros(),
        velocity: inlet.velocity,
        spin: Vec3::zeros(),
    }
}

fn pellets_near(inlet: &Inlet, state: &State, kept: &[u32]) -> Vec<(Vec3, f64)> {
    let bounds = inlet.region.bounds();
    kept.iter()
        .map(|&index| &state.pellets.position[index as usize])
        .filter(|position| bounds.grown(position[3]).contains(vector(position)))
        .map(|position| (vector(position), position[3]))
        .collect()
}

fn free_place(
    model: &Model,
    state: &State,
    walls: &[WallNow],
    index: usize,
    new: &NewPellet,
    near: &[(Vec3, f64)],
) -> Option<Vec3> {
    let setup = model.setup();
    let inlet = &setup.inlets[index];
    let bounds = inlet.region.bounds().grown(-new.radius);
    let serial = state.books.by_inlet[index].count;
    // The step keys the draw as well: a pellet that found no room must not try the same places again.
    let mut draw = Draw::new(setup.seed, Purpose::InletPlace(index, state.step), serial);
    (0..TRIES).map(|_| draw.point(&bounds)).find(|&place| {
        let is_inside = inlet.region.distance(place) <= -new.radius;
        let is_clear = |&(other, radius): &(Vec3, f64)| {
            (other - place).norm_squared() > (radius + new.radius).powi(2)
        };
        let is_clear_of_wall = |(wall, now): (&crate::wall::Wall, &WallNow)| {
            !now.is_present || wall.shape.distance(now.pose.inverse_point(place)) > new.radius
        };
        is_inside
            && near.iter().all(is_clear)
            && setup.walls.iter().zip(walls).all(is_clear_of_wall)
    })
}

fn check_patience(inlet: &Inlet, owed: f64, mass: f64, time: f64) -> Result<(), StepError> {
    let (patience, owed_mass) = match inlet.rate {
        Rate::Mass(rate) => (owed / rate, owed),
        Rate::Count(rate) => (owed / rate, owed * mass),
    };
    if patience <= PATIENCE {
        return Ok(());
    }
    Err(StepError::InletBlocked {
        inlet: inlet.name.clone(),
        owed: owed_mass,
        patience: PATIENCE,
        time,
    })
}
