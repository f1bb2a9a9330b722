//! A drop test: how many of the pellets dropped at some speeds broke, and the fracture energy fitted to that.

use crate::error::{ImpactError, positive};
use crate::fracture_energy::{FractureEnergy, MedianEnergy};
use crate::interval::Interval;
use crate::scatter::ScatterLaw;
use crate::strength::CONFIDENCE;
use statrs::distribution::{ContinuousCDF, Normal};
use statrs::function::beta::inv_beta_reg;

/// Steps of Newton's method; it takes about six [-].
const MOST_STEPS: usize = 100;

/// Pellets dropped once each at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DropLevel {
    /// Speed at which they hit [m/s].
    pub speed: f64,
    /// Number of pellets dropped [-].
    pub dropped: u32,
    /// Number of them that broke [-].
    pub broken: u32,
}

/// The log-normal fracture energy of a drop test, by maximum likelihood (Finney 1971).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DropFit {
    /// Energy per mass at which half break, with its interval (Fieller 1954) [J/kg].
    pub median: Interval,
    /// Standard deviation of its logarithm, with its interval [-].
    pub deviation: Interval,
    /// Number of pellets dropped [-].
    pub dropped: u32,
}

impl DropLevel {
    /// Kinetic energy per mass that the pellet brings, `v²/2` [J/kg].
    pub fn specific_energy(&self) -> f64 {
        0.5 * self.speed.powi(2)
    }

    /// Share that broke, with its interval at [`CONFIDENCE`] (Clopper & Pearson 1934) [-].
    ///
    /// # Errors
    ///
    /// When none was dropped, or more broke than were dropped.
    pub fn share(&self) -> Result<Interval, ImpactError> {
        self.validate()?;
        let [broken, whole] = [self.broken, self.dropped - self.broken].map(f64::from);
        let tail = 0.5 * (1.0 - CONFIDENCE);
        Ok(Interval {
            low: if broken > 0.0 {
                inv_beta_reg(broken, whole + 1.0, tail)
            } else {
                0.0
            },
            best: broken / (broken + whole),
            high: if whole > 0.0 {
                inv_beta_reg(broken + 1.0, whole, 1.0 - tail)
            } else {
                1.0
            },
        })
    }

    fn validate(&self) -> Result<(), ImpactError> {
        positive("speed", "m/s", self.speed)?;
        positive("number of pellets dropped", "", f64::from(self.dropped))?;
        if self.broken > self.dropped {
            return Err(ImpactError::OutOfBounds {
                quantity: "number of pellets broken",
                value: f64::from(self.broken),
                unit: "",
                expected: "at most the number dropped",
            });
        }
        Ok(())
    }
}

impl DropFit {
    /// Fits the fracture energy to pellets that were dropped once each.
    ///
    /// # Errors
    ///
    /// When a level is none, or the levels leave the distribution open: it takes two speeds at least, where some
    /// pellets survive a faster drop than others break at.
    pub fn new(levels: &[DropLevel]) -> Result<Self, ImpactError> {
        levels.iter().try_for_each(DropLevel::validate)?;
        let speeds = |is_one: fn(&DropLevel) -> bool| {
            let chosen = levels.iter().filter(move |level| is_one(level));
            chosen.map(|level| level.speed)
        };
        let weakest = speeds(|level| level.broken > 0).fold(f64::INFINITY, f64::min);
        let strongest = speeds(|level| level.broken < level.dropped).fold(0.0, f64::max);
        if strongest <= weakest {
            return Err(no_fit(
                "it takes two speeds where some pellets survive the faster and some break at the slower; drop more",
            ));
        }
        // Centered, so that slope and height of the line hardly depend on each other.
        let middle = levels.iter().map(|level| level.specific_energy().ln());
        let middle = middle.sum::<f64>() / levels.len() as f64;
        let (line, information) = probit(levels, middle);
        if line[1] <= 0.0 {
            return Err(no_fit("fewer break at the faster drops; look at the sheet"));
        }
        Self::of_line(levels, middle, line, information)
    }

