//! Storage order: along Morton's curve, renewed now and then.
//!
//! It is looked at by the count of steps and in cells of a fixed width, never by the searches: forces are summed in storage
//! order, and neither the skin nor the way of searching may change a bit of them.

use crate::chunk;
use crate::model::Model;
use crate::state::{Pellets, State};
use pelletflow_broadphase::morton;
use std::ops::Range;

/// Steps from one look at the order to the next [-].
const STEPS_BETWEEN_LOOKS: u64 = 512;
/// Pellets to one that is stored before its predecessor on the curve, below which they are stored anew [-].
const ORDER_KEPT: usize = 8;
/// Width of the curve's cells over the diameter of the largest pellets of the finest octave [-].
const CELL_WIDTH: f64 = 1.2;

/// Steps before the order is looked at again [-].
pub(crate) fn steps_before_look(step: u64) -> u64 {
    STEPS_BETWEEN_LOOKS - step % STEPS_BETWEEN_LOOKS
}

/// Whether the order is looked at before a step.
fn is_looked_at(step: u64) -> bool {
    step.is_multiple_of(STEPS_BETWEEN_LOOKS)
}

/// Whether pellets are to be stored anew.
pub(crate) fn is_due(model: &Model, state: &State, is_parallel: bool) -> bool {
    if !is_looked_at(state.step) {
        return false;
    }
    let all: Vec<u32> = (0..state.pellets.len() as u32).collect();
    !is_kept(&keys(model, &state.pellets, &all, is_parallel))
}

/// The rows to keep in the order in which to store them: as they are while that is nearly Morton's order.
///
/// It follows from the step, the positions and the present order alone, and so from the state.
pub(super) fn of(model: &Model, state: &State, kept: &[u32], is_parallel: bool) -> Vec<u32> {
    if !is_looked_at(state.step) {
        return kept.to_vec();
    }
    let keys = keys(model, &state.pellets, kept, is_parallel);
    if is_kept(&keys) {
        return kept.to_vec();
    }
    morton::order(&keys)
        .into_iter()
        .map(|place| kept[place as usize])
        .collect()
}

/// Places of rows along the curve.
fn keys(model: &Model, pellets: &Pellets, rows: &[u32], is_parallel: bool) -> Vec<u64> {
    // Cells of the finest grid, so that pellets of one cell are mostly stored in a row.
    let finest = model
        .largest_diameter()
        .min(2.0 * model.smallest_diameter());
    let cell_width = CELL_WIDTH * finest;
    let key = |&index: &u32| morton::key(&pellets.position[index as usize], cell_width);
    chunk::map(
        is_parallel,
        chunk::ranges(rows.len()).collect(),
        |range: Range<usize>| rows[range].iter().map(key).collect::<Vec<u64>>(),
    )
    .concat()
}

/// Whether few enough rows lie before their predecessor on the curve.
fn is_kept(keys: &[u64]) -> bool {
    let out_of_order = keys.windows(2).filter(|keys| keys[0] > keys[1]).count();
    ORDER_KEPT * out_of_order <= keys.len()
}
