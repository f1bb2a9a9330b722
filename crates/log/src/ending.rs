//! When a run ends, and why.

use crate::summary::Ended;
use pelletflow_sim::{RunPlan, Simulation, StopCondition};

/// Whether the run has ended, and why.
pub(crate) fn end_of(simulation: &Simulation, plan: &RunPlan) -> Option<Ended> {
    let time = simulation.time();
    // The step nearest to the end is the last one.
    if time + simulation.model().time_step().seconds / 2.0 >= plan.end_time {
        return Some(Ended::EndTime);
    }
    plan.stop.iter().find_map(|condition| match *condition {
        StopCondition::Empty { after } => {
            (time >= after && simulation.pellet_count() == 0).then_some(Ended::Empty)
        }
        StopCondition::Settled { after, speed } => {
            (time >= after && is_settled(simulation, speed)).then_some(Ended::Settled)
        }
        _ => None,
    })
}

/// Whether the mean speed of the pellets, root mean square by mass, is below a bound [m/s].
///
/// Spin does not count: nothing stops a pellet from turning on the spot.
fn is_settled(simulation: &Simulation, speed: f64) -> bool {
    let (mass, squares) = simulation
        .pellets()
        .fold((0.0, 0.0), |(mass, squares), pellet| {
            let square = pellet.mass * pellet.velocity.norm_squared();
            (mass + pellet.mass, squares + square)
        });
    mass > 0.0 && squares < mass * speed * speed
}

/// Why a run ended, in words.
pub(crate) fn reason_of(ended: Ended) -> &'static str {
    match ended {
        Ended::EndTime => "ends: the time asked for has passed",
        Ended::Empty => "ends: no pellet is inside any more",
        Ended::Settled => "ends: the bed has come to rest",
        Ended::Interrupted => "ends: interrupted",
        Ended::Failed => "ends: failed",
    }
}