    /// The fracture energy with a damage constant, which single drops cannot tell [-].
    pub fn fracture_energy(&self, damage_constant: Option<f64>) -> FractureEnergy {
        FractureEnergy {
            median: MedianEnergy::OfAnySize(self.median.best),
            deviation: self.deviation.best,
            truncation: None,
            damage_constant,
            sample_size: Some(self.equivalent_size()),
        }
    }

    /// Number of pellets that would leave intervals as wide, had the fracture energy of each been measured [-].
    ///
    /// A drop tells only whether a pellet broke, so that it counts for less than one.
    fn equivalent_size(&self) -> u32 {
        let law = ScatterLaw::LogNormal;
        let deviations = Normal::standard().inverse_cdf(0.5 + 0.5 * CONFIDENCE);
        let size = |interval: Interval, variance: f64| {
            let reach = 0.5 * (interval.high / interval.low).ln();
            variance * (deviations / reach).powi(2)
        };
        // The variance of a large sample: σ²/n of the median's logarithm, 1/2n of the deviation's.
        let of_median = size(self.median, law.variance(0.0) * self.deviation.best.powi(2));
        let of_deviation = size(self.deviation, law.variance(1.0) - law.variance(0.0));
        (of_median.min(of_deviation) as u32).max(2)
    }

    /// From the line of places over the logarithm of the energy, and the information that it is known with.
    fn of_line(
        levels: &[DropLevel],
        middle: f64,
        [height, slope]: [f64; 2],
        [of_height, of_both, of_slope]: [f64; 3],
    ) -> Result<Self, ImpactError> {
        let determinant = of_height * of_slope - of_both.powi(2);
        let [height_variance, covariance, slope_variance] =
            [of_slope, -of_both, of_height].map(|value| value / determinant);
        let reach = Normal::standard().inverse_cdf(0.5 + 0.5 * CONFIDENCE);
        // Where the line crosses 0: the roots of (height + slope x)² = reach² times its variance.
        let square = slope.powi(2) - reach.powi(2) * slope_variance;
        let linear = height * slope - reach.powi(2) * covariance;
        let constant = height.powi(2) - reach.powi(2) * height_variance;
        let root = (linear.powi(2) - square * constant).sqrt();
        if square.is_nan() || square <= 0.0 || root.is_nan() {
            return Err(no_fit(
                "the share that breaks does not grow clearly with the speed; drop more pellets or farther apart",
            ));
        }
        let energy = |x: f64| (middle + x).exp();
        let factor = (reach * slope_variance.sqrt() / slope).exp();
        Ok(Self {
            median: Interval {
                low: energy((-linear - root) / square),
                best: energy(-height / slope),
                high: energy((-linear + root) / square),
            },
            deviation: Interval {
                low: 1.0 / slope / factor,
                best: 1.0 / slope,
                high: 1.0 / slope * factor,
            },
            dropped: levels.iter().map(|level| level.dropped).sum(),
        })
    }
}

/// Height and slope of the likeliest line, by Fisher's scores, and its information.
fn probit(levels: &[DropLevel], middle: f64) -> ([f64; 2], [f64; 3]) {
    let law = ScatterLaw::LogNormal;
    let mut line = [0.0, 1.0];
    let mut information = [0.0; 3];
    for _ in 0..MOST_STEPS {
        let mut score = [0.0; 2];
        information = [0.0; 3];
        for level in levels {
            let x = level.specific_energy().ln() - middle;
            let place = (line[0] + line[1] * x).clamp(-8.0, 8.0);
            let share = law.share(place);
            let density = (-0.5 * place * place).exp() / std::f64::consts::TAU.sqrt();
            let weight = density / (share * law.share(-place));
            let count = f64::from(level.dropped);
            let excess = weight * (f64::from(level.broken) - count * share);
            let gain = count * weight * density;
            score = [score[0] + excess, score[1] + excess * x];
            information = [
                information[0] + gain,
                information[1] + gain * x,
                information[2] + gain * x * x,
            ];
        }
        let [of_height, of_both, of_slope] = information;
        let determinant = of_height * of_slope - of_both.powi(2);
        let step = [
            (of_slope * score[0] - of_both * score[1]) / determinant,
            (of_height * score[1] - of_both * score[0]) / determinant,
        ];
        line = [line[0] + step[0], line[1] + step[1]];
        if step[0].abs() + step[1].abs() < 1.0e-12 {
            break;
        }
    }
    (line, information)
}

