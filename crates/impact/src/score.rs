//! Which blows break pellets: the chance of each blow to break its pellet at that very moment.
//!
//! A pellet has one strength for life, drawn from the distribution of the test. It breaks at the first blow that
//! reaches it. So the chance of a blow is the share of strengths that it reaches and no earlier one did, and the
//! chances of the blows of a pellet add up to the chance that it breaks at all. Any way to group blows, by size, wall,
//! place or cause, adds up to the same total.
//!
//! ```
//! use pelletflow_impact::{Blow, Scatter, Strength, StrengthLaw, score};
//!
//! let law = StrengthLaw::Load(Strength {
//!     scatter: Scatter::Weibull { scale: 2700.0, modulus: 4.0 },
//!     test_diameter: None,
//!     sample_size: Some(60),
//! });
//! let blow = |force| Blow { pellet: 7, diameter: 0.012, mass: 3.44e-3, force, energy: 0.05 };
//! let score = score(&law, &[blow(800.0), blow(500.0), blow(1200.0)])?;
//! // The second blow is weaker than the first, and breaks nothing that has lived through that.
//! assert_eq!(score.chances[1].best, 0.0);
//! let total = score.broken();
//! assert!((total.best - (1.0 - (-(1200.0_f64 / 2700.0).powi(4)).exp())).abs() < 1.0e-15);
//! assert!(total.low < total.best && total.best < total.high);
//! # Ok::<(), pelletflow_impact::ImpactError>(())
//! ```

use crate::damage::Weakening;
use crate::error::{ImpactError, not_negative, positive};
use crate::fracture_energy::FractureEnergy;
use crate::interval::Interval;
use crate::share_band::ShareBand;
use crate::strength::{LoadShares, Strength};
use std::iter::Sum;
use std::ops::AddAssign;

/// A blow as one pellet feels it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blow {
    /// Number of the pellet [-].
    pub pellet: u32,
    /// Diameter of the pellet [m].
    pub diameter: f64,
    /// Mass of the pellet [kg].
    pub mass: f64,
    /// Greatest normal force [N].
    pub force: f64,
    /// Kinetic energy of the approach that this pellet takes up [J].
    pub energy: f64,
}

/// What breaks a pellet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StrengthLaw {
    /// The greatest force that it ever feels; what is weaker leaves no trace.
    Load(Strength),
    /// The energy of a blow, against a fracture energy that every blow before has lowered where there is a damage
    /// constant.
    Energy(FractureEnergy),
}

impl StrengthLaw {
    fn validate(&self) -> Result<(), ImpactError> {
        match self {
            Self::Load(strength) => strength.validate(1.0),
            Self::Energy(energy) => energy.validate(),
        }
    }
}

/// The chance of a blow to break its pellet at that very moment, or of several that each some pellet does.
///
/// Each of the three adds up by itself; of a single blow the chance of weaker pellets can be the smaller one, because
/// an earlier blow has broken them already.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Chance {
    /// If pellets are as strong as the test allows [-].
    pub stronger: f64,
    /// If they are as the test found them [-].
    pub best: f64,
    /// If they are as weak as the test allows [-].
    pub weaker: f64,
}

impl Chance {
    /// Number of pellets that break, between what the size of the sample leaves possible at
    /// [`crate::strength::CONFIDENCE`].
    pub fn broken(&self) -> Interval {
        Interval {
            low: self.stronger.min(self.best),
            best: self.best,
            high: self.weaker.max(self.best),
        }
    }
}

impl AddAssign for Chance {
    fn add_assign(&mut self, other: Self) {
        self.stronger += other.stronger;
        self.best += other.best;
        self.weaker += other.weaker;
    }
}

impl Sum for Chance {
    fn sum<I: Iterator<Item = Self>>(chances: I) -> Self {
        chances.fold(Self::default(), |mut sum, chance| {
            sum += chance;
            sum
        })
    }
}

/// What blows do to pellets.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Score {
    /// Of each blow, in their order.
    pub chances: Vec<Chance>,
    /// Standard deviation of the number of pellets that break, by the draw of each one's strength [-].
    pub luck: f64,
}

impl Score {
    /// Number of pellets that all blows break; over the number of pellets, the share that breaks.
    pub fn broken(&self) -> Interval {
        self.chances.iter().copied().sum::<Chance>().broken()
    }
}

