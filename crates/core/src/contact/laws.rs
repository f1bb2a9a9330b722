//! The choices for each part of a contact law, and how they meet.

use super::batch::Batch;
use super::compose::{self, Chosen, Fixed};
use super::normal::{Hertz, Jkr, Linear, Plastic, pull_off_gap};
use super::peak::Quantity;
use super::tangential::{Coulomb, Mindlin, NoFriction, PartialSlip};
use super::turning::{ConstantTorque, FreeTurning, SpringDashpot};
use super::{Contact, ContactForce, ContactHistory, Sampling};
use crate::MaterialPair;
use crate::instructions::InstructionSet;
use serde::{Deserialize, Serialize};

/// How bodies push apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum NormalLaw {
    /// Hertz's force with damping from the pair's restitution; elastic where that is 1.
    Hertz,
    /// A spring of the pair's stiffness with damping from its restitution.
    Linear,
    /// Hertz's force up to the pair's yield pressure, damped; plastic beyond.
    Plastic,
    /// Hertz's force with the pair's surface energy: bodies stick.
    Jkr,
}

/// How bodies resist sliding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum TangentialLaw {
    /// No friction.
    None,
    /// Coulomb's friction against any sliding, without memory.
    Coulomb,
    /// Mindlin's spring with history, capped by Coulomb's friction.
    Mindlin,
    /// A row of springs, each let go by friction: the rim slides first.
    PartialSlip,
}

/// How bodies resist rolling, and how they resist twisting.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum TurningLaw {
    /// No resistance.
    None,
    /// A torque of constant size against the turning.
    ConstantTorque,
    /// A damped spring that gives way at that torque.
    SpringDashpot,
}

/// The contact law of a scene, in its four parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct ContactLaws {
    /// How bodies push apart.
    pub normal: NormalLaw,
    /// How bodies resist sliding.
    pub tangential: TangentialLaw,
    /// How bodies resist rolling.
    pub rolling: TurningLaw,
    /// How bodies resist twisting.
    pub twisting: TurningLaw,
}

impl Default for ContactLaws {
    fn default() -> Self {
        Self {
            normal: NormalLaw::Hertz,
            tangential: TangentialLaw::Mindlin,
            rolling: TurningLaw::ConstantTorque,
            twisting: TurningLaw::None,
        }
    }
}

/// Runs a generic function with the type that stands for the normal law.
macro_rules! with_normal {
    ($laws:expr, $function:ident [ $($types:ty),* ] ( $($argument:expr),* )) => {
        match $laws.normal {
            NormalLaw::Hertz => compose::$function::<Hertz, $($types),*>($($argument),*),
            NormalLaw::Linear => compose::$function::<Linear, $($types),*>($($argument),*),
            NormalLaw::Plastic => compose::$function::<Plastic, $($types),*>($($argument),*),
            NormalLaw::Jkr => compose::$function::<Jkr, $($types),*>($($argument),*),
        }
    };
}

/// Works out a batch by the types that stand for the parts.
///
/// The choice is made outside the function, so that a loop inside it holds no branch. Compositions whose functions branch
/// by themselves have nothing of vector instructions and are compiled once.
macro_rules! forces_of {
    ($laws:expr, $batch:expr, $count:expr, $sampling:expr, $instructions:expr) => {
        match $laws.normal {
            NormalLaw::Hertz => forces_of!($laws, $batch, $count, $sampling, $instructions, Hertz),
            NormalLaw::Linear => {
                forces_of!($laws, $batch, $count, $sampling, $instructions, Linear)
            }
            NormalLaw::Plastic | NormalLaw::Jkr => $laws.forces_of_any($batch, $count, $sampling),
        }
    };
    ($laws:expr, $batch:expr, $count:expr, $sampling:expr, $instructions:expr, $normal:ty) => {
        match $laws.tangential {
            TangentialLaw::None => {
                forces_of!(
                    $laws,
                    $batch,
                    $count,
                    $sampling,
                    $instructions,
                    $normal,
                    NoFriction
                )
            }
            TangentialLaw::Coulomb => {
                forces_of!(
                    $laws,
                    $batch,
                    $count,
                    $sampling,
                    $instructions,
                    $normal,
                    Coulomb
                )
            }
            TangentialLaw::Mindlin => {
                forces_of!(
                    $laws,
                    $batch,
                    $count,
                    $sampling,
                    $instructions,
                    $normal,
                    Mindlin
                )
            }
            TangentialLaw::PartialSlip => $laws.forces_of_any($batch, $count, $sampling),
        }
    };
    ($laws:expr, $batch:expr, $count:expr, $sampling:expr, $instructions:expr, $normal:ty, $tangential:ty) => {
        match ($laws.rolling, $laws.twisting) {
            (TurningLaw::None, TurningLaw::None) => {
                let turnings = Fixed::<FreeTurning, FreeTurning>::default();
                compose::forces::<$normal, $tangential, _>(
                    $batch,
                    $count,
                    turnings,
                    $sampling,
                    $instructions,
                )
            }
            (TurningLaw::ConstantTorque, TurningLaw::None) => {
                let turnings = Fixed::<ConstantTorque, FreeTurning>::default();
                compose::forces::<$normal, $tangential, _>(
                    $batch,
                    $count,
                    turnings,
                    $sampling,
                    $instructions,
                )
            }
            (TurningLaw::SpringDashpot, TurningLaw::None) => {
                let turnings = Fixed::<SpringDashpot, FreeTurning>::default();
                compose::forces::<$normal, $tangential, _>(
                    $batch,
                    $count,
                    turnings,
                    $sampling,
                    $instructions,
                )
            }
            _ => $laws.forces_of_any($batch, $count, $sampling),
        }
    };
}

