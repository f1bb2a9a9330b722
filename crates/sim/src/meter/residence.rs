//! How long pellets stay: from when they came to when they left through an outlet.

use super::sample::Sample;
use super::{Instrument, Values};
use crate::model::Model;
use crate::state::State;

/// How long pellets stay.
///
/// Pellets that are there at the start came at time 0. That a pellet has left is seen at the next neighbor search,
/// before it has moved on by more than the skin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Residence;

/// Time that a pellet has been inside [s].
pub(super) fn age(model: &Model, state: &State, index: usize) -> f64 {
    (state.step - state.pellets.born[index]) as f64 * model.time_step().seconds
}

/// Mean time that the pellets inside have been there; 0 of none [s].
fn mean_age(model: &Model, state: &State) -> f64 {
    let born = &state.pellets.born;
    let steps: u64 = born.iter().map(|born| state.step - born).sum();
    steps as f64 * model.time_step().seconds / born.len().max(1) as f64
}

impl Instrument for Residence {
    /// Times that those that left were inside, in the order of leaving [s].
    type Record = Vec<f64>;

    const NAME: &'static str = "residence";

    fn discharge(&self, record: &mut Vec<f64>, age: f64) {
        record.push(age);
    }

    fn values(&self, record: &Vec<f64>, model: &Model, state: &State) -> Values {
        let times = Sample::new(record.clone());
        vec![
            ("mean_s", times.mean()),
            ("deviation_s", times.deviation()),
            ("min_s", times.quantile(0.0)),
            ("percentile_5_s", times.quantile(0.05)),
            ("median_s", times.quantile(0.5)),
            ("percentile_95_s", times.quantile(0.95)),
            ("max_s", times.quantile(1.0)),
            ("pellets", times.count() as f64),
            ("mean_age_inside_s", mean_age(model, state)),
        ]
    }
}
