//! How large pellets are.

use crate::random::Draw;
use rand_distr::{Distribution, LogNormal, Normal};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// How large the pellets of a kind are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SizeDistribution {
    /// All alike.
    Single {
        /// Diameter [m].
        diameter: f64,
    },
    /// Any diameter between two is as likely, by number.
    Uniform {
        /// Smallest diameter [m].
        min_diameter: f64,
        /// Largest diameter [m].
        max_diameter: f64,
    },
    /// Normal, by number, without what lies beyond two diameters.
    Normal {
        /// Mean diameter before that is cut off [m].
        mean: f64,
        /// Standard deviation before that is cut off [m].
        deviation: f64,
        /// Smallest diameter [m].
        min_diameter: f64,
        /// Largest diameter [m].
        max_diameter: f64,
    },
    /// Log-normal, by number, without what lies beyond two diameters.
    LogNormal {
        /// Median diameter before that is cut off [m].
        median: f64,
        /// Standard deviation of the logarithm of the diameter before that is cut off [-].
        spread: f64,
        /// Smallest diameter [m].
        min_diameter: f64,
        /// Largest diameter [m].
        max_diameter: f64,
    },
    /// What passes the sieves of a screen analysis, by mass; between two sieves it grows evenly with the opening.
    Sieve {
        /// Openings of the sieves, rising [m].
        openings: Vec<f64>,
        /// Mass that passes each over the whole, rising from 0 to 1 [-].
        passing: Vec<f64>,
    },
}

/// Draws after which a diameter outside the bounds is moved to the nearer one: the bounds hold the middle, so that half
/// of all draws at least are inside.
const MOST_DRAWS: u32 = 100;

/// What the last share of a screen analysis may miss of 1 by rounding [-].
const WHOLE: f64 = 1.0e-9;

/// Parts of the range over which a mean is summed [-].
const PARTS: u32 = 2000;

impl SizeDistribution {
    /// Smallest diameter [m].
    pub fn min_diameter(&self) -> f64 {
        match self {
            Self::Single { diameter } => *diameter,
            Self::Uniform { min_diameter, .. }
            | Self::Normal { min_diameter, .. }
            | Self::LogNormal { min_diameter, .. } => *min_diameter,
            Self::Sieve { openings, passing } => {
                let first = passing.iter().rposition(|&share| share <= 0.0);
                openings
                    .get(first.unwrap_or(0))
                    .copied()
                    .unwrap_or(f64::NAN)
            }
        }
    }

    /// Largest diameter [m].
    pub fn max_diameter(&self) -> f64 {
        match self {
            Self::Single { diameter } => *diameter,
            Self::Uniform { max_diameter, .. }
            | Self::Normal { max_diameter, .. }
            | Self::LogNormal { max_diameter, .. } => *max_diameter,
            Self::Sieve { openings, passing } => {
                let last = passing.iter().position(|&share| share >= 1.0 - WHOLE);
                let last = last.unwrap_or(openings.len().saturating_sub(1));
                openings.get(last).copied().unwrap_or(f64::NAN)
            }
        }
    }

    /// Checks that such sizes can be, where the smallest is not larger than the largest.
    ///
    /// # Errors
    /// What is wrong, its value and the bound.
    pub fn validate(&self) -> Result<(), String> {
        let (min, max) = (self.min_diameter(), self.max_diameter());
        let holds = |what: &str, middle: f64| {
            if (min..=max).contains(&middle) {
                Ok(())
            } else {
                Err(format!(
                    "the {what} is {middle} m; expected one between the smallest, {min} m, and the largest, {max} m"
                ))
            }
        };
        let is_positive = |what: &str, value: f64| {
            if value.is_finite() && value > 0.0 {
                Ok(())
            } else {
                Err(format!("the {what} is {value}; expected more than 0"))
            }
        };
        match self {
            Self::Single { .. } | Self::Uniform { .. } => Ok(()),
            Self::Normal {
                mean, deviation, ..
            } => holds("mean", *mean).and_then(|()| is_positive("deviation", *deviation)),
            Self::LogNormal { median, spread, .. } => {
                holds("median", *median).and_then(|()| is_positive("spread", *spread))
            }
            Self::Sieve { openings, passing } => validate_sieve(openings, passing),
        }
    }

    /// Mean volume of a pellet \[m³\].
    pub fn mean_volume(&self) -> f64 {
        PI / 6.0 * self.mean_cube()
    }

