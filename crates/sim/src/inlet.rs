//! Feeders: pellets at random places of a region, at a rate that is held.

use crate::error::StepError;
use crate::exchange::energies;
use crate::ledger::PelletTally;
use crate::model::Model;
use crate::random::{Draw, Purpose};
use crate::setup::{Inlet, Rate};
use crate::state::{NewPellet, State, vector};
use crate::wall::WallNow;
use pelletflow_core::Vec3;

/// Places tried for a pellet before it waits for the next search [-].
const TRIES: u32 = 60;
/// Time of feeding that an inlet may owe at first before the run fails [s].
const PATIENCE: f64 = 0.5;
/// Time after which an inlet must hold its rate [s].
const SETTLING_TIME: f64 = 1.0;
/// Share of what is due that an inlet may owe from then on [-].
const RATE_TOLERANCE: f64 = 0.01;
/// Share of a region that pellets put in at random may fill [-]; the jamming limit of random addition is 0.38.
const RANDOM_FILLING: f64 = 0.2;

/// Puts in the pellets that are due at an inlet, as far as there is room.
///
/// # Errors
/// In its first second the inlet owes more than it feeds in half of one, or a hundredth of all that was due later on.
pub(crate) fn feed(
    model: &Model,
    state: &mut State,
    walls: &[WallNow],
    index: usize,
    kept: &mut Vec<u32>,
) -> Result<(), StepError> {
    let inlet = &model.setup().inlets[index];
    let time = state.step as f64 * model.time_step().seconds;
    let mut near = pellets_near(model, inlet, state, kept);
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
            return check_rate(inlet, fed, &new, time);
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
    let position = model
        .periodic()
        .map_or(new.position, |periodic| periodic.wrapped(new.position));
    state
        .pellets
        .push(id, state.step, &NewPellet { position, ..*new }, behind);
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

/// Steps from one pellet that is due to the next, on average over the inlets that feed now [-]; infinite where none does.
pub(crate) fn steps_per_pellet(model: &Model, state: &State) -> f64 {
    let time_step = model.time_step().seconds;
    let time = state.step as f64 * time_step;
    let feeding = |inlet: &&Inlet| (inlet.start..inlet.end).contains(&time);
    let inlets = model.setup().inlets.iter().filter(feeding);
    let rate: f64 = inlets
        .map(|inlet| match inlet.rate {
            Rate::Mass(rate) => rate / model.mean_mass(inlet.pellets),
            Rate::Count(rate) => rate,
        })
        .sum();
    if rate > 0.0 {
        1.0 / (rate * time_step)
    } else {
        f64::INFINITY
    }
}

/// Greatest rate that an inlet's region can pass on, if a share of its box [-] is free for pellets [kg/s].
pub(crate) fn capacity(inlet: &Inlet, gravity: Vec3, density: f64, free_share: f64) -> f64 {
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
    RANDOM_FILLING * density * free_share * size.product() / clearing_time
}

/// What is due by now and not yet fed, in kg or in pellets.
fn owed(inlet: &Inlet, time: f64, fed_count: u64, fed_mass: f64) -> f64 {
    match inlet.rate {
        Rate::Mass(rate) => rate * feeding_time(inlet, time) - fed_mass,
        Rate::Count(rate) => rate * feeding_time(inlet, time) - fed_count as f64,
    }
}

/// How long an inlet has fed [s].
fn feeding_time(inlet: &Inlet, time: f64) -> f64 {
    (time.min(inlet.end) - inlet.start).max(0.0)
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

/// Centers and radii of the pellets in a region, and of the images of others that reach into it.
fn pellets_near(model: &Model, inlet: &Inlet, state: &State, kept: &[u32]) -> Vec<(Vec3, f64)> {
    let bounds = inlet.region.bounds();
    let positions = kept
        .iter()
        .map(|&index| &state.pellets.position[index as usize]);
    let is_near = |&(center, radius): &(Vec3, f64)| bounds.grown(radius).contains(center);
    match model.periodic() {
        None => positions
            .map(|position| (vector(position), position[3]))
            .filter(is_near)
            .collect(),
        Some(periodic) => positions
            .flat_map(|position| {
                let images = periodic.images(vector(position));
                images.map(|image| (image, position[3])).collect::<Vec<_>>()
            })
            .filter(is_near)
            .collect(),
    }
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

/// Refuses an inlet that found no room for a pellet and has fallen behind its rate.
fn check_rate(
    inlet: &Inlet,
    fed: PelletTally,
    next: &NewPellet,
    time: f64,
) -> Result<(), StepError> {
    let feeding_time = feeding_time(inlet, time);
    let (rate, fed, of_one, unit) = match inlet.rate {
        Rate::Mass(rate) => (rate, fed.mass, next.mass, "kg"),
        Rate::Count(rate) => (rate, fed.count as f64, 1.0, "pellets"),
    };
    let due = rate * feeding_time;
    let allowed = if feeding_time < SETTLING_TIME {
        PATIENCE * rate
    } else {
        // A single pellet may be more than the share.
        (RATE_TOLERANCE * due).max(of_one)
    };
    if due - fed <= allowed {
        return Ok(());
    }
    Err(StepError::InletBlocked {
        inlet: inlet.name.clone(),
        fed,
        due,
        unit,
        feeding_time,
        time,
    })
}
