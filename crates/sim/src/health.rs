//! Health: what makes a run stop rather than go on wrong.

use crate::error::StepError;
use crate::model::Model;
use crate::state::{Row, State, vector};
use crate::tally::{DeepestContact, Partner, Tally};
use crate::wall::{Wall, WallNow};
use crate::workspace::Workspace;

/// Overlap over the radius up to which a wall may appear on a pellet [-]: the energy that comes from nowhere is that of
/// a fall through a millimeter or so.
const GATE_OVERLAP: f64 = 0.01;

/// Energy below which rounding decides, per joule of the greatest energy a pellet held [J].
const NEGLIGIBLE_THROUGHPUT: f64 = 1.0e-9;

/// Refuses overlaps past their limit, before the pellets move.
///
/// # Errors
/// The deepest contact is past the limit.
pub(crate) fn check_overlap(model: &Model, state: &State, tally: &Tally) -> Result<(), StepError> {
    let limit = model.setup().limits.overlap_ratio;
    match tally.deepest {
        Some(DeepestContact {
            ratio,
            pellet,
            partner,
        }) if ratio > limit => Err(StepError::Overlap {
            pellet: state.pellets.id[pellet],
            partner: match partner {
                Partner::Pellet(index) => format!("pellet {}", state.pellets.id[index]),
                Partner::Wall(index) => format!("wall `{}`", model.setup().walls[index].name),
            },
            ratio,
            limit,
            step: state.step,
            time: state.step as f64 * model.time_step().seconds,
        }),
        _ => Ok(()),
    }
}

/// Refuses walls that appear where pellets are: such an overlap is not the work of any force.
///
/// # Errors
/// A wall that was not there in the last step cuts into a pellet.
pub(crate) fn check_gates(
    model: &Model,
    state: &State,
    walls: &[WallNow],
) -> Result<(), StepError> {
    if state.step == 0 {
        return Ok(());
    }
    let time_step = model.time_step().seconds;
    let last_time = (state.step - 1) as f64 * time_step;
    let closing = |(wall, now): &(&Wall, &WallNow)| {
        !wall.schedule.changes().is_empty()
            && now.is_present
            && !wall.schedule.is_present(last_time)
    };
    for (wall, now) in model.setup().walls.iter().zip(walls).filter(closing) {
        let (mut pellets, mut deepest, mut ratio) = (0, 0, GATE_OVERLAP);
        for (index, row) in state.pellets.position.iter().enumerate() {
            let distance = wall.shape.distance(now.pose.inverse_point(vector(row)));
            let overlap_ratio = 1.0 - distance / row[3];
            pellets += usize::from(overlap_ratio > GATE_OVERLAP);
            if overlap_ratio > ratio {
                (deepest, ratio) = (state.pellets.id[index], overlap_ratio);
            }
        }
        if pellets > 0 {
            return Err(StepError::GateClosed {
                wall: wall.name.clone(),
                pellets,
                deepest,
                ratio,
                time: state.step as f64 * time_step,
            });
        }
    }
    Ok(())
}

/// Refuses speeds that are not numbers, and those that the step is too large for, before the pellets move.
///
/// # Errors
/// Some pellet's speed is not finite or past the limit.
pub(crate) fn check_speed(
    model: &Model,
    state: &State,
    workspace: &Workspace,
) -> Result<(), StepError> {
    let tally = &workspace.tally;
    let limit = model.time_step().speed_limit;
    let is_finite = tally.max_speed_squared.is_finite() && tally.kinetic.is_finite();
    if is_finite && tally.max_speed_squared <= limit * limit {
        return Ok(());
    }
    let (step, time) = now(model, state);
    let next = &workspace.next;
    if !is_finite {
        let broken = |row: &Row| row.iter().any(|value| !value.is_finite());
        let index = next.velocity.iter().position(broken);
        let index = index.or_else(|| next.spin.iter().position(broken));
        // Where the rows are finite, the sum of their energies is not.
        let index = index.or_else(|| fastest(&next.velocity)).unwrap_or(0);
        return Err(StepError::NotFinite {
            pellet: state.pellets.id[index],
            position: vector(&state.pellets.position[index]),
            speed: vector(&state.pellets.velocity[index]).norm(),
            step,
            time,
        });
    }
    let fastest = fastest(&next.velocity).expect("a speed past the limit is that of a pellet");
    Err(StepError::StepTooLarge {
        pellet: state.pellets.id[fastest],
        position: vector(&state.pellets.position[fastest]),
        speed: tally.max_speed_squared.sqrt(),
        limit,
        expected: model.time_step().expected_speed,
        seconds: model.time_step().seconds,
        step,
        time,
    })
}

/// Refuses an energy ledger that does not close.
///
/// # Errors
/// The residual is past its limit.
pub(crate) fn check_energy(model: &Model, state: &State) -> Result<(), StepError> {
    let limit = model.setup().limits.energy_residual;
    let energy = &state.books.energy;
    let (residual, throughput) = (energy.residual(), energy.throughput());
    let is_worth_checking =
        throughput > NEGLIGIBLE_THROUGHPUT * energy.carried_in.abs().max(energy.potential.abs());
    if is_worth_checking && residual.abs() > limit * throughput {
        let (step, time) = now(model, state);
        return Err(StepError::Energy {
            fastest: fastest_of(state),
            residual,
            throughput,
            limit,
            step,
            time,
        });
    }
    Ok(())
}

/// The step [-] and the time [s] that it is.
fn now(model: &Model, state: &State) -> (u64, f64) {
    (state.step, state.step as f64 * model.time_step().seconds)
}

/// Index of the fastest pellet [-], if there is any.
fn fastest(velocities: &[Row]) -> Option<usize> {
    let speeds = velocities.iter().map(|row| vector(row).norm());
    let fastest = speeds.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    fastest.map(|(index, _)| index)
}

/// The fastest pellet, ready to print.
fn fastest_of(state: &State) -> String {
    let pellets = &state.pellets;
    let Some(index) = fastest(&pellets.velocity) else {
        return "no pellet is left".into();
    };
    let (position, velocity) = (&pellets.position[index], &pellets.velocity[index]);
    format!(
        "the fastest is pellet {} with {:.2} m/s at ({:.4}, {:.4}, {:.4}) m",
        pellets.id[index],
        vector(velocity).norm(),
        position[0],
        position[1],
        position[2]
    )
}
