//! The share that breaks at a place of the distribution, with the interval that the sample leaves.

use crate::interval::Interval;
use crate::pivots::Pivots;
use crate::scatter::ScatterLaw;

/// Places that the interval is worked out for; between them it is a straight line, as it is nearly everywhere [-].
const PLACES: (f64, f64) = (-16.0, 8.0);

/// Intervals between these places [-].
const STEPS: usize = 192;

/// The share at each place, with an interval at [`crate::strength::CONFIDENCE`] for every single place.
#[derive(Debug)]
pub(crate) struct ShareBand {
    law: ScatterLaw,
    /// Least and most place for each of the places; none where the distribution counts as exact.
    places: Option<Vec<[f64; 2]>>,
}

impl ShareBand {
    pub(crate) fn new(law: ScatterLaw, sample_size: Option<u32>) -> Self {
        let places = sample_size.map(|size| {
            let pivots = Pivots::new(law, size);
            (0..=STEPS)
                .map(|index| {
                    let place = PLACES.0 + index as f64 * step();
                    let [least, most] = pivots.place(place);
                    [least.min(place), most.max(place)]
                })
                .collect()
        });
        Self { law, places }
    }

    /// Share that breaks at a place of the fitted distribution [-].
    pub(crate) fn share(&self, place: f64) -> Interval {
        let best = self.law.share(place);
        let Some(places) = &self.places else {
            return Interval::exact(best);
        };
        if !place.is_finite() {
            return Interval::exact(best);
        }
        let at = (place - PLACES.0) / step();
        let index = (at.max(0.0) as usize).min(STEPS - 1);
        let part = at - index as f64;
        let [low, high] = [0, 1]
            .map(|end| places[index][end] + part * (places[index + 1][end] - places[index][end]));
        Interval {
            low: self.law.share(low).min(best),
            best,
            high: self.law.share(high).max(best),
        }
    }
}

fn step() -> f64 {
    (PLACES.1 - PLACES.0) / STEPS as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_share_grows_with_the_place_and_so_do_its_bounds() {
        for law in [ScatterLaw::Weibull, ScatterLaw::LogNormal] {
            let band = ShareBand::new(law, Some(10));
            let shares: Vec<Interval> = (-400..200)
                .map(|at| band.share(0.05 * f64::from(at)))
                .collect();
            for pair in shares.windows(2) {
                assert!(pair[0].low <= pair[1].low && pair[0].high <= pair[1].high);
                assert!(pair[0].low <= pair[0].best && pair[0].best <= pair[0].high);
            }
        }
    }

    #[test]
    fn an_exact_distribution_has_no_interval_and_a_larger_sample_a_narrower_one() {
        let width = |size| {
            let share = ShareBand::new(ScatterLaw::LogNormal, size).share(-2.0);
            share.high - share.low
        };
        assert_eq!(width(None), 0.0);
        assert!(width(Some(10)) > width(Some(60)) && width(Some(60)) > width(Some(1000)));
    }
}
