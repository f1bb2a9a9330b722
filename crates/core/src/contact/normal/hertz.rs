//! Hertz's normal force with damping from the restitution coefficient.
//!
//! `F = 4/3 E* √R* δ^1.5 + 2 √(5/6) β √(S m*) δ̇` with `S = 2 E* √(R* δ)`, never below zero
//! (Tsuji, Tanaka & Ishida 1992; Antypov & Elliott 2011).

use super::{Normal, NormalForce};
use crate::MaterialPair;
use crate::contact::{Contact, ContactHistory};

/// `2 √(5/6)`: turns the damping ratio β into the damping of a Hertz contact [-] (Antypov & Elliott 2011).
const DAMPING_FACTOR: f64 = 1.825_741_858_350_553_6;

/// Hertz's force, damped.
#[derive(Debug, Clone, Copy)]
pub struct Hertz;

impl Normal for Hertz {
    const ELASTIC_POWER: f64 = 1.5;
    const DAMPING_POWER: f64 = 0.25;
    const ENDS_AT_ZERO: bool = true;

    #[inline(always)]
    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        _: &ContactHistory,
        approach_speed: f64,
    ) -> NormalForce {
        let contact_radius = (contact.effective_radius * contact.overlap).sqrt();
        let stiffness = 2.0 * pair.effective_youngs_modulus * contact_radius;
        let elastic = 2.0 / 3.0 * stiffness * contact.overlap;
        let energy = 0.4 * elastic * contact.overlap;
        NormalForce {
            damping: damping(contact, pair, stiffness),
            ..NormalForce::of_spring(contact, contact_radius, elastic, stiffness, energy)
        }
        .at_speed(approach_speed)
    }
}

/// Damping of a contact of a stiffness [N/m], in [N·s/m].
#[inline(always)]
pub(super) fn damping(contact: &Contact, pair: &MaterialPair, stiffness: f64) -> f64 {
    DAMPING_FACTOR * pair.damping_ratio * (stiffness * contact.effective_mass).sqrt()
}

/// Restitution of a Hertz contact of damping ratio β whose force is clamped at zero [-].
///
/// `exp(−β/w · atan2(2 β w, 2 β² − 1))`, `w = √(1 − β²)`, below critical damping; its continuation beyond.
pub fn clamped_restitution(damping_ratio: f64) -> f64 {
    let beta = damping_ratio;
    let exponent = if beta < 1.0 - CRITICAL {
        let w = (1.0 - beta * beta).sqrt();
        beta / w * (2.0 * beta * w).atan2(2.0 * beta * beta - 1.0)
    } else if beta > 1.0 + CRITICAL {
        let w = (beta * beta - 1.0).sqrt();
        beta / w * ((beta + w) / (beta - w)).ln()
    } else {
        2.0
    };
    (-exponent).exp()
}

/// Within this of β = 1 both branches lose digits to 0/0, and the limit is as exact [-].
const CRITICAL: f64 = 1.0e-9;

/// Damping ratio β that gives a restitution in (0, 1] with the force clamped at zero [-].
///
/// The inverse of [`clamped_restitution`], by bisection: it falls steadily from 1 as β grows.
pub fn damping_ratio_for_clamped_restitution(restitution: f64) -> f64 {
    if restitution >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    while clamped_restitution(high) > restitution && high < 1.0e12 {
        high *= 2.0;
    }
    // A double has 53 bits; 80 halvings reach its neighbor from any bracket used here.
    for _ in 0..80 {
        let middle = f64::midpoint(low, high);
        if clamped_restitution(middle) > restitution {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn damping_ratios_match_the_table_of_the_closed_form() {
        // Independent solution of the clamped ODE to 1e-11, tabulated to six digits.
        let table = [
            (0.9, 0.034_265),
            (0.7, 0.122_215),
            (0.5, 0.255_276),
            (0.3, 0.497_239),
            (0.1, 1.243_188),
            (0.05, 1.945_346),
        ];
        for (restitution, damping_ratio) in table {
            let found = damping_ratio_for_clamped_restitution(restitution);
            assert!(
                (found - damping_ratio).abs() < 6.0e-7,
                "e = {restitution}: {found}"
            );
        }
    }

    #[test]
    fn restitution_is_continuous_at_critical_damping() {
        let below = clamped_restitution(1.0 - 2.0e-9);
        let above = clamped_restitution(1.0 + 2.0e-9);
        assert!((below - above).abs() < 1.0e-6);
        assert!((clamped_restitution(1.0) - (-2.0_f64).exp()).abs() < 1.0e-12);
    }
}
