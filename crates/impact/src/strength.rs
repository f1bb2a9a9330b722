//! What load breaks a pellet, and how that scatters.

use crate::error::{ImpactError, positive, sample};
use crate::interval::Interval;
use crate::pivots::Pivots;
use crate::scatter::Scatter;
use crate::share_band::ShareBand;

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

/// Confidence of the interval that a sample leaves for a load [-].
pub const CONFIDENCE: f64 = 0.95;

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
    /// The interval is that of a sample fitted by maximum likelihood, and holds for small samples too.
    /// A fixed load knows no risk.
    ///
    /// # Errors
    ///
    /// When the risk is not between 0 and 1, or a quantity of the strength is not positive.
    pub fn load(&self, risk: f64, diameter: f64) -> Result<Interval, ImpactError> {
        check_risk(risk)?;
        self.validate(diameter)?;
        let size_effect = self.size_effect(diameter);
        let Some((law, location, spread)) = self.scatter.law() else {
            return Ok(Interval::exact(self.scatter.center() * size_effect));
        };
        let place = law.place(risk);
        let [low, high] = self
            .sample_size
            .map_or([place; 2], |size| Pivots::new(law, size).offset(place));
        let load = |offset: f64| (location + spread * offset).exp() * size_effect;
        Ok(Interval {
            low: load(low).min(load(place)),
            best: load(place),
            high: load(high).max(load(place)),
        })
    }

    /// Share of pellets of `diameter` [m] that break under a `load` [N] [-].
    ///
    /// # Errors
    ///
    /// When a quantity of the strength is not positive.
    pub fn broken(&self, load: f64, diameter: f64) -> Result<f64, ImpactError> {
        self.validate(diameter)?;
        Ok(self.scatter.share(load / self.size_effect(diameter)))
    }

    /// The same with the interval that the size of the sample leaves at [`CONFIDENCE`] [-].
    ///
    /// # Errors
    ///
    /// When a quantity of the strength is not positive.
    pub fn broken_between(&self, load: f64, diameter: f64) -> Result<Interval, ImpactError> {
        self.validate(diameter)?;
        Ok(self.shares().share(load / self.size_effect(diameter)))
    }

    /// The share for every load, worked out once.
    pub(crate) fn shares(&self) -> LoadShares {
        LoadShares {
            scatter: self.scatter,
            band: self
                .scatter
                .law()
                .map(|(law, ..)| ShareBand::new(law, self.sample_size)),
        }
    }

    pub(crate) fn validate(&self, diameter: f64) -> Result<(), ImpactError> {
        self.scatter.validate()?;
        positive("diameter", "m", diameter)?;
        positive(
            "diameter of the test",
            "m",
            self.test_diameter.unwrap_or(1.0),
        )?;
        sample(self.sample_size)
    }
}

/// Share that breaks under a load at the diameter of the test, with its interval.
#[derive(Debug)]
pub(crate) struct LoadShares {
    scatter: Scatter,
    band: Option<ShareBand>,
}

impl LoadShares {
    /// Share that breaks under a load [N] [-].
    pub(crate) fn share(&self, load: f64) -> Interval {
        match (self.scatter.law(), &self.band) {
            (Some((_, location, spread)), Some(band)) => {
                band.share((load.ln() - location) / spread)
            }
            _ => Interval::exact(self.scatter.share(load)),
        }
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
        // Not quite 2: the interval of a small sample is wider than that of normal theory.
        assert!(
            (width(60) / width(240) - 2.0).abs() < 0.15,
            "{}",
            width(60) / width(240)
        );
        // (z − N/√n) / √(χ²/n) with n − 1 degrees of freedom, integrated over χ²: from −2.9354 to −1.9195 for z = −2.3263
        // and n = 60. The draws are within 2 %.
        assert!(
            (width(60) / 0.3 / (2.9354 - 1.9195) - 1.0).abs() < 0.02,
            "{}",
            width(60) / 0.3
        );
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
        for size in [0, 1] {
            let few = Strength {
                sample_size: Some(size),
                ..strength(Scatter::Fixed(1.0))
            };
            assert!(few.load(0.01, 0.011).is_err() && few.broken_between(1.0, 0.011).is_err());
        }
        for risk in [0.0, 1.0, -0.1, f64::NAN] {
            let refused = strength(Scatter::Fixed(1.0)).load(risk, 0.011);
            assert!(refused.is_err(), "{risk}");
        }
    }
}
