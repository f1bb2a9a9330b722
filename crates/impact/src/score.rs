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
//! assert_eq!(score.best[1], 0.0);
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

/// The chances of blows to break their pellets, in the order of the blows.
///
/// One column for the strength as the test found it, and two for the weakest and the strongest pellets that the size
/// of its sample leaves possible at [`crate::strength::CONFIDENCE`]. Each adds up by itself; of a single blow the
/// chance of weaker pellets can be the smaller one, because an earlier blow has broken them already.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Score {
    /// Chance of each blow if pellets are as strong as the test allows [-].
    pub stronger: Vec<f64>,
    /// Chance of each blow [-].
    pub best: Vec<f64>,
    /// Chance of each blow if pellets are as weak as the test allows [-].
    pub weaker: Vec<f64>,
}

impl Score {
    /// Number of pellets that all blows break; over the number of pellets, the share that breaks.
    pub fn broken(&self) -> Interval {
        self.broken_by(0..self.best.len())
    }

    /// Number of pellets that some of the blows break, which are named by their place in the list.
    ///
    /// # Panics
    ///
    /// When there is no blow at a place.
    pub fn broken_by(&self, blows: impl IntoIterator<Item = usize>) -> Interval {
        let sums = blows
            .into_iter()
            .fold([0.0; 3], |sums, index| self.add(sums, index));
        interval(sums)
    }

    /// Number of pellets that each group of blows breaks; `groups` names the group of each blow, from 0 on.
    ///
    /// # Panics
    ///
    /// When a group is not less than `count` [-], or there are more groups named than blows.
    pub fn broken_by_group(&self, groups: &[usize], count: usize) -> Vec<Interval> {
        let mut sums = vec![[0.0; 3]; count];
        for (index, &group) in groups.iter().enumerate() {
            sums[group] = self.add(sums[group], index);
        }
        sums.into_iter().map(interval).collect()
    }

    fn add(&self, sums: [f64; 3], index: usize) -> [f64; 3] {
        let chances = [self.stronger[index], self.best[index], self.weaker[index]];
        std::array::from_fn(|column| sums[column] + chances[column])
    }
}

fn interval([stronger, best, weaker]: [f64; 3]) -> Interval {
    Interval {
        low: stronger.min(best),
        best,
        high: weaker.max(best),
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
    let mut score = Score {
        stronger: vec![0.0; blows.len()],
        best: vec![0.0; blows.len()],
        weaker: vec![0.0; blows.len()],
    };
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
            score.stronger[index] = (broken.low - before.low).max(0.0);
            score.best[index] = (broken.best - before.best).max(0.0);
            score.weaker[index] = (broken.high - before.high).max(0.0);
            before = broken;
        }
    }
    Ok(score)
}

/// Greatest share of pellets that blows which nobody recorded could break: `count` of them to a pellet, none stronger
/// than `worst`.
///
/// For a strength against the greatest force one blow is as good as many. It bounds what is missing from a recording
/// with a threshold: to a share found from the blows above, it adds at most this for every pellet without one.
///
/// # Errors
///
/// When the law or the blow has a quantity outside its bounds.
pub fn bound(law: &StrengthLaw, worst: &Blow, count: u32) -> Result<Interval, ImpactError> {
    law.validate()?;
    worst.validate()?;
    let mut reach = Reach::new(law);
    let mut broken = Interval::exact(0.0);
    for _ in 0..count {
        match reach.broken_after(worst) {
            Some(more) => broken = more,
            None => break,
        }
    }
    Ok(broken)
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