/// The chance of each blow to break its pellet at that very blow; the blows of a pellet stand in order of time.
///
/// The interval that the sample leaves is worked out for one load at a time; it holds for a share at that load, and is
/// a little narrow for many loads at once.
///
/// # Errors
///
/// When the law or a blow has a quantity outside its bounds.
pub fn score(law: &StrengthLaw, blows: &[Blow]) -> Result<Score, ImpactError> {
    law.validate()?;
    for (index, blow) in blows.iter().enumerate() {
        blow.validate().map_err(|fault| ImpactError::Blow {
            index,
            fault: Box::new(fault),
        })?;
    }
    let mut order: Vec<u32> =
        (0..u32::try_from(blows.len()).map_err(|_| too_many(blows))?).collect();
    order.sort_by_key(|&index| blows[index as usize].pellet);
    let mut chances = vec![Chance::default(); blows.len()];
    let mut variance = 0.0;
    let mut reach = Reach::new(law);
    for life in
        order.chunk_by(|&one, &other| blows[one as usize].pellet == blows[other as usize].pellet)
    {
        reach.renew();
        let mut before = Interval::exact(0.0);
        for &index in life {
            let index = index as usize;
            let Some(broken) = reach.broken_after(&blows[index]) else {
                continue;
            };
            // Bounds may not fall back where pellets of several sizes would share a number.
            chances[index] = Chance {
                stronger: (broken.low - before.low).max(0.0),
                best: (broken.best - before.best).max(0.0),
                weaker: (broken.high - before.high).max(0.0),
            };
            before = broken;
        }
        variance += before.best * (1.0 - before.best);
    }
    Ok(Score {
        chances,
        luck: variance.max(0.0).sqrt(),
    })
}

impl Blow {
    fn validate(&self) -> Result<(), ImpactError> {
        positive("diameter", "m", self.diameter)?;
        positive("mass", "kg", self.mass)?;
        not_negative("force", "N", self.force)?;
        not_negative("energy", "J", self.energy)
    }
}

fn too_many(blows: &[Blow]) -> ImpactError {
    ImpactError::OutOfBounds {
        quantity: "number of blows",
        value: blows.len() as f64,
        unit: "",
        expected: "at most 4294967295; score a part of the run at a time",
    }
}

/// How far the blows of one pellet have come up the distribution of its strength.
enum Reach<'law> {
    Load {
        strength: &'law Strength,
        shares: LoadShares,
        greatest: f64,
    },
    Energy {
        energy: &'law FractureEnergy,
        shares: ShareBand,
        weakening: Option<Weakening>,
        greatest: f64,
    },
}

impl<'law> Reach<'law> {
    fn new(law: &'law StrengthLaw) -> Self {
        match law {
            StrengthLaw::Load(strength) => Self::Load {
                strength,
                shares: strength.shares(),
                greatest: 0.0,
            },
            StrengthLaw::Energy(energy) => Self::Energy {
                energy,
                shares: energy.shares(),
                weakening: energy
                    .damage_constant
                    .map(|constant| Weakening::new(energy.deviation, constant)),
                greatest: 0.0,
            },
        }
    }

    /// Takes a new pellet.
    fn renew(&mut self) {
        match self {
            Self::Load { greatest, .. } => *greatest = 0.0,
            Self::Energy {
                weakening,
                greatest,
                ..
            } => {
                if let Some(weakening) = weakening {
                    weakening.renew();
                }
                *greatest = 0.0;
            }
        }
    }

    /// Share of strengths broken after a blow; none where it has broken nothing more.
    fn broken_after(&mut self, blow: &Blow) -> Option<Interval> {
        match self {
            Self::Load {
                strength,
                shares,
                greatest,
            } => {
                let load = blow.force / strength.size_effect(blow.diameter);
                (load > *greatest).then(|| {
                    *greatest = load;
                    shares.share(load)
                })
            }
            Self::Energy {
                energy,
                shares,
                weakening,
                greatest,
            } => {
                let medians = blow.energy / blow.mass / energy.median.at(blow.diameter);
                let broken = match weakening {
                    Some(weakening) => weakening.hit(medians),
                    None => medians,
                };
                (broken > *greatest).then(|| {
                    *greatest = broken;
                    shares.share(energy.place(broken))
                })
            }
        }
    }
}
