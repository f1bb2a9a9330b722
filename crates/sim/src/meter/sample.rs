//! A sample of values and what describes it.

/// Values in rising order; of an empty sample all that is asked for is 0.
pub(super) struct Sample(Vec<f64>);

impl Sample {
    pub(super) fn new(mut values: Vec<f64>) -> Self {
        values.sort_unstable_by(f64::total_cmp);
        Self(values)
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    pub(super) fn mean(&self) -> f64 {
        self.0.iter().fold(0.0, |sum, value| sum + value) / self.0.len().max(1) as f64
    }

    /// Standard deviation of what the sample was drawn from; 0 of fewer than two.
    pub(super) fn deviation(&self) -> f64 {
        let mean = self.mean();
        let squares = self.0.iter().map(|value| (value - mean).powi(2));
        let sum = squares.fold(0.0, |sum, square| sum + square);
        (sum / (self.0.len().max(2) - 1) as f64).sqrt()
    }

    /// The value below which a share of the sample lies, between two of them in proportion.
    pub(super) fn quantile(&self, share: f64) -> f64 {
        let Some(last) = self.0.len().checked_sub(1) else {
            return 0.0;
        };
        let place = share * last as f64;
        let below = self.0[place as usize];
        let above = self.0[(place as usize + 1).min(last)];
        below + place.fract() * (above - below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_a_ramp_are_its_places() {
        let ramp = Sample::new((0..=100).rev().map(f64::from).collect());
        for (share, expected) in [(0.0, 0.0), (0.05, 5.0), (0.505, 50.5), (1.0, 100.0)] {
            // Rounding of the place.
            assert!((ramp.quantile(share) - expected).abs() < 1.0e-12);
        }
        assert_eq!(Sample::new(Vec::new()).quantile(0.5), 0.0);
        assert_eq!(Sample::new(vec![3.0]).quantile(0.95), 3.0);
    }

    #[test]
    fn the_deviation_of_one_to_five_is_the_root_of_two_and_a_half() {
        let sample = Sample::new(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!(sample.mean(), 3.0);
        assert_eq!(sample.deviation(), 2.5_f64.sqrt());
    }
}
