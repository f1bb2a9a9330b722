//! What a hit loses: damping from the restitution, and viscoelasticity.
//!
//! Lengths are counted in `L = (m* v² / k)^(2/5)` and times in `L/v`. The motion is then that of a unit mass at unit
//! speed, `x″ = −x^1.5 − f(x) x′`, and one number is left of the material.

use crate::error::ImpactError;
use crate::{ElasticImpact, error};
use pelletflow_core::contact::normal;

/// How a hit loses energy along the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// It does not.
    None,
    /// Damping `∝ δ^(1/4) δ̇` that gives this restitution, in (0, 1], with the force never below zero [-].
    Restitution(f64),
    /// The same damping where the force may pull before the overlap is gone; the restitution, in (0, 1] [-].
    RestitutionWithPull(f64),
    /// `F = k (δ^1.5 + 1.5 A δ^0.5 δ̇)` with the relaxation time A, never below zero [s] (Brilliantov et al. 1996).
    Viscoelastic(f64),
}

impl Damping {
    /// Damping ratio β of `F = k δ^1.5 + √5 β √(m k) δ^(1/4) δ̇`, where the damping has this form [-].
    pub fn ratio(&self) -> Option<f64> {
        match *self {
            Self::None => Some(0.0),
            Self::Restitution(restitution) => {
                Some(normal::damping_ratio_for_clamped_restitution(restitution))
            }
            Self::RestitutionWithPull(restitution) => {
                let log = restitution.ln();
                Some(-log / std::f64::consts::PI.hypot(log))
            }
            Self::Viscoelastic(_) => None,
        }
    }

    pub(crate) fn validate(&self) -> Result<(), ImpactError> {
        match *self {
            Self::Restitution(e) | Self::RestitutionWithPull(e) if !(e > 0.0 && e <= 1.0) => {
                Err(ImpactError::OutOfBounds {
                    quantity: "restitution",
                    value: e,
                    unit: "",
                    expected: "more than 0 and at most 1",
                })
            }
            Self::Viscoelastic(time) => error::positive("relaxation time", "s", time),
            _ => Ok(()),
        }
    }

    /// Equal only where the motion is the same in the lengths and times of the hit.
    pub(crate) fn bits(&self, hit: &ElasticImpact) -> [u64; 2] {
        let (kind, number) = match *self {
            Self::None => (0, 0.0),
            Self::Restitution(restitution) => (1, restitution),
            Self::RestitutionWithPull(restitution) => (2, restitution),
            Self::Viscoelastic(relaxation_time) => (3, relaxation_time * hit.speed / hit.length()),
        };
        [kind, number.to_bits()]
    }

    /// The law in the lengths and times of a hit.
    pub(crate) fn law(&self, hit: &ElasticImpact) -> Law {
        let viscosity = match *self {
            Self::Viscoelastic(relaxation_time) => {
                Viscosity::OfRoot(1.5 * relaxation_time * hit.speed / hit.length())
            }
            _ => Viscosity::OfFourthRoot(5.0_f64.sqrt() * self.ratio().unwrap_or(0.0)),
        };
        Law {
            viscosity,
            may_pull: matches!(self, Self::RestitutionWithPull(_)),
        }
    }
}

/// Greatest approach of a damped hit over that of the elastic one [-], for a damping ratio β.
///
/// `[exp(−β/w · atan2(w, β))]^(4/5)`, `w = √(1 − β²)`, below critical damping (Antypov & Elliott 2011); its
/// continuation beyond. Clamping changes nothing before the rebound.
pub fn approach_share(damping_ratio: f64) -> f64 {
    let beta = damping_ratio;
    let squared = 1.0 - beta * beta;
    let exponent = if squared > NEARLY_CRITICAL {
        let w = squared.sqrt();
        beta / w * w.atan2(beta)
    } else if squared < -NEARLY_CRITICAL {
        let w = (-squared).sqrt();
        beta / w * (w / beta).atanh()
    } else {
        1.0
    };
    (-0.8 * exponent).exp()
}

/// Within this of `β² = 1` both branches lose digits to 0/0, and the limit is as exact [-].
const NEARLY_CRITICAL: f64 = 1.0e-9;

/// The force law in the lengths and times of a hit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Law {
    viscosity: Viscosity,
    may_pull: bool,
}

#[derive(Debug, Clone, Copy)]
enum Viscosity {
    /// The coefficient of `x^(1/4) x′`.
    OfFourthRoot(f64),
    /// The coefficient of `x^(1/2) x′`.
    OfRoot(f64),
}

impl Law {
    /// Force at an overlap `x` that grows at `rate`, continued oddly below zero so that the solver sees no kink.
    pub(crate) fn force(self, x: f64, rate: f64) -> f64 {
        let depth = x.abs();
        let root = depth.sqrt();
        let viscous = match self.viscosity {
            Viscosity::OfFourthRoot(share) => share * root.sqrt(),
            Viscosity::OfRoot(share) => share * root,
        };
        x * root + viscous * rate
    }

    /// Changes sign when the force does at the end of the hit; divided by the root that makes it flat there.
    pub(crate) fn release(self, x: f64, rate: f64) -> f64 {
        match self.viscosity {
            _ if self.may_pull => x,
            Viscosity::OfFourthRoot(share) => x * x.abs().sqrt().sqrt() + share * rate,
            Viscosity::OfRoot(share) => x + share * rate,
        }
    }

    /// Changes sign when the force is greatest; multiplied by the root that makes it finite at first touch.
    pub(crate) fn growth(self, x: f64, rate: f64) -> f64 {
        let depth = x.abs();
        let turn = -self.force(x, rate);
        match self.viscosity {
            Viscosity::OfFourthRoot(share) => {
                1.5 * depth * depth.sqrt().sqrt() * rate
                    + share * (0.25 * rate * rate + depth * turn)
            }
            Viscosity::OfRoot(share) => {
                1.5 * depth * rate + share * (0.5 * rate * rate + depth * turn)
            }
        }
    }
}
