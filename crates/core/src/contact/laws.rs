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

/// Runs a macro with the type that stands for the tangential law.
macro_rules! with_tangential {
    ($laws:expr, $run:ident) => {
        match $laws.tangential {
            TangentialLaw::None => $run!(NoFriction),
            TangentialLaw::Coulomb => $run!(Coulomb),
            TangentialLaw::Mindlin => $run!(Mindlin),
            TangentialLaw::PartialSlip => $run!(PartialSlip),
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
        with_tangential!(self, force)
    }

    /// Forces of the first `count` contacts of a batch over one step: the same bits as one by one.
    ///
    /// Laws whose functions branch have nothing of vector instructions; they are compiled for the baseline alone.
    pub fn forces(
        &self,
        batch: &mut Batch,
        count: usize,
        sampling: &Sampling,
        instructions: InstructionSet,
    ) {
        // The choice is made out here, so that the loop over the lanes holds no branch.
        macro_rules! of {
            ($normal:ty, $tangential:ty, $rolling:ty) => {{
                let turnings = Fixed::<$rolling, FreeTurning>::default();
                compose::forces::<$normal, $tangential, _>(
                    batch,
                    count,
                    turnings,
                    sampling,
                    instructions,
                );
            }};
        }
        macro_rules! rolling {
            ($normal:ty, $tangential:ty) => {
                match self.rolling {
                    TurningLaw::None => of!($normal, $tangential, FreeTurning),
                    TurningLaw::ConstantTorque => of!($normal, $tangential, ConstantTorque),
                    TurningLaw::SpringDashpot => self.branching_forces(batch, count, sampling),
                }
            };
        }
        if self.twisting != TurningLaw::None {
            return self.branching_forces(batch, count, sampling);
        }
        match (self.normal, self.tangential) {
            (NormalLaw::Hertz, TangentialLaw::None) => rolling!(Hertz, NoFriction),
            (NormalLaw::Hertz, TangentialLaw::Coulomb) => rolling!(Hertz, Coulomb),
            (NormalLaw::Hertz, TangentialLaw::Mindlin) => rolling!(Hertz, Mindlin),
            (NormalLaw::Linear, TangentialLaw::None) => rolling!(Linear, NoFriction),
            (NormalLaw::Linear, TangentialLaw::Coulomb) => rolling!(Linear, Coulomb),
            (NormalLaw::Linear, TangentialLaw::Mindlin) => rolling!(Linear, Mindlin),
            _ => self.branching_forces(batch, count, sampling),
        }
    }

    fn branching_forces(self, batch: &mut Batch, count: usize, sampling: &Sampling) {
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
        with_tangential!(self, forces);
    }

    fn chosen(self) -> Chosen {
        Chosen {
            rolling: self.rolling,
            twisting: self.twisting,
        }
    }

    /// Greatest normal force within a number of steps of a sample [N]; that of the sample where the top is farther away.
    pub fn peak_force_near(
        &self,
        steps: u32,
        contact: &Contact,
        pair: &MaterialPair,
        history: &ContactHistory,
        sampling: &Sampling,
    ) -> f64 {
        let quantity = (Quantity::Force, steps);
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
        let quantity = (Quantity::Overlap, 1);
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
