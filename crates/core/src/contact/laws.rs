//! The choices for each part of a contact law, and how they meet.

use super::batch::Batch;
use super::compose::{self, Chosen, Fixed};
use super::normal::{Hertz, Jkr, Linear, Plastic, pull_off_gap};
use super::peak::Quantity;
use super::tangential::{Coulomb, Mindlin, NoFriction, PartialSlip};
use super::turning::{ConstantTorque, FreeTurning};
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

/// Runs a function of batches with the types that stand for the parts, and tells whether there is one.
///
/// The choice is made outside the function, so that a loop inside it holds no branch.
macro_rules! with_batched_parts {
    ($laws:expr, $arguments:tt) => {
        match $laws.normal {
            NormalLaw::Hertz => with_batched_parts!($laws, $arguments, Hertz),
            NormalLaw::Linear => with_batched_parts!($laws, $arguments, Linear),
            NormalLaw::Plastic | NormalLaw::Jkr => false,
        }
    };
    ($laws:expr, $arguments:tt, $normal:ty) => {
        match $laws.tangential {
            TangentialLaw::None => with_batched_parts!($laws, $arguments, $normal, NoFriction),
            TangentialLaw::Coulomb => with_batched_parts!($laws, $arguments, $normal, Coulomb),
            TangentialLaw::Mindlin => with_batched_parts!($laws, $arguments, $normal, Mindlin),
            TangentialLaw::PartialSlip => false,
        }
    };
    ($laws:expr, ( $($argument:expr),* ), $normal:ty, $tangential:ty) => {
        match ($laws.rolling, $laws.twisting) {
            (TurningLaw::None, TurningLaw::None) => {
                compose::forces::<$normal, $tangential, Fixed<FreeTurning, FreeTurning>>($($argument),*)
            }
            (TurningLaw::ConstantTorque, TurningLaw::None) => {
                compose::forces::<$normal, $tangential, Fixed<ConstantTorque, FreeTurning>>($($argument),*)
            }
            _ => false,
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
        let turning = Chosen {
            rolling: self.rolling,
            twisting: self.twisting,
        };
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

    /// Whether these laws can be worked out in batches.
    pub fn has_batch(&self) -> bool {
        matches!(self.normal, NormalLaw::Hertz | NormalLaw::Linear)
            && self.tangential != TangentialLaw::PartialSlip
            && self.rolling != TurningLaw::SpringDashpot
            && self.twisting == TurningLaw::None
    }

    /// Forces of the first `count` contacts of a batch over one step: the same bits as one by one.
    ///
    /// Tells whether these laws can be worked out in batches; nothing is done where they cannot.
    pub fn forces(
        &self,
        batch: &mut Batch,
        count: usize,
        sampling: &Sampling,
        instructions: InstructionSet,
    ) -> bool {
        with_batched_parts!(self, (batch, count, sampling, instructions))
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
