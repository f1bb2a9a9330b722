//! Health: what makes a run stop rather than go on wrong.

use crate::error::StepError;
use crate::model::Model;
use crate::state::{State, vector};
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

/// Refuses positions and velocities that are not numbers.
///
/// # Errors
/// Some pellet's speed is not finite.
pub(crate) fn check_finite(
    model: &Model,
    state: &State,
    workspace: &Workspace,
) -> Result<(), StepError> {
    let tally = &workspace.tally;
    if tally.max_speed_squared.is_finite() && tally.kinetic.is_finite() {
        return Ok(());
    }
    let worst = workspace
        .next
        .velocity
        .iter()
        .position(|row| row.iter().any(|value| !value.is_finite()))
        .unwrap_or(0);
    Err(StepError::NotFinite {
        pellet: state.pellets.id[worst],
        step: state.step,
        time: state.step as f64 * model.time_step().seconds,
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
        return Err(StepError::Energy {
            residual,
            throughput,
            limit,
            step: state.step,
            time: state.step as f64 * model.time_step().seconds,
        });
    }
    Ok(())
}
