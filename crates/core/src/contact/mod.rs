//! Contact laws: a touch in, a force out.
//!
//! A law is composed of three parts, each one file: normal, tangential and rolling.
//! To add a part: write its file, then add its variant to the enum below and its arm to the match.

pub mod batch;
pub mod hertz;
pub mod mindlin;
pub mod none;
pub mod peak;
pub mod rolling;
pub mod sampling;

pub use batch::Batch;
pub use sampling::Sampling;

use crate::{MaterialPair, Vec3};
use hertz::NormalForce;
use mindlin::{Mindlin, TangentialForce};
use none::{NoFriction, NoRolling};
use rolling::ConstantTorque;
use sampling::Sample;
use serde::{Deserialize, Serialize};

/// One touch, seen from body A; body B is a pellet or a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Unit vector from B into A [-].
    pub normal: Vec3,
    /// Depth of the overlap along the normal, more than 0 [m].
    pub overlap: f64,
    /// Velocity of A's surface relative to B's at the contact point [m/s].
    pub relative_velocity: Vec3,
    /// Spin of A relative to B [rad/s].
    pub relative_spin: Vec3,
    /// `R* = 1 / (K_A + K_B)`, where a hollow wall's curvature K is negative [m].
    pub effective_radius: f64,
    /// `m* = 1 / (1/m_A + 1/m_B)`; a wall has no inverse mass [kg].
    pub effective_mass: f64,
}

/// What a contact remembers from first touch to release.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactHistory {
    /// Elastic tangential displacement of A's surface relative to B's [m].
    pub tangential_displacement: Vec3,
    /// Normal force that the last step was given [N]: 0 before first touch, more than 0 from then on.
    pub normal_force: f64,
}

/// What a contact does to body A; body B receives the negative force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce {
    /// Normal force, 0 or more [N].
    pub normal: f64,
    /// Force on A, normal and tangential together [N].
    pub force: Vec3,
    /// Rolling torque on A, beside the moment of the force; B receives the negative [N·m].
    pub rolling_torque: Vec3,
    /// Energy stored in the normal spring [J].
    pub elastic_energy: f64,
    /// Rate at which normal damping and rolling resistance turn motion into heat [W].
    pub dissipation: f64,
    /// Energy stored in the tangential spring [J].
    pub sliding_energy: f64,
    /// Rate at which sliding works on the tangential spring, damper and slider together [W].
    ///
    /// The spring stiffens with the overlap, so what it turns into heat is known over time only: this work less the
    /// energy stored.
    pub sliding_power: f64,
}

/// How bodies push apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum NormalLaw {
    /// Hertz's force with damping from the pair's restitution; elastic where that is 1.
    Hertz,
}

/// How bodies resist sliding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum TangentialLaw {
    /// No friction.
    None,
    /// Mindlin's spring with history, capped by Coulomb's friction.
    Mindlin,
}

/// How bodies resist rolling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum RollingLaw {
    /// No resistance.
    None,
    /// A torque of constant size against the rolling.
    ConstantTorque,
}

/// The contact law of a scene, in its three parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct ContactLaws {
    /// How bodies push apart.
    pub normal: NormalLaw,
    /// How bodies resist sliding.
    pub tangential: TangentialLaw,
    /// How bodies resist rolling.
    pub rolling: RollingLaw,
}

impl Default for ContactLaws {
    fn default() -> Self {
        Self {
            normal: NormalLaw::Hertz,
            tangential: TangentialLaw::Mindlin,
            rolling: RollingLaw::ConstantTorque,
        }
    }
}

/// A tangential law.
pub trait Tangential {
    /// Force of a contact whose surfaces slide at `sliding` [m/s], after a `displacement` [m] so far.
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        sliding: Vec3,
        displacement: Vec3,
        time_step: f64,
    ) -> TangentialForce;
}

/// A rolling law.
pub trait Rolling {
    /// Torque on body A, against its rolling over B [N·m].
    fn torque(contact: &Contact, pair: &MaterialPair, normal_force: f64, time_step: f64) -> Vec3;
}

/// Runs a generic function with the types that stand for the laws' tangential and rolling parts.
///
/// The choice is made outside the function, so that a loop inside it holds no branch.
macro_rules! with_parts {
    ($laws:expr, $function:ident ( $($argument:expr),* )) => {
        match ($laws.normal, $laws.tangential, $laws.rolling) {
            (NormalLaw::Hertz, TangentialLaw::None, RollingLaw::None) => {
                $function::<NoFriction, NoRolling>($($argument),*)
            }
            (NormalLaw::Hertz, TangentialLaw::None, RollingLaw::ConstantTorque) => {
                $function::<NoFriction, ConstantTorque>($($argument),*)
            }
            (NormalLaw::Hertz, TangentialLaw::Mindlin, RollingLaw::None) => {
                $function::<Mindlin, NoRolling>($($argument),*)
            }
            (NormalLaw::Hertz, TangentialLaw::Mindlin, RollingLaw::ConstantTorque) => {
                $function::<Mindlin, ConstantTorque>($($argument),*)
            }
        }
    };
}