    /// Mean of the cube of the diameter, by number \[m³\].
    fn mean_cube(&self) -> f64 {
        let (min, max) = (self.min_diameter(), self.max_diameter());
        match self {
            Self::Single { diameter } => diameter.powi(3),
            Self::Uniform { .. } => (min + max) * (min * min + max * max) / 4.0,
            Self::Normal {
                mean, deviation, ..
            } => mean_cube_of(min, max, |diameter| {
                (-0.5 * ((diameter - mean) / deviation).powi(2)).exp()
            }),
            Self::LogNormal { median, spread, .. } => mean_cube_of(min, max, |diameter| {
                (-0.5 * ((diameter / median).ln() / spread).powi(2)).exp() / diameter
            }),
            // As many pellets as mass over volume.
            Self::Sieve { openings, passing } => {
                1.0 / classes(openings, passing)
                    .map(|class| class.number())
                    .sum::<f64>()
            }
        }
    }

    /// A diameter [m].
    pub(crate) fn draw(&self, draw: &mut Draw) -> f64 {
        let (min, max) = (self.min_diameter(), self.max_diameter());
        match self {
            Self::Single { diameter } => *diameter,
            Self::Uniform { .. } => min + draw.unit() * (max - min),
            Self::Normal {
                mean, deviation, ..
            } => {
                let normal = Normal::new(*mean, *deviation)
                    .expect("validation refuses a deviation that is not finite");
                within(min, max, || normal.sample(draw.generator()))
            }
            Self::LogNormal { median, spread, .. } => {
                let normal = LogNormal::new(median.ln(), *spread)
                    .expect("validation refuses a spread that is not finite");
                within(min, max, || normal.sample(draw.generator()))
            }
            Self::Sieve { openings, passing } => {
                let all: f64 = classes(openings, passing).map(|class| class.number()).sum();
                let mut sought = draw.unit() * all;
                for class in classes(openings, passing) {
                    if sought < class.number() {
                        return class.diameter(sought / class.number());
                    }
                    sought -= class.number();
                }
                max
            }
        }
    }
}

fn validate_sieve(openings: &[f64], passing: &[f64]) -> Result<(), String> {
    if openings.len() != passing.len() || openings.len() < 2 {
        return Err(format!(
            "there are {} openings and {} shares that pass them; expected as many of both, at least 2",
            openings.len(),
            passing.len()
        ));
    }
    let falls = |values: &[f64], is_fine: fn(f64, f64) -> bool| {
        let mut pairs = values.windows(2).map(|pair| (pair[0], pair[1]));
        pairs.find(|&(one, next)| !is_fine(one, next))
    };
    if let Some((one, next)) = falls(openings, |one, next| one > 0.0 && one < next) {
        return Err(format!(
            "the openings {one} m and {next} m follow each other; expected more than 0 and rising"
        ));
    }
    if let Some((one, next)) = falls(passing, |one, next| one <= next) {
        return Err(format!(
            "the shares {one} and {next} follow each other; expected them to rise"
        ));
    }
    let ends = [passing[0], passing[passing.len() - 1]];
    if ends[0] != 0.0 || (ends[1] - 1.0).abs() > WHOLE {
        return Err(format!(
            "the shares that pass go from {} to {}; expected from 0 to 1, so that the smallest and the largest are known",
            ends[0], ends[1]
        ));
    }
    Ok(())
}

/// The first draw within two bounds, and the nearer bound where there is none.
fn within(min: f64, max: f64, mut draw: impl FnMut() -> f64) -> f64 {
    let mut drawn = draw();
    for _ in 0..MOST_DRAWS {
        if (min..=max).contains(&drawn) {
            return drawn;
        }
        drawn = draw();
    }
    drawn.clamp(min, max)
}

/// Mean of the cube over a range, by a density that need not be normalized.
fn mean_cube_of(min: f64, max: f64, density: impl Fn(f64) -> f64) -> f64 {
    let width = (max - min) / f64::from(PARTS);
    let (mut number, mut cube) = (0.0, 0.0);
    for part in 0..PARTS {
        let diameter = min + (f64::from(part) + 0.5) * width;
        number += density(diameter);
        cube += density(diameter) * diameter.powi(3);
    }
    if number > 0.0 {
        cube / number
    } else {
        f64::midpoint(min, max).powi(3)
    }
}

/// Pellets between two sieves: the same mass for each part of the range.
#[derive(Debug, Clone, Copy)]
struct Class {
    smallest: f64,
    largest: f64,
    mass: f64,
}