fn no_fit(reason: &'static str) -> ImpactError {
    ImpactError::NoFit {
        curve: "fracture energy",
        reason,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    fn level(speed: f64, dropped: u32, broken: u32) -> DropLevel {
        DropLevel {
            speed,
            dropped,
            broken,
        }
    }

    #[test]
    fn one_broken_of_ten_has_the_published_interval() {
        // Clopper & Pearson (1934): 0.0025 to 0.4450 at 95 %; none of ten: up to 0.3085.
        let share = level(5.0, 10, 1).share().expect("a share");
        assert!((share.low - 0.0025).abs() < 5.0e-5 && (share.high - 0.4450).abs() < 5.0e-5);
        let none = level(5.0, 10, 0).share().expect("a share");
        assert!(none.low == 0.0 && (none.high - 0.3085).abs() < 5.0e-5);
        assert_eq!(level(5.0, 10, 10).share().expect("a share").high, 1.0);
    }

    #[test]
    fn two_speeds_put_the_line_through_both_shares() {
        // Φ(−1) = 0.158655 and Φ(1): 1000 pellets each, rounded to whole ones.
        let fit = DropFit::new(&[level(10.0, 1000, 159), level(20.0, 1000, 841)]).expect("a fit");
        // Half way between 50 and 200 J/kg on the logarithm, one deviation from either.
        assert!((fit.median.best / 100.0 - 1.0).abs() < 1.0e-9);
        assert!((fit.deviation.best / 2.0_f64.ln() - 1.0).abs() < 2.0e-3);
    }

    #[test]
    fn a_known_fracture_energy_lies_in_the_intervals_of_most_sheets() {
        let mut random = ChaCha8Rng::seed_from_u64(1971);
        let [mut median, mut deviation, mut sheets] = [0.0; 3];
        for _ in 0..1000 {
            let levels = [8.0, 12.0, 16.0, 22.0].map(|speed: f64| {
                let place = (0.5 * speed.powi(2) / 100.0).ln() / 0.6;
                let share = ScatterLaw::LogNormal.share(place);
                let broken = (0..40).filter(|_| random.random::<f64>() < share).count();
                level(speed, 40, broken as u32)
            });
            let Ok(fit) = DropFit::new(&levels) else {
                continue;
            };
            sheets += 1.0;
            median += f64::from(u8::from(fit.median.holds(100.0)));
            deviation += f64::from(u8::from(fit.deviation.holds(0.6)));
        }
        assert!(sheets > 990.0, "{sheets}");
        assert!(median / sheets > 0.93, "{}", median / sheets);
        assert!(deviation / sheets > 0.93, "{}", deviation / sheets);
    }

    #[test]
    fn a_drop_tells_less_than_a_pellet_whose_fracture_energy_is_measured() {
        let levels = [
            level(10.0, 100, 16),
            level(14.0, 100, 50),
            level(20.0, 100, 84),
        ];
        let fit = DropFit::new(&levels).expect("a fit");
        let size = fit.fracture_energy(None).sample_size.expect("a size");
        assert!(size > 30 && size < 200, "{size}");
        let more = levels.map(|one| level(one.speed, 4 * one.dropped, 4 * one.broken));
        let more = DropFit::new(&more).expect("a fit").fracture_energy(None);
        // Four times the drops are worth four times the pellets, but for the shape of the intervals of a small sample.
        let ratio = f64::from(more.sample_size.expect("a size")) / f64::from(size);
        assert!((ratio / 4.0 - 1.0).abs() < 0.05, "{ratio}");
    }

    #[test]
    fn drops_that_leave_the_distribution_open_are_refused() {
        for levels in [
            &[level(5.0, 20, 4)][..],
            &[level(5.0, 20, 0), level(10.0, 20, 20)],
            &[level(5.0, 20, 15), level(10.0, 20, 2)],
            &[level(5.0, 20, 21)],
            &[],
        ] {
            assert!(DropFit::new(levels).is_err(), "{levels:?}");
        }
    }
}
