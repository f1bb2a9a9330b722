//! A crushing test: the loads at which pellets broke between two plates, and the distribution fitted to them.

use crate::error::{ImpactError, positive};
use crate::goodness::Goodness;
use crate::interval::Interval;
use crate::pivots::Pivots;
use crate::scatter::{Scatter, ScatterLaw};
use crate::strength::Strength;

/// Fewest loads that a distribution is fitted to [-].
pub const FEWEST_LOADS: usize = 3;

/// Rounds in which the modulus and the loads reduced with it are brought together; it takes about ten [-].
const MOST_ROUNDS: usize = 200;

/// The loads at which pellets broke.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CrushTest {
    /// Load of each pellet [N].
    pub loads: Vec<f64>,
    /// Diameter of each pellet; none where they were not measured [m].
    pub diameters: Option<Vec<f64>>,
}

/// A distribution fitted to a crushing test by maximum likelihood.
#[derive(Debug, Clone, PartialEq)]
pub struct CrushFit {
    /// The strength that the test found; of pellets of the mean diameter where diameters were measured.
    pub strength: Strength,
    /// Scale of Weibull's distribution or median of the log-normal one, with its interval [N].
    pub center: Interval,
    /// Modulus of Weibull's distribution or deviation of the log-normal one, with its interval [-].
    pub shape: Interval,
    /// How far the loads lie from the distribution.
    pub goodness: Goodness,
}

impl CrushTest {
    /// Fits a distribution; its intervals hold at [`crate::strength::CONFIDENCE`], for small samples too.
    ///
    /// Where diameters are given, each load is first carried over to the mean diameter, as [`Strength::size_effect`]
    /// does.
    ///
    /// # Errors
    ///
    /// When there are less than three loads or they are all equal, when one is not positive, and when diameters are
    /// not as many.
    pub fn fit(&self, law: ScatterLaw) -> Result<CrushFit, ImpactError> {
        self.validate()?;
        let size = u32::try_from(self.loads.len()).unwrap_or(u32::MAX);
        self.fit_with(&Pivots::new(law, size))
    }

    /// The same with pivots that serve many tests of one size.
    pub(crate) fn fit_with(&self, pivots: &Pivots) -> Result<CrushFit, ImpactError> {
        let law = pivots.law();
        let (logarithms, location, spread) = self.reduced(law).ok_or(ImpactError::NoFit {
            curve: "distribution of the loads",
            reason: "they are all equal; a fixed load needs no fit",
        })?;
        let scatter = law.scatter(location, spread);
        // The place of the location itself is 0.
        let [low, high] = pivots.offset(0.0);
        let center = Interval {
            low: low.min(0.0),
            best: 0.0,
            high: high.max(0.0),
        }
        .map(|offset| (location + spread * offset).exp());
        let [low, high] = pivots.spread();
        let spread = Interval {
            low: (spread * low).min(spread),
            best: spread,
            high: (spread * high).max(spread),
        };
        let shape = match scatter {
            Scatter::Weibull { .. } => spread.map(f64::recip),
            _ => spread,
        };
        Ok(CrushFit {
            strength: Strength {
                scatter,
                test_diameter: self.mean_diameter(),
                sample_size: Some(u32::try_from(self.loads.len()).unwrap_or(u32::MAX)),
            },
            center,
            shape,
            goodness: Goodness::new(law, &logarithms, location, spread.best),
        })
    }

    /// Mean of the diameters [m].
    pub fn mean_diameter(&self) -> Option<f64> {
        let diameters = self.diameters.as_ref()?;
        Some(diameters.iter().sum::<f64>() / diameters.len() as f64)
    }

    /// Logarithms of the loads at the mean diameter, their location and their spread.
    fn reduced(&self, law: ScatterLaw) -> Option<(Vec<f64>, f64, f64)> {
        let mut logarithms: Vec<f64> = self.loads.iter().map(|load| load.ln()).collect();
        let (mut location, mut spread) = law.fit(&logarithms)?;
        let (Some(diameters), Some(mean)) = (&self.diameters, self.mean_diameter()) else {
            return Some((logarithms, location, spread));
        };
        for _ in 0..MOST_ROUNDS {
            let before = spread;
            let reference = Strength {
                scatter: law.scatter(location, spread),
                test_diameter: Some(mean),
                sample_size: None,
            };
            for ((logarithm, load), &diameter) in
                logarithms.iter_mut().zip(&self.loads).zip(diameters)
            {
                *logarithm = (load / reference.size_effect(diameter)).ln();
            }
            (location, spread) = law.fit(&logarithms)?;
            if (spread / before - 1.0).abs() < 1.0e-12 {
                break;
            }
        }
        Some((logarithms, location, spread))
    }

