//! What load breaks a pellet, and how that scatters.

use crate::error::{ImpactError, positive};
use statrs::distribution::{ContinuousCDF, LogNormal, Normal, Weibull};
use statrs::function::gamma::gamma;

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

/// The crushing strength of pellets, as a test found it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strength {
    /// How the load scatters.
    pub scatter: Scatter,
    /// Diameter of the tested pellets; none where the load is taken as it is for any size [m].
    pub test_diameter: Option<f64>,
    /// Number of tested pellets; none where the parameters count as exact [-].
    pub sample_size: Option<u32>,
}

/// A least, a most and a best value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The least, in the unit of the value [its unit].
    pub low: f64,
    /// The best, in the unit of the value [its unit].
    pub best: f64,
    /// The most, in the unit of the value [its unit].
    pub high: f64,
}

impl Interval {
    /// A value that is known.
    pub fn exact(value: f64) -> Self {
        Self {
            low: value,
            best: value,
            high: value,
        }
    }

    /// The same of another quantity that grows or falls with this one.
    #[must_use]
    pub fn map(&self, quantity: impl Fn(f64) -> f64) -> Self {
        let [low, best, high] = [self.low, self.best, self.high].map(quantity);
        Self {
            low: low.min(high),
            best,
            high: low.max(high),
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
        Ok(Self::Weibull {
            scale: mean / gamma(1.0 + 1.0 / modulus),
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

    fn validate(&self) -> Result<(), ImpactError> {
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

/// Weibull moduli that a coefficient of variation is sought among [-].
const MODULI: (f64, f64) = (0.5, 500.0);

/// Confidence of the interval that a sample leaves for a load [-].
pub const CONFIDENCE: f64 = 0.95;

fn check_mean(mean: f64, variation: f64) -> Result<(), ImpactError> {
    positive("strength", "N", mean)?;
    positive("coefficient of variation", "", variation)
}

fn check_risk(risk: f64) -> Result<(), ImpactError> {
    if risk > 0.0 && risk < 1.0 {
        return Ok(());
    }
    Err(ImpactError::OutOfBounds {
        quantity: "risk",
        value: risk,
        unit: "",
        expected: "more than 0 and less than 1, that is, between 0 % and 100 %",
    })
}

impl Strength {
    /// How many times the load of the test a pellet of `diameter` [m] bears [-].
    ///
    /// The load grows with the area that bears it, `d²`. Weibull's weakest link takes `d^(−3/m)` off: a larger body has
    /// more flaws.
    pub fn size_effect(&self, diameter: f64) -> f64 {
        let Some(test_diameter) = self.test_diameter else {
            return 1.0;
        };
        let exponent = match self.scatter {
            Scatter::Weibull { modulus, .. } => 2.0 - 3.0 / modulus,
            _ => 2.0,
        };
        (diameter / test_diameter).powf(exponent)
    }

    /// Load under which a share `risk` of pellets of `diameter` [m] break, with the interval that the size of the
    /// sample leaves at [`CONFIDENCE`] [N].
    ///
    /// The standard error of the logarithm of the load is that of maximum likelihood (Lawless 2003, chapters 4 and 5).
    /// A fixed load knows no risk.
    ///
    /// # Errors
    ///
    /// When the risk is not between 0 and 1, or a quantity of the strength is not positive.
    pub fn load(&self, risk: f64, diameter: f64) -> Result<Interval, ImpactError> {
        check_risk(risk)?;
        self.validate(diameter)?;
        let (load, variance_of_one) = match self.scatter {
            Scatter::Fixed(load) => (load, 0.0),
            Scatter::Weibull { scale, modulus } => {
                let distribution = Weibull::new(modulus, scale).map_err(|_| refused(scale))?;
                let place = (-(-risk).ln_1p()).ln();
                let shape = 1.108_7 + 2.0 * -0.257_0 * place + 0.607_9 * place.powi(2);
                (distribution.inverse_cdf(risk), shape / modulus.powi(2))
            }
            Scatter::LogNormal { median, deviation } => {
                let distribution =
                    LogNormal::new(median.ln(), deviation).map_err(|_| refused(median))?;
                let place = Normal::standard().inverse_cdf(risk);
                let shape = 1.0 + 0.5 * place.powi(2);
                (distribution.inverse_cdf(risk), shape * deviation.powi(2))
            }
        };
        let best = load * self.size_effect(diameter);
        let error = self
            .sample_size
            .map_or(0.0, |size| (variance_of_one / f64::from(size)).sqrt());
        let reach = (Normal::standard().inverse_cdf(0.5 + 0.5 * CONFIDENCE) * error).exp();
        Ok(Interval {
            low: best / reach,
            best,
            high: best * reach,
        })
    }

    /// Share of pellets of `diameter` [m] that break under a `load` [N] [-].
    ///
    /// # Errors
    ///
    /// When a quantity of the strength is not positive.
    pub fn broken(&self, load: f64, diameter: f64) -> Result<f64, ImpactError> {
        self.validate(diameter)?;
        let load = load / self.size_effect(diameter);
        Ok(match self.scatter {
            Scatter::Fixed(strength) => f64::from(load >= strength),
            Scatter::Weibull { scale, modulus } => Weibull::new(modulus, scale)
                .map_err(|_| refused(scale))?
                .cdf(load),
            Scatter::LogNormal { median, deviation } => LogNormal::new(median.ln(), deviation)
                .map_err(|_| refused(median))?
                .cdf(load),
        })
    }

    fn validate(&self, diameter: f64) -> Result<(), ImpactError> {
        self.scatter.validate()?;
        positive("diameter", "m", diameter)?;
        positive(
            "diameter of the test",
            "m",
            self.test_diameter.unwrap_or(1.0),
        )?;
        positive(
            "sample size of the test",
            "",
            f64::from(self.sample_size.unwrap_or(1)),
        )
    }
}

/// What the distribution of a load refuses after its own checks: a value at the end of the numbers.
fn refused(load: f64) -> ImpactError {
    ImpactError::OutOfBounds {
        quantity: "strength",
        value: load,
        unit: "N",
        expected: "a load that a distribution can have",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strength(scatter: Scatter) -> Strength {
        Strength {
            scatter,
            test_diameter: Some(0.011),
            sample_size: Some(60),
        }
    }

    #[test]
    fn the_load_of_a_risk_breaks_that_share() {
        let scatters = [
            Scatter::weibull_from_mean(2450.0, 0.3),
            Scatter::log_normal_from_mean(2450.0, 0.3),
        ];
        for scatter in scatters {
            let strength = strength(scatter.expect("good numbers"));
            for risk in [0.001, 0.01, 0.5, 0.99] {
                for diameter in [0.009, 0.011, 0.016] {
                    let load = strength.load(risk, diameter).expect("a load");
                    let broken = strength.broken(load.best, diameter).expect("a share");
                    // The inverse is iterated to about 1e-9.
                    assert!((broken / risk - 1.0).abs() < 1.0e-7, "{strength:?} {risk}");
                    assert!(load.low < load.best && load.best < load.high);
                }
            }
        }
    }

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
    fn one_percent_of_a_weibull_sample_is_the_textbook_quantile() {
        // s (−ln 0.99)^(1/m), with s = 2700 N and m = 4.
        let strength = strength(Scatter::Weibull {
            scale: 2700.0,
            modulus: 4.0,
        });
        let load = strength.load(0.01, 0.011).expect("a load").best;
        let exact = 2700.0 * (-(0.99_f64.ln())).powf(0.25);
        assert!((load / exact - 1.0).abs() < 1.0e-12);
    }

    #[test]
    fn larger_pellets_bear_more_but_less_than_their_area_tells_where_flaws_decide() {
        let weibull = strength(Scatter::Weibull {
            scale: 2700.0,
            modulus: 4.0,
        });
        let fixed = strength(Scatter::Fixed(2450.0));
        assert!((fixed.size_effect(0.022) - 4.0).abs() < 1.0e-12);
        // 2 − 3/4 = 1.25.
        assert!((weibull.size_effect(0.022) - 2.0_f64.powf(1.25)).abs() < 1.0e-12);
        let sizeless = Strength {
            test_diameter: None,
            ..fixed
        };
        assert_eq!(sizeless.size_effect(0.022), 1.0);
    }

    #[test]
    fn the_interval_narrows_with_the_root_of_the_sample() {
        let scatter = Scatter::LogNormal {
            median: 2450.0,
            deviation: 0.3,
        };
        let width = |size| {
            let strength = Strength {
                sample_size: Some(size),
                ..strength(scatter)
            };
            let load = strength.load(0.01, 0.011).expect("a load");
            (load.high / load.low).ln()
        };
        assert!((width(60) / width(240) - 2.0).abs() < 1.0e-9);
        // 2 · 1.96 · 0.3 √((1 + 2.326²/2)/60).
        assert!((width(60) - 0.2923).abs() < 5.0e-4, "{}", width(60));
    }

    #[test]
    fn impossible_strengths_and_risks_are_refused() {
        for scatter in [Scatter::Fixed(0.0), Scatter::Fixed(-1.0)] {
            let message = strength(scatter)
                .load(0.01, 0.011)
                .expect_err("no strength")
                .to_string();
            assert!(message.contains("strength is"), "{message}");
        }
        for risk in [0.0, 1.0, -0.1, f64::NAN] {
            let refused = strength(Scatter::Fixed(1.0)).load(risk, 0.011);
            assert!(refused.is_err(), "{risk}");
        }
        assert!(Scatter::weibull_from_mean(2450.0, 0.001).is_err());
        assert!(Scatter::log_normal_from_mean(0.0, 0.3).is_err());
    }
}
