//! Contact laws: a touch in, a force out.
//!
//! A law is composed of three parts, each one file: normal, tangential and rolling.
//! To add a part: write its file, then add its variant to the enum below and its arm to the match.

pub mod hertz;
pub mod mindlin;
pub mod rolling;

use crate::{MaterialPair, Vec3};
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

impl ContactLaws {
    /// Force of one contact over one step of `time_step` [s].
    #[expect(
        clippy::inline_always,
        reason = "a call would pass contact and force through memory: a third of the step"
    )]
    #[inline(always)]
    pub fn force(
        &self,
        contact: &Contact,
        pair: &MaterialPair,
        history: &mut ContactHistory,
        time_step: f64,
    ) -> ContactForce {
        let approach_speed = -contact.relative_velocity.dot(&contact.normal);
        let normal = match self.normal {
            NormalLaw::Hertz => hertz::force(contact, pair, approach_speed),
        };
        let mut total = ContactForce {
            normal: normal.force,
            force: normal.force * contact.normal,
            rolling_torque: Vec3::zeros(),
            elastic_energy: normal.elastic_energy,
            dissipation: normal.dissipation,
            sliding_energy: 0.0,
            sliding_power: 0.0,
        };
        match self.tangential {
            TangentialLaw::None => {}
            TangentialLaw::Mindlin => {
                let sliding = contact.relative_velocity + approach_speed * contact.normal;
                let tangential =
                    mindlin::force(contact, pair, &normal, sliding, history, time_step);
                total.force += tangential.force;
                total.sliding_energy = tangential.elastic_energy;
                total.sliding_power = tangential.power;
            }
        }
        match self.rolling {
            RollingLaw::None => {}
            RollingLaw::ConstantTorque => {
                let torque = rolling::torque(contact, pair, normal.force, time_step);
                total.dissipation -= torque.dot(&contact.relative_spin);
                total.rolling_torque = torque;
            }
        }
        total
    }
}

#[cfg(test)]
mod contract;