    fn validate(&self) -> Result<(), ImpactError> {
        if self.loads.len() < FEWEST_LOADS {
            return Err(ImpactError::OutOfBounds {
                quantity: "number of loads",
                value: self.loads.len() as f64,
                unit: "",
                expected: "at least 3; crush more pellets, ISO 4700 asks for 60",
            });
        }
        for &load in &self.loads {
            positive("load", "N", load)?;
        }
        let Some(diameters) = &self.diameters else {
            return Ok(());
        };
        if diameters.len() != self.loads.len() {
            return Err(ImpactError::OutOfBounds {
                quantity: "number of diameters",
                value: diameters.len() as f64,
                unit: "",
                expected: "one for each load, or none at all",
            });
        }
        diameters
            .iter()
            .try_for_each(|&diameter| positive("diameter", "m", diameter))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// Sheets of each kind; the share that an interval holds is then known to 0.7 %.
    const SHEETS: usize = 1000;

    /// Least share of sheets whose interval must hold the truth [-].
    const HELD: f64 = 0.93;

    fn sheet(strength: &Strength, count: usize, random: &mut ChaCha8Rng, sizes: bool) -> CrushTest {
        let diameters: Vec<f64> = (0..count)
            .map(|_| 0.010 + 0.004 * random.random::<f64>())
            .collect();
        let (law, location, spread) = strength.scatter.law().expect("it scatters");
        let loads = diameters
            .iter()
            .map(|&diameter| {
                let load = (location + spread * law.place(1.0 - random.random::<f64>())).exp();
                let size_effect = if sizes {
                    strength.size_effect(diameter)
                } else {
                    1.0
                };
                load * size_effect
            })
            .collect();
        CrushTest {
            loads,
            diameters: sizes.then_some(diameters),
        }
    }

    /// Shares of sheets whose intervals hold the center, the shape and the load of one percent.
    fn held(scatter: Scatter, count: u32, sizes: bool) -> [f64; 3] {
        let truth = Strength {
            scatter,
            test_diameter: Some(0.012),
            sample_size: None,
        };
        let (law, location, spread) = scatter.law().expect("it scatters");
        let pivots = Pivots::new(law, count);
        let shape = match law {
            ScatterLaw::Weibull => 1.0 / spread,
            ScatterLaw::LogNormal => spread,
        };
        let mut random = ChaCha8Rng::seed_from_u64(u64::from(count));
        let mut held = [0.0; 3];
        for _ in 0..SHEETS {
            let sheet = sheet(&truth, count as usize, &mut random, sizes);
            let fit = sheet.fit_with(&pivots).expect("a fit");
            let diameter = sheet.mean_diameter().unwrap_or(0.012);
            let (_, center, width) = fit.strength.scatter.law().expect("it scatters");
            let place = law.place(0.01);
            let [low, high] = pivots
                .offset(place)
                .map(|offset| (center + width * offset).exp());
            let load = truth.load(0.01, diameter).expect("a load").best;
            let held_now = [
                fit.center
                    .holds(location.exp() * truth.size_effect(diameter)),
                fit.shape.holds(shape),
                (low..=high).contains(&load),
            ];
            for (sum, is_held) in held.iter_mut().zip(held_now) {
                *sum += f64::from(u8::from(is_held)) / SHEETS as f64;
            }
        }
        held
    }

    #[test]
    fn known_parameters_lie_in_their_intervals_in_93_of_100_sheets_and_more() {
        let weibull = Scatter::Weibull {
            scale: 2700.0,
            modulus: 4.0,
        };
        let log_normal = Scatter::LogNormal {
            median: 2450.0,
            deviation: 0.3,
        };
        for scatter in [weibull, log_normal] {
            for count in [10, 30, 60] {
                for sizes in [false, true] {
                    let held = held(scatter, count, sizes);
                    assert!(
                        held.iter().all(|share| *share >= HELD),
                        "{scatter:?} {count} {sizes}: {held:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn normal_theory_would_hold_the_modulus_of_ten_pellets_less_often_than_it_says() {
        // Why pivots are drawn: 1.96 √(0.6079/10) on the logarithm of the modulus.
        let pivots = Pivots::new(ScatterLaw::Weibull, 10);
        let [low, high] = pivots.spread();
        let reach = (1.96 * (0.6079_f64 / 10.0).sqrt()).exp();
        assert!(high / low > reach.powi(2) * 1.02, "{low} {high} {reach}");
        assert!(
            low * reach > 1.1 / reach * reach,
            "the modulus is biased upward"
        );
    }

    #[test]
    fn the_wrong_law_is_doubted_more_often_the_more_pellets_are_crushed() {
        let truth = Strength {
            scatter: Scatter::LogNormal {
                median: 2450.0,
                deviation: 0.5,
            },
            test_diameter: None,
            sample_size: None,
        };
        let doubted = |law, count| {
            let mut random = ChaCha8Rng::seed_from_u64(7);
            let pivots = Pivots::new(law, count);
            let doubted = (0..SHEETS).filter(|_| {
                let sheet = sheet(&truth, count as usize, &mut random, false);
                sheet
                    .fit_with(&pivots)
                    .expect("a fit")
                    .goodness
                    .is_doubtful()
            });
            doubted.count() as f64 / SHEETS as f64
        };
        // One in twenty right ones is doubted, with a deviation of 0.7 %.
        for count in [10, 60] {
            let right = doubted(ScatterLaw::LogNormal, count);
            assert!((right - 0.05).abs() < 0.021, "{count}: {right}");
        }
        let few = doubted(ScatterLaw::Weibull, 10);
        let many = doubted(ScatterLaw::Weibull, 60);
        assert!(few < 0.5 * many && many > 0.3, "{few} {many}");
    }

    #[test]
    fn sheets_that_have_no_fit_are_refused_with_the_bound() {
        let sheet = |loads: &[f64]| CrushTest {
            loads: loads.to_vec(),
            diameters: None,
        };
        for (loads, expected) in [
            (&[1.0, 2.0][..], "number of loads is 2; expected at least 3"),
            (&[1.0, 2.0, 0.0], "load is 0 N; expected more than 0"),
            (&[2.0; 9], "they are all equal"),
        ] {
            let refused = sheet(loads).fit(ScatterLaw::Weibull).expect_err(expected);
            assert!(refused.to_string().contains(expected), "{refused}");
        }
        let unequal = CrushTest {
            loads: vec![1.0, 2.0, 3.0],
            diameters: Some(vec![0.01]),
        };
        assert!(unequal.fit(ScatterLaw::LogNormal).is_err());
    }
}
