//! The energy that breaks a pellet in a blow, and how it scatters (Tavares & King 1998).
//!
//! Per mass of the pellet, as the energy of a blow is. It is log-normal with an upper end: the share that breaks under
//! `E` is that of the log-normal distribution under `E* = E E_max / (E_max − E)`.

use crate::error::{ImpactError, not_negative, positive, sample};
use crate::scatter::ScatterLaw;
use crate::share_band::ShareBand;

/// The fracture energy of pellets and what blows below it do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FractureEnergy {
    /// Median of the log-normal distribution.
    pub median: MedianEnergy,
    /// Standard deviation of the logarithm of the energy [-].
    pub deviation: f64,
    /// Greatest fracture energy over the median; none where there is no upper end [-].
    pub truncation: Option<f64>,
    /// Damage constant γ: the smaller, the more a weak blow damages; none where it leaves no trace [-].
    pub damage_constant: Option<f64>,
    /// Number of tested pellets; none where the parameters count as exact [-].
    pub sample_size: Option<u32>,
}

/// The median of the fracture energy per mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MedianEnergy {
    /// The same for every size [J/kg].
    OfAnySize(f64),
    /// `E_∞/(1 + k_p/k_s) · [1 + (d₀/d)^φ]`.
    BySize {
        /// Fracture energy of large pellets on a rigid surface, `E_∞` [J/kg].
        large: f64,
        /// Stiffness of the pellet over that of the surface, `k_p/k_s` [-].
        stiffness_ratio: f64,
        /// Diameter `d₀` below which size matters [m].
        diameter: f64,
        /// Exponent φ [-].
        exponent: f64,
    },
}

impl MedianEnergy {
    /// The median for pellets of `diameter` [m] [J/kg].
    pub fn at(&self, diameter: f64) -> f64 {
        match *self {
            Self::OfAnySize(energy) => energy,
            Self::BySize {
                large,
                stiffness_ratio,
                diameter: characteristic,
                exponent,
            } => {
                large / (1.0 + stiffness_ratio) * (1.0 + (characteristic / diameter).powf(exponent))
            }
        }
    }
}

impl FractureEnergy {
    pub(crate) fn validate(&self) -> Result<(), ImpactError> {
        match self.median {
            MedianEnergy::OfAnySize(energy) => positive("fracture energy", "J/kg", energy)?,
            MedianEnergy::BySize {
                large,
                stiffness_ratio,
                diameter,
                exponent,
            } => {
                positive("fracture energy of large pellets", "J/kg", large)?;
                not_negative("ratio of stiffnesses", "", stiffness_ratio)?;
                positive("characteristic diameter", "m", diameter)?;
                positive("exponent of size", "", exponent)?;
            }
        }
        positive(
            "standard deviation of the logarithm of fracture energy",
            "",
            self.deviation,
        )?;
        positive(
            "truncation of fracture energy",
            "",
            self.truncation.unwrap_or(1.0),
        )?;
        positive("damage constant", "", self.damage_constant.unwrap_or(1.0))?;
        sample(self.sample_size)
    }

    pub(crate) fn shares(&self) -> ShareBand {
        ShareBand::new(ScatterLaw::LogNormal, self.sample_size)
    }

    /// Place in the distribution of an energy in medians [-].
    pub(crate) fn place(&self, energy: f64) -> f64 {
        let energy = match self.truncation {
            Some(greatest) if energy >= greatest => f64::INFINITY,
            Some(greatest) => energy * greatest / (greatest - energy),
            None => energy,
        };
        energy.ln() / self.deviation
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PELLET: FractureEnergy = FractureEnergy {
        median: MedianEnergy::BySize {
            large: 100.0,
            stiffness_ratio: 0.25,
            diameter: 0.012,
            exponent: 1.5,
        },
        deviation: 0.5,
        truncation: Some(4.0),
        damage_constant: Some(5.0),
        sample_size: None,
    };

    #[test]
    fn the_median_falls_from_small_pellets_to_that_of_large_ones() {
        let median = |diameter| PELLET.median.at(diameter);
        assert!((median(0.012) - 160.0).abs() < 1.0e-12);
        assert!((median(1.0e6) - 80.0).abs() < 1.0e-6);
        // (12/3)^1.5 = 8.
        assert!((median(0.003) - 720.0).abs() < 1.0e-9);
    }

    #[test]
    fn all_are_broken_at_the_upper_end_and_little_changes_far_below_it() {
        let share = |energy| PELLET.shares().share(PELLET.place(energy)).best;
        assert_eq!(share(4.0), 1.0);
        assert_eq!(share(0.0), 0.0);
        // At E_max/5, E* is 1.25 times E: the median lies at 4/5 of that of the whole distribution.
        assert!((share(0.8) - 0.5).abs() < 1.0e-12);
    }

    #[test]
    fn energies_that_are_none_are_refused() {
        for wrong in [
            FractureEnergy {
                deviation: 0.0,
                ..PELLET
            },
            FractureEnergy {
                damage_constant: Some(-5.0),
                ..PELLET
            },
            FractureEnergy {
                truncation: Some(f64::NAN),
                ..PELLET
            },
            FractureEnergy {
                sample_size: Some(1),
                ..PELLET
            },
            FractureEnergy {
                median: MedianEnergy::OfAnySize(0.0),
                ..PELLET
            },
        ] {
            assert!(wrong.validate().is_err(), "{wrong:?}");
        }
    }
}