impl ContactLaws {
    /// Force of one contact over one step.
    pub fn force(
        &self,
        contact: &Contact,
        pair: &MaterialPair,
        history: &mut ContactHistory,
        sampling: &Sampling,
    ) -> ContactForce {
        with_parts!(self, composed_force(contact, pair, history, sampling))
    }

    /// Forces of the first `count` contacts of a batch over one step: the same bits as one by one.
    pub fn forces(&self, batch: &mut Batch, count: usize, sampling: &Sampling) {
        with_parts!(self, composed_forces(batch, count, sampling));
    }
}

/// A contact's normal direction at a sample, and how its surfaces slide.
struct Touch {
    sample: Sample,
    predicted: NormalForce,
    predicted_speed: f64,
    sliding: Vec3,
}

fn composed_force<T: Tangential, R: Rolling>(
    contact: &Contact,
    pair: &MaterialPair,
    history: &mut ContactHistory,
    sampling: &Sampling,
) -> ContactForce {
    let mut touch = touch(contact, pair, history, sampling);
    if touch.sample.is_edge {
        touch.sample = sampling.at_edge(
            contact,
            &touch.predicted,
            touch.predicted_speed,
            history.normal_force,
            touch.sample,
        );
    }
    composed::<T, R>(contact, pair, &touch, history, sampling)
}

/// All lanes as if in the smooth middle of their contacts, then those few again that begin or end.
fn composed_forces<T: Tangential, R: Rolling>(
    batch: &mut Batch,
    count: usize,
    sampling: &Sampling,
) {
    let count = count.min(batch::LANES);
    for lane in 0..count {
        let contact = batch.contact(lane);
        let pair = batch.pair(lane);
        let mut history = batch.history(lane);
        let touch = touch(&contact, &pair, &history, sampling);
        let force = composed::<T, R>(&contact, &pair, &touch, &mut history, sampling);
        batch.set_force(lane, &contact, &force, &history, touch.sample.is_edge);
    }
    if sampling.is_located() {
        for lane in 0..count {
            if batch.is_edge(lane) {
                let contact = batch.contact(lane);
                let pair = batch.pair(lane);
                let mut history = batch.history(lane);
                let force = composed_force::<T, R>(&contact, &pair, &mut history, sampling);
                batch.set_force(lane, &contact, &force, &history, true);
            }
        }
    }
}

#[expect(
    clippy::inline_always,
    reason = "a call in the loop of a batch would keep it from using vector instructions"
)]
#[inline(always)]
fn touch(
    contact: &Contact,
    pair: &MaterialPair,
    history: &ContactHistory,
    sampling: &Sampling,
) -> Touch {
    let predicted_speed = -contact.relative_velocity.dot(&contact.normal);
    let predicted = hertz::force(contact, pair, predicted_speed);
    Touch {
        sample: sampling.smooth(contact, &predicted, predicted_speed, history.normal_force),
        predicted,
        predicted_speed,
        sliding: contact.relative_velocity + predicted_speed * contact.normal,
    }
}

#[expect(
    clippy::inline_always,
    reason = "a call in the loop of a batch would keep it from using vector instructions"
)]
#[inline(always)]
fn composed<T: Tangential, R: Rolling>(
    contact: &Contact,
    pair: &MaterialPair,
    touch: &Touch,
    history: &mut ContactHistory,
    sampling: &Sampling,
) -> ContactForce {
    let Sample { law, applied, .. } = touch.sample;
    let time_step = sampling.time_step();
    let tangential = T::force(
        contact,
        pair,
        &applied,
        touch.sliding,
        history.tangential_displacement,
        time_step,
    );
    let rolling_torque = R::torque(contact, pair, applied.force, time_step);
    *history = ContactHistory {
        tangential_displacement: tangential.displacement,
        normal_force: if applied.force > 0.0 {
            applied.force
        } else {
            f64::MIN_POSITIVE
        },
    };
    ContactForce {
        normal: law.force,
        force: applied.force * contact.normal + tangential.force,
        rolling_torque,
        elastic_energy: law.elastic_energy,
        dissipation: applied.dissipation - rolling_torque.dot(&contact.relative_spin),
        sliding_energy: tangential.elastic_energy,
        sliding_power: tangential.power,
    }
}

#[cfg(test)]
mod contract;
