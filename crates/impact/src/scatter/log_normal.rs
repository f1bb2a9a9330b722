//! The log-normal distribution: the logarithm of the load is normal, at the place `z = ln(x/median) / deviation`.

use statrs::distribution::{ContinuousCDF, Normal};
use statrs::function::erf::erfc;

/// Share below a place [-].
pub(crate) fn share(place: f64) -> f64 {
    0.5 * erfc(-place * std::f64::consts::FRAC_1_SQRT_2)
}

/// Place below which a share lies [-].
pub(crate) fn place(share: f64) -> f64 {
    Normal::standard().inverse_cdf(share)
}

/// Variance of the estimated place, times the size of a large sample [-] (Lawless 2003, section 5.2).
pub(crate) fn variance(place: f64) -> f64 {
    1.0 + 0.5 * place.powi(2)
}

/// Location and spread of the logarithms, by maximum likelihood: their mean and their root mean square about it.
///
/// None where they are all equal.
pub(crate) fn fit(logarithms: &[f64]) -> Option<(f64, f64)> {
    let count = logarithms.len() as f64;
    let mean = logarithms.iter().sum::<f64>() / count;
    let square = logarithms.iter().map(|y| (y - mean).powi(2)).sum::<f64>();
    let deviation = (square / count).sqrt();
    (deviation > f64::EPSILON * mean.abs().max(1.0)).then_some((mean, deviation))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_load_in_six_lies_a_deviation_below_the_median() {
        // Φ(−1) = 0.158655…, Φ(−1.96) = 0.0249979 (Abramowitz & Stegun 1964, table 26.1).
        assert!((share(-1.0) - 0.158_655_254).abs() < 1.0e-9);
        assert!((share(-1.96) - 0.024_997_895).abs() < 1.0e-9);
        assert!((place(share(-3.0)) + 3.0).abs() < 1.0e-9);
    }

    #[test]
    fn the_fit_is_the_mean_and_the_deviation_of_the_logarithms() {
        let (location, spread) = fit(&[1.0, 2.0, 6.0]).expect("they differ");
        assert_eq!(location, 3.0);
        assert!((spread - (14.0_f64 / 3.0).sqrt()).abs() < 1.0e-15);
        assert_eq!(fit(&[7.0; 5]), None);
    }
}
