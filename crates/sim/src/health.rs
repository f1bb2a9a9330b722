//! Health: what makes a run stop rather than go on wrong.

use crate::advance::MotionTally;
use crate::error::StepError;
use crate::model::Model;
use crate::state::State;
use crate::tally::{DeepestContact, ForceTally, Partner};

/// Energy below which rounding decides, per joule of the greatest energy a pellet held [J].
const NEGLIGIBLE_THROUGHPUT: f64 = 1.0e-9;

/// Refuses overlaps past their limit, before the pellets move.
///
/// # Errors
/// The deepest contact is past the limit.
pub(crate) fn check_overlap(
    model: &Model,
    state: &State,
    tally: &ForceTally,
) -> Result<(), StepError> {
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

/// Refuses positions and velocities that are not numbers.
///
/// # Errors
/// Some pellet's speed is not finite.
pub(crate) fn check_finite(
    model: &Model,
    state: &State,
    motion: &MotionTally,
) -> Result<(), StepError> {
    if motion.max_speed_squared.is_finite() {
        return Ok(());
    }
    let worst = state
        .pellets
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