/// The classes between the sieves that hold some mass.
fn classes<'a>(openings: &'a [f64], passing: &'a [f64]) -> impl Iterator<Item = Class> + 'a {
    openings
        .windows(2)
        .zip(passing.windows(2))
        .map(|(opening, share)| Class {
            smallest: opening[0],
            largest: opening[1],
            mass: share[1] - share[0],
        })
        .filter(|class| class.mass > 0.0)
}

impl Class {
    /// Number of pellets over `mass / d³`: the mean of d⁻³ over the range times the mass.
    fn number(&self) -> f64 {
        let (a, b) = (self.smallest, self.largest);
        0.5 * self.mass * (a + b) / (a * b).powi(2)
    }

    /// The diameter below which a share of the class lies, by number.
    fn diameter(&self, share: f64) -> f64 {
        let (a, b) = (self.smallest.powi(-2), self.largest.powi(-2));
        (a - share * (a - b)).powf(-0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Purpose;

    fn drawn(sizes: &SizeDistribution, count: u32) -> Vec<f64> {
        let mut draw = Draw::new(7, Purpose::FillSize(0), 0);
        (0..count).map(|_| sizes.draw(&mut draw)).collect()
    }

    fn all() -> Vec<SizeDistribution> {
        let (min_diameter, max_diameter) = (0.008, 0.016);
        vec![
            SizeDistribution::Single { diameter: 0.012 },
            SizeDistribution::Uniform {
                min_diameter,
                max_diameter,
            },
            SizeDistribution::Normal {
                mean: 0.011,
                deviation: 0.002,
                min_diameter,
                max_diameter,
            },
            SizeDistribution::LogNormal {
                median: 0.011,
                spread: 0.25,
                min_diameter,
                max_diameter,
            },
            SizeDistribution::Sieve {
                openings: vec![0.006, 0.008, 0.010, 0.0125, 0.016],
                passing: vec![0.0, 0.0, 0.1, 0.6, 1.0],
            },
        ]
    }

    #[test]
    fn drawn_diameters_lie_between_the_extremes_and_have_the_mean_volume() {
        for sizes in all() {
            let diameters = drawn(&sizes, 40_000);
            let (min, max) = (sizes.min_diameter(), sizes.max_diameter());
            assert!(
                diameters
                    .iter()
                    .all(|diameter| (min..=max).contains(diameter)),
                "{sizes:?}"
            );
            let volume = diameters
                .iter()
                .map(|diameter| PI / 6.0 * diameter.powi(3))
                .sum::<f64>()
                / diameters.len() as f64;
            // The scatter of a volume is half of its mean; a mean of 40,000 is four standard errors within 1 %.
            let error = volume / sizes.mean_volume() - 1.0;
            assert!(error.abs() < 0.01, "{sizes:?}: {error}");
        }
    }

    #[test]
    fn what_passes_a_sieve_is_the_mass_of_the_analysis() {
        let openings = vec![0.008, 0.010, 0.0125, 0.016];
        let passing = vec![0.0, 0.1, 0.6, 1.0];
        let sizes = SizeDistribution::Sieve {
            openings: openings.clone(),
            passing: passing.clone(),
        };
        let diameters = drawn(&sizes, 40_000);
        let mass = |limit: f64| -> f64 {
            diameters
                .iter()
                .filter(|&&diameter| diameter <= limit)
                .map(|diameter| diameter.powi(3))
                .sum()
        };
        for (opening, share) in openings.iter().zip(passing) {
            // Four standard errors of 40,000 draws.
            assert!(
                (mass(*opening) / mass(1.0) - share).abs() < 0.012,
                "{opening} m"
            );
        }
        // Half way between two sieves half of the mass between them passes.
        assert!((mass(0.01125) / mass(1.0) - 0.35).abs() < 0.012);
    }

    #[test]
    fn a_symmetric_cut_keeps_the_middle_of_a_normal_distribution() {
        let sizes = SizeDistribution::Normal {
            mean: 0.012,
            deviation: 0.002,
            min_diameter: 0.008,
            max_diameter: 0.016,
        };
        let diameters = drawn(&sizes, 40_000);
        let mean = diameters.iter().sum::<f64>() / diameters.len() as f64;
        // Four standard errors of 2 mm / 200.
        assert!((mean - 0.012).abs() < 4.0e-5, "{mean}");
    }
}