impl ContactLaws {
    /// Force of one contact over one step.
    ///
    /// The contact is over where the memory holds no normal force afterwards.
    pub fn force(
        &self,
        contact: &Contact,
        pair: &MaterialPair,
        history: &mut ContactHistory,
        sampling: &Sampling,
    ) -> ContactForce {
        let turning = self.chosen();
        macro_rules! force {
            ($tangential:ty) => {
                with_normal!(
                    self,
                    force[$tangential, Chosen](contact, pair, &turning, history, sampling)
                )
            };
        }
        match self.tangential {
            TangentialLaw::None => force!(NoFriction),
            TangentialLaw::Coulomb => force!(Coulomb),
            TangentialLaw::Mindlin => force!(Mindlin),
            TangentialLaw::PartialSlip => force!(PartialSlip),
        }
    }

    /// Forces of the first `count` contacts of a batch over one step: the same bits as one by one.
    pub fn forces(
        &self,
        batch: &mut Batch,
        count: usize,
        sampling: &Sampling,
        instructions: InstructionSet,
    ) {
        forces_of!(self, batch, count, sampling, instructions);
    }

    /// The same by laws that may branch.
    fn forces_of_any(self, batch: &mut Batch, count: usize, sampling: &Sampling) {
        let turning = self.chosen();
        let baseline = InstructionSet::Baseline;
        macro_rules! forces {
            ($tangential:ty) => {
                with_normal!(
                    self,
                    forces[$tangential, Chosen](batch, count, turning, sampling, baseline)
                )
            };
        }
        match self.tangential {
            TangentialLaw::None => forces!(NoFriction),
            TangentialLaw::Coulomb => forces!(Coulomb),
            TangentialLaw::Mindlin => forces!(Mindlin),
            TangentialLaw::PartialSlip => forces!(PartialSlip),
        }
    }

    fn chosen(self) -> Chosen {
        Chosen {
            rolling: self.rolling,
            twisting: self.twisting,
        }
    }

    /// Greatest normal force within a step of a sample [N]; that of the sample where the top is farther away.
    pub fn peak_force_near(
        &self,
        contact: &Contact,
        pair: &MaterialPair,
        history: &ContactHistory,
        sampling: &Sampling,
    ) -> f64 {
        let quantity = Quantity::Force;
        with_normal!(self, peak_near[](quantity, contact, pair, history, sampling))
    }

    /// Greatest overlap within a step of a sample [m]; that of the sample where the top is farther away.
    pub fn peak_overlap_near(
        &self,
        contact: &Contact,
        pair: &MaterialPair,
        history: &ContactHistory,
        sampling: &Sampling,
    ) -> f64 {
        let quantity = Quantity::Overlap;
        with_normal!(self, peak_near[](quantity, contact, pair, history, sampling))
    }

    /// Gap between two surfaces up to which bodies that have touched hold on to each other [m].
    pub fn holding_gap(&self, effective_radius: f64, pair: &MaterialPair) -> f64 {
        match self.normal {
            NormalLaw::Jkr => pull_off_gap(effective_radius, pair),
            NormalLaw::Hertz | NormalLaw::Linear | NormalLaw::Plastic => 0.0,
        }
    }

    /// Whether some part turns bodies.
    pub fn turns(&self) -> bool {
        self.tangential != TangentialLaw::None
            || self.rolling != TurningLaw::None
            || self.twisting != TurningLaw::None
    }
}
