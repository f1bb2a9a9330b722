//! How long pellets stay: from when they came to when they left through an outlet.

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

impl Instrument for Residence {
    /// Times that those that left were inside, in the order of leaving [s].
    type Record = Vec<f64>;

    const NAME: &'static str = "residence";

    fn discharge(&self, record: &mut Vec<f64>, age: f64) {
        record.push(age);
    }

    fn values(&self, record: &Vec<f64>, model: &Model, state: &State) -> Values {
        let mut times = record.clone();
        times.sort_unstable_by(f64::total_cmp);
        let mean = mean(times.iter().copied());
        let deviation = deviation(&times, mean);
        let inside = state.pellets.len();
        vec![
            ("mean_s", mean),
            ("deviation_s", deviation),
            ("min_s", quantile(&times, 0.0)),
            ("percentile_5_s", quantile(&times, 0.05)),
            ("median_s", quantile(&times, 0.5)),
            ("percentile_95_s", quantile(&times, 0.95)),
            ("max_s", quantile(&times, 1.0)),
            ("pellets", times.len() as f64),
            (
                "mean_age_inside_s",
                self::mean((0..inside).map(|index| age(model, state, index))),
            ),
        ]
    }
}

/// Mean; 0 of nothing.
fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len().max(1);
    values.sum::<f64>() / count as f64
}

/// Standard deviation of a sample; 0 of fewer than two.
fn deviation(times: &[f64], mean: f64) -> f64 {
    let squares: f64 = times.iter().map(|time| (time - mean).powi(2)).sum();
    (squares / (times.len().max(2) - 1) as f64).sqrt()
}

/// The value below which a share of sorted values lies, between two of them in proportion; 0 of nothing.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else {
        return 0.0;
    };
    let place = share * last as f64;
    let below = sorted[place as usize];
    let above = sorted[(place as usize + 1).min(last)];
    below + place.fract() * (above - below)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_a_ramp_are_its_places() {
        let ramp: Vec<f64> = (0..=100).map(f64::from).collect();
        for (share, expected) in [(0.0, 0.0), (0.05, 5.0), (0.505, 50.5), (1.0, 100.0)] {
            // Rounding of the place.
            assert!((quantile(&ramp, share) - expected).abs() < 1.0e-12);
        }
        assert_eq!(quantile(&[], 0.5), 0.0);
        assert_eq!(quantile(&[3.0], 0.95), 3.0);
    }

    #[test]
    fn the_deviation_of_one_to_five_is_the_root_of_two_and_a_half() {
        let deviation = deviation(&[1.0, 2.0, 3.0, 4.0, 5.0], 3.0);
        assert!((deviation - 2.5_f64.sqrt()).abs() < 1.0e-15);
    }
}
