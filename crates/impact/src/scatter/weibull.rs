//! Weibull's distribution of the weakest link (Weibull 1951): `F = 1 − exp(−(x/scale)^m)`.
//!
//! The logarithm of the load has the smallest extreme value distribution: its place `z = m ln(x/scale)` has the share
//! `1 − exp(−exp z)`.

use crate::error::ImpactError;
use statrs::function::gamma::gamma;

/// Weibull moduli that a coefficient of variation is sought among [-].
const MODULI: (f64, f64) = (0.5, 500.0);

/// Steps of Newton's method; it takes about six [-].
const MOST_STEPS: usize = 100;

/// Share below a place [-].
pub(crate) fn share(place: f64) -> f64 {
    -(-place.exp()).exp_m1()
}

/// Place below which a share lies [-].
pub(crate) fn place(share: f64) -> f64 {
    (-(-share).ln_1p()).ln()
}

/// Variance of the estimated place, times the size of a large sample [-] (Lawless 2003, section 5.1).
pub(crate) fn variance(place: f64) -> f64 {
    1.108_7 - 2.0 * 0.257_0 * place + 0.607_9 * place.powi(2)
}

/// Location and spread of the logarithms, by maximum likelihood (Lawless 2003, section 5.1).
///
/// None where they are all equal.
pub(crate) fn fit(logarithms: &[f64]) -> Option<(f64, f64)> {
    let count = logarithms.len() as f64;
    let greatest = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mean = logarithms.iter().map(|y| y - greatest).sum::<f64>() / count;
    let square = logarithms.iter().map(|y| (y - greatest - mean).powi(2));
    let deviation = (square.sum::<f64>() / count).sqrt();
    if deviation <= f64::EPSILON * greatest.abs().max(1.0) {
        return None;
    }
    // The left side grows steadily with the modulus: from below the root, Newton's steps may jump over it once.
    let mut modulus = 1.28 / deviation;
    for _ in 0..MOST_STEPS {
        let [mut one, mut first, mut second] = [0.0; 3];
        for logarithm in logarithms {
            let below = logarithm - greatest;
            let weight = (modulus * below).exp();
            one += weight;
            first += weight * below;
            second += weight * below * below;
        }
        let weighted = first / one;
        let left = weighted - 1.0 / modulus - mean;
        let slope = second / one - weighted.powi(2) + modulus.powi(-2);
        let step = left / slope;
        modulus = (modulus - step).clamp(0.3 * modulus, 3.0 * modulus);
        if step.abs() < 1.0e-13 * modulus {
            break;
        }
    }
    let powers = logarithms.iter().map(|y| (modulus * (y - greatest)).exp());
    let location = greatest + (powers.sum::<f64>() / count).ln() / modulus;
    Some((location, 1.0 / modulus))
}

/// Modulus and the scale over the mean, of a coefficient of variation [-].
pub(crate) fn of_variation(variation: f64) -> Result<(f64, f64), ImpactError> {
    let variation_of = |modulus: f64| {
        (gamma(1.0 + 2.0 / modulus) / gamma(1.0 + 1.0 / modulus).powi(2) - 1.0).sqrt()
    };
    // The coefficient of variation falls steadily as the modulus grows.
    let (mut low, mut high) = MODULI;
    if !(variation_of(high)..=variation_of(low)).contains(&variation) {
        return Err(ImpactError::OutOfBounds {
            quantity: "coefficient of variation",
            value: variation,
            unit: "",
            expected: "between 0.0026 and 2.2 for Weibull's distribution",
        });
    }
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if variation_of(middle) > variation {
            low = middle;
        } else {
            high = middle;
        }
    }
    let modulus = f64::midpoint(low, high);
    Ok((modulus, 1.0 / gamma(1.0 + 1.0 / modulus)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Millions of revolutions to the failure of 23 ball bearings (Lieblein & Zelen 1956), the sheet on which Thoman,
    /// Bain & Antle (1969) and Lawless (2003) show the fit.
    const BEARINGS: [f64; 23] = [
        17.88, 28.92, 33.00, 41.52, 42.12, 45.60, 48.48, 51.84, 51.96, 54.12, 55.56, 67.80, 68.64,
        68.64, 68.88, 84.12, 93.12, 98.64, 105.12, 105.84, 127.92, 128.04, 173.40,
    ];

    #[test]
    fn the_ball_bearings_have_the_published_scale_and_modulus() {
        let (location, spread) = fit(&BEARINGS.map(f64::ln)).expect("they differ");
        // Maximum likelihood 81.88 and 2.102 (Lawless 2003), in the digits printed there.
        assert!((location.exp() - 81.88).abs() < 0.01, "{}", location.exp());
        assert!((1.0 / spread - 2.102).abs() < 0.001, "{}", 1.0 / spread);
    }

    #[test]
    fn the_fit_is_where_no_other_modulus_is_likelier() {
        let logarithms = BEARINGS.map(f64::ln);
        let likelihood = |location: f64, spread: f64| -> f64 {
            let places = logarithms.iter().map(|y| (y - location) / spread);
            places.map(|z| z - z.exp() - spread.ln()).sum()
        };
        let (location, spread) = fit(&logarithms).expect("they differ");
        let best = likelihood(location, spread);
        for (shift, stretch) in [(0.01, 1.0), (-0.01, 1.0), (0.0, 1.01), (0.0, 0.99)] {
            assert!(likelihood(location + shift, spread * stretch) < best);
        }
    }

    #[test]
    fn equal_loads_have_no_scatter_to_fit() {
        assert_eq!(fit(&[7.0; 5]), None);
    }

    #[test]
    fn share_and_place_undo_each_other() {
        for at in [1.0e-9, 0.01, 0.5, 0.999] {
            assert!((share(place(at)) / at - 1.0).abs() < 1.0e-12);
        }
    }
}
