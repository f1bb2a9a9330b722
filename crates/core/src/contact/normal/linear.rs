//! Linear spring and dashpot.
//!
//! `F = k δ + 2 β √(k m*) δ̇`, never below zero (Cundall & Strack 1979; restitution with the clamp: Schwager & Pöschel
//! 2007). The damping ratio β that gives a restitution is the same as for Hertz.

use super::{Normal, NormalForce};
use crate::MaterialPair;
use crate::contact::{Contact, ContactHistory};

/// A spring of one stiffness, damped.
#[derive(Debug, Clone, Copy)]
pub struct Linear;

impl Normal for Linear {
    const ELASTIC_POWER: f64 = 1.0;
    const DAMPING_POWER: f64 = 0.0;
    const ENDS_AT_ZERO: bool = true;

    /// The contact radius is that of the Hertz contact that has this stiffness, so that friction keeps its share of it.
    #[inline(always)]
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        _: &ContactHistory,
        approach_speed: f64,
    ) -> NormalForce {
        let stiffness = pair.linear_stiffness;
        let contact_radius = stiffness / (2.0 * pair.effective_youngs_modulus);
        let elastic = stiffness * contact.overlap;
        let energy = 0.5 * elastic * contact.overlap;
        NormalForce {
            damping: 2.0 * pair.damping_ratio * (stiffness * contact.effective_mass).sqrt(),
            ..NormalForce::of_spring(contact, contact_radius, elastic, stiffness, energy)
        }
        .at_speed(approach_speed)
    }
}
