//! How a strength scatters from pellet to pellet: one file for each law.
//!
//! But for the fixed load, the logarithm of the strength has a location and a spread; how far a load lies from the
//! location, in spreads, is its place, and the share that breaks under it depends on the place alone.

mod fixed;
mod log_normal;
mod weibull;

use crate::error::{ImpactError, positive};

/// How the crushing load of pellets scatters, at the diameter of the test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scatter {
    /// All break at one load [N].
    Fixed(f64),
    /// Weibull's distribution of the weakest link.
    Weibull {
        /// Load that 63 % break under [N].
        scale: f64,
        /// Weibull modulus m [-].
        modulus: f64,
    },
    /// The logarithm of the load is normal.
    LogNormal {
        /// Load that half break under [N].
        median: f64,
        /// Standard deviation of the logarithm of the load [-].
        deviation: f64,
    },
}

/// A law of scatter that has a spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScatterLaw {
    /// Weibull's distribution of the weakest link.
    Weibull,
    /// The logarithm is normal.
    LogNormal,
}

impl ScatterLaw {
    /// Share below a place [-].
    pub(crate) fn share(self, place: f64) -> f64 {
        match self {
            Self::Weibull => weibull::share(place),
            Self::LogNormal => log_normal::share(place),
        }
    }

    /// Place below which a share lies [-].
    pub(crate) fn place(self, share: f64) -> f64 {
        match self {
            Self::Weibull => weibull::place(share),
            Self::LogNormal => log_normal::place(share),
        }
    }

    /// Variance of the estimated place, times the size of a large sample [-].
    pub(crate) fn variance(self, place: f64) -> f64 {
        match self {
            Self::Weibull => weibull::variance(place),
            Self::LogNormal => log_normal::variance(place),
        }
    }

    /// Location and spread of logarithms by maximum likelihood; none where they are all equal.
    pub(crate) fn fit(self, logarithms: &[f64]) -> Option<(f64, f64)> {
        match self {
            Self::Weibull => weibull::fit(logarithms),
            Self::LogNormal => log_normal::fit(logarithms),
        }
    }

    /// The loads whose logarithms have this location and spread.
    pub(crate) fn scatter(self, location: f64, spread: f64) -> Scatter {
        match self {
            Self::Weibull => Scatter::Weibull {
                scale: location.exp(),
                modulus: 1.0 / spread,
            },
            Self::LogNormal => Scatter::LogNormal {
                median: location.exp(),
                deviation: spread,
            },
        }
    }
}

impl Scatter {
    /// Weibull's distribution from its mean [N] and coefficient of variation [-].
    ///
    /// # Errors
    ///
    /// When one of them is not positive, or the coefficient belongs to no modulus between 0.5 and 500.
    pub fn weibull_from_mean(mean: f64, variation: f64) -> Result<Self, ImpactError> {
        check_mean(mean, variation)?;
        let (modulus, scale_over_mean) = weibull::of_variation(variation)?;
        Ok(Self::Weibull {
            scale: mean * scale_over_mean,
            modulus,
        })
    }

    /// The log-normal distribution from its mean [N] and coefficient of variation [-].
    ///
    /// # Errors
    ///
    /// When one of them is not positive.
    pub fn log_normal_from_mean(mean: f64, variation: f64) -> Result<Self, ImpactError> {
        check_mean(mean, variation)?;
        let variance = variation.powi(2).ln_1p();
        Ok(Self::LogNormal {
            median: mean * (-0.5 * variance).exp(),
            deviation: variance.sqrt(),
        })
    }

    /// The law, with location and spread of the logarithm of the load; none where nothing scatters.
    pub(crate) fn law(&self) -> Option<(ScatterLaw, f64, f64)> {
        match *self {
            Self::Fixed(_) => None,
            Self::Weibull { scale, modulus } => {
                Some((ScatterLaw::Weibull, scale.ln(), 1.0 / modulus))
            }
            Self::LogNormal { median, deviation } => {
                Some((ScatterLaw::LogNormal, median.ln(), deviation))
            }
        }
    }

    /// The fixed load, or that at the place 0: Weibull's scale, or the median [N].
    pub(crate) fn center(&self) -> f64 {
        match *self {
            Self::Fixed(load) => load,
            Self::Weibull { scale, .. } => scale,
            Self::LogNormal { median, .. } => median,
        }
    }

    /// Share that breaks under a load [N], at the diameter of the test [-].
    pub(crate) fn share(&self, load: f64) -> f64 {
        match *self {
            Self::Fixed(strength) => fixed::share(strength, load),
            Self::Weibull { scale, modulus } => weibull::share(modulus * (load / scale).ln()),
            Self::LogNormal { median, deviation } => {
                log_normal::share((load / median).ln() / deviation)
            }
        }
    }

    pub(crate) fn validate(&self) -> Result<(), ImpactError> {
        match *self {
            Self::Fixed(load) => positive("strength", "N", load),
            Self::Weibull { scale, modulus } => {
                positive("strength", "N", scale)?;
                positive("Weibull modulus", "", modulus)
            }
            Self::LogNormal { median, deviation } => {
                positive("strength", "N", median)?;
                positive(
                    "standard deviation of the logarithm of strength",
                    "",
                    deviation,
                )
            }
        }
    }
}

fn check_mean(mean: f64, variation: f64) -> Result<(), ImpactError> {
    positive("strength", "N", mean)?;
    positive("coefficient of variation", "", variation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use statrs::function::gamma::gamma;

    #[test]
    fn distributions_have_the_mean_and_the_variation_that_they_are_made_of() {
        let Ok(Scatter::Weibull { scale, modulus }) = Scatter::weibull_from_mean(2450.0, 0.3)
        else {
            panic!("not Weibull");
        };
        let mean = scale * gamma(1.0 + 1.0 / modulus);
        let square = scale.powi(2) * gamma(1.0 + 2.0 / modulus);
        assert!((mean / 2450.0 - 1.0).abs() < 1.0e-12);
        assert!(((square / mean.powi(2) - 1.0).sqrt() - 0.3).abs() < 1.0e-9);
        let Ok(Scatter::LogNormal { median, deviation }) =
            Scatter::log_normal_from_mean(2450.0, 0.3)
        else {
            panic!("not log-normal");
        };
        assert!((median * (0.5 * deviation.powi(2)).exp() / 2450.0 - 1.0).abs() < 1.0e-14);
        assert!(((deviation.powi(2).exp() - 1.0).sqrt() - 0.3).abs() < 1.0e-14);
    }

    #[test]
    fn no_load_breaks_nothing_and_a_huge_one_all() {
        for scatter in [
            Scatter::Fixed(2450.0),
            Scatter::Weibull {
                scale: 2700.0,
                modulus: 4.0,
            },
            Scatter::LogNormal {
                median: 2450.0,
                deviation: 0.3,
            },
        ] {
            assert_eq!(scatter.share(0.0), 0.0);
            assert_eq!(scatter.share(1.0e9), 1.0);
        }
    }

    #[test]
    fn means_that_belong_to_no_distribution_are_refused() {
        assert!(Scatter::weibull_from_mean(2450.0, 0.001).is_err());
        assert!(Scatter::log_normal_from_mean(0.0, 0.3).is_err());
    }
}
