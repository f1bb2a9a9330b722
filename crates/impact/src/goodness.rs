//! How well a distribution fits a sample: the distance of Anderson & Darling (1952), which weighs the tails.

use crate::scatter::ScatterLaw;

/// Share of samples of a distribution whose distance is greater, below which a fit is doubted [-].
pub const DOUBTFUL: f64 = 0.05;

/// How far a sample lies from the distribution fitted to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goodness {
    /// `A²`: the squared distance of the two cumulated shares, weighed by 1/F(1 − F) [-].
    pub distance: f64,
    /// p: share of samples of the distribution that lie farther from their own fit [-].
    pub p_value: f64,
}

impl Goodness {
    /// Whether the sample speaks against the distribution.
    pub fn is_doubtful(&self) -> bool {
        self.p_value < DOUBTFUL
    }

    /// Of logarithms to the location and spread fitted to them by maximum likelihood.
    pub(crate) fn new(law: ScatterLaw, logarithms: &[f64], location: f64, spread: f64) -> Self {
        let count = logarithms.len() as f64;
        let mut shares: Vec<f64> = logarithms
            .iter()
            .map(|logarithm| law.share((logarithm - location) / spread))
            .map(|share| share.clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON))
            .collect();
        shares.sort_by(f64::total_cmp);
        let terms = shares.iter().zip(shares.iter().rev()).enumerate();
        let sum: f64 = terms
            .map(|(index, (below, above))| (2 * index + 1) as f64 * (below.ln() + (-above).ln_1p()))
            .sum();
        let distance = -count - sum / count;
        let p_value = match law {
            ScatterLaw::Weibull => of_weibull(distance * (1.0 + 0.2 / count.sqrt())),
            ScatterLaw::LogNormal => {
                of_log_normal(distance * (1.0 + 0.75 / count + 2.25 / count.powi(2)))
            }
        };
        Self { distance, p_value }
    }
}

/// p of the adjusted distance from a fitted Weibull distribution (MIL-HDBK-17-1F, section 8.3.4, after Stephens 1977).
fn of_weibull(distance: f64) -> f64 {
    1.0 / (1.0 + (-0.10 + 1.24 * distance.ln() + 4.48 * distance).exp())
}

/// p of the adjusted distance from a fitted log-normal distribution (D'Agostino & Stephens 1986, table 4.9).
fn of_log_normal(distance: f64) -> f64 {
    let square = distance.powi(2);
    let p = if distance < 0.2 {
        1.0 - (-13.436 + 101.14 * distance - 223.73 * square).exp()
    } else if distance < 0.34 {
        1.0 - (-8.318 + 42.796 * distance - 59.938 * square).exp()
    } else if distance < 0.6 {
        (0.9177 - 4.279 * distance - 1.38 * square).exp()
    } else {
        // Beyond 13 the parabola would turn up again.
        (1.2937 - 5.709 * distance + 0.0186 * square.min(169.0)).exp()
    };
    p.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_critical_distances_have_a_p_of_one_in_twenty() {
        // 0.757 for Weibull's (Stephens 1977), 0.752 for the normal distribution (Stephens 1974), both fitted.
        assert!((of_weibull(0.757) - 0.05).abs() < 0.002);
        assert!((of_log_normal(0.752) - 0.05).abs() < 0.002);
    }

    #[test]
    fn a_sample_of_the_wrong_shape_is_doubted_and_one_of_the_right_shape_is_not() {
        for law in [ScatterLaw::Weibull, ScatterLaw::LogNormal] {
            let right: Vec<f64> = (0..60)
                .map(|index| law.place((f64::from(index) + 0.5) / 60.0))
                .collect();
            // Two kinds of pellets in one sheet.
            let wrong: Vec<f64> = right.iter().map(|y| y + 8.0 * y.signum()).collect();
            for (sample, is_doubtful) in [(right, false), (wrong, true)] {
                let (location, spread) = law.fit(&sample).expect("they differ");
                let goodness = Goodness::new(law, &sample, location, spread);
                assert_eq!(goodness.is_doubtful(), is_doubtful, "{law:?} {goodness:?}");
            }
        }
    }
}
