//! Elastic and perfectly plastic contact, with the damping of Hertz.
//!
//! Hertz's force up to the overlap where the pressure reaches the yield pressure, a straight line from there on, and
//! Hertz's again, of a flattened surface, where the overlap falls (Thornton 1997, J. Appl. Mech. 64, 383–386).

use super::{Normal, NormalForce, hertz};
use crate::MaterialPair;
use crate::contact::{Contact, ContactHistory};
use std::f64::consts::PI;

/// A contact that yields where the pressure reaches the yield pressure of the pair.
#[derive(Debug, Clone, Copy)]
pub struct Plastic;

/// A contact that has been loaded up to an overlap, and how it unloads.
#[derive(Debug, Clone, Copy)]
struct Loaded {
    /// Effective radius of the flattened surfaces [m].
    radius: f64,
    /// What is left of the overlap at no force [m].
    dent: f64,
    /// What yielding has turned into heat [J].
    heat: f64,
    /// Stiffness at that overlap, on further loading [N/m].
    stiffness: f64,
}

impl Loaded {
    fn new(contact: &Contact, pair: &MaterialPair, deepest: f64) -> Self {
        let (modulus, radius) = (pair.effective_youngs_modulus, contact.effective_radius);
        // The pressure of Hertz in the middle is 2 E* a / (π R*).
        let yield_radius = PI * radius * pair.yield_pressure / (2.0 * modulus);
        let yield_overlap = yield_radius * yield_radius / radius;
        let curvature = 4.0 / 3.0 * modulus;
        let hertz = curvature * radius.sqrt() * deepest.powf(1.5);
        let beyond = deepest - yield_overlap;
        if beyond <= 0.0 {
            return Self {
                radius,
                dent: 0.0,
                heat: 0.0,
                stiffness: 2.0 * modulus * (radius * deepest).sqrt(),
            };
        }
        let slope = PI * pair.yield_pressure * radius;
        let at_yield = curvature * radius.sqrt() * yield_overlap.powf(1.5);
        let force = at_yield + slope * beyond;
        let flattened = radius * hertz / force;
        let elastic_overlap = (force / (curvature * flattened.sqrt())).powf(2.0 / 3.0);
        let work = 0.4 * at_yield * yield_overlap + (at_yield + 0.5 * slope * beyond) * beyond;
        Self {
            radius: flattened,
            dent: deepest - elastic_overlap,
            heat: work - 0.4 * force * elastic_overlap,
            stiffness: slope,
        }
    }
}

impl Normal for Plastic {
    const ELASTIC_POWER: f64 = 1.5;
    const DAMPING_POWER: f64 = 0.25;
    const ENDS_AT_ZERO: bool = true;
    const REMEMBERS_DEPTH: bool = true;

    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        history: &ContactHistory,
        approach_speed: f64,
    ) -> NormalForce {
        let before = history.deepest_overlap;
        let deepest = before.max(contact.overlap);
        let loaded = Loaded::new(contact, pair, deepest);
        let elastic_overlap = (contact.overlap - loaded.dent).max(0.0);
        let contact_radius = (loaded.radius * elastic_overlap).sqrt();
        let unloading = 2.0 * pair.effective_youngs_modulus * contact_radius;
        let elastic = 2.0 / 3.0 * unloading * elastic_overlap;
        let is_loading = contact.overlap >= before;
        let energy = 0.4 * elastic * elastic_overlap;
        let spring_heat = if is_loading {
            loaded.heat - Loaded::new(contact, pair, before).heat
        } else {
            0.0
        };
        NormalForce {
            elastic_overlap,
            damping: hertz::damping(contact, pair, unloading),
            stiffness: if is_loading {
                loaded.stiffness
            } else {
                unloading
            },
            spring_heat,
            ..NormalForce::of_spring(contact, contact_radius, elastic, unloading, energy)
        }
        .at_speed(approach_speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Material, PairProperties, Vec3};

    #[test]
    fn unloading_starts_where_loading_ended() {
        let material = Material {
            density: 3800.0,
            youngs_modulus: 2.0e9,
            poisson_ratio: 0.25,
        };
        let pair = MaterialPair::new(
            &material,
            &material,
            &PairProperties {
                yield_pressure: Some(2.0e7),
                ..PairProperties::ELASTIC
            },
        );
        let contact = Contact {
            normal: Vec3::z(),
            overlap: 1.0e-4,
            relative_velocity: Vec3::zeros(),
            relative_spin: Vec3::zeros(),
            effective_radius: 3.0e-3,
            effective_mass: 1.7e-3,
            inverse_mass: 1.0 / 1.7e-3,
        };
        let yield_overlap = contact.effective_radius
            * (PI * pair.yield_pressure / (2.0 * pair.effective_youngs_modulus)).powi(2);
        let hertz = |overlap: f64| {
            4.0 / 3.0
                * pair.effective_youngs_modulus
                * contact.effective_radius.sqrt()
                * overlap.powf(1.5)
        };
        let slope = PI * pair.yield_pressure * contact.effective_radius;
        let loaded = hertz(yield_overlap) + slope * (contact.overlap - yield_overlap);
        assert!(loaded < hertz(contact.overlap), "it yields");
        let fresh = Plastic::force(&contact, &pair, &ContactHistory::default(), 0.0);
        assert!((fresh.force / loaded - 1.0).abs() < 1.0e-12);
        // The pressure of yielding acts all over the circle but for the rim, which is elastic: a third of it is missing.
        let circle = (2.0 * loaded + hertz(yield_overlap)) / (2.0 * PI * pair.yield_pressure);
        assert!((fresh.contact_radius.powi(2) / circle - 1.0).abs() < 1.0e-12);
    }
}
