//! The force that two bodies make by their arrival alone, at their true stiffness.

use crate::setup::Setup;
use pelletflow_core::{MaterialPair, PairProperties};
use pelletflow_impact::{Damping, ElasticImpact, Outlines};
use std::collections::BTreeMap;

/// Two materials that meet, by their true stiffness.
#[derive(Debug, Clone, Copy)]
struct TruePair {
    effective_youngs_modulus: f64,
    /// Greatest force of a damped hit over that of an elastic one; the same at any speed.
    damped_share: f64,
}

/// The true stiffness and the damping of every pair of materials, where hits are followed.
#[derive(Debug, Clone)]
pub(crate) struct Arrivals {
    /// By two materials, the lesser index first.
    pairs: BTreeMap<[usize; 2], TruePair>,
}

impl Arrivals {
    pub(crate) fn new(setup: &Setup) -> Self {
        let mut pairs = BTreeMap::new();
        if setup.hits.is_some() {
            for ([a, b], properties) in &setup.pairs {
                let materials = [*a.min(b), *a.max(b)];
                pairs.insert(materials, TruePair::new(setup, materials, properties));
            }
        }
        Self { pairs }
    }

    /// Greatest force [N] and pressure [Pa] of two bodies, by material, whose arrival is that of `hit` but for their
    /// stiffness.
    pub(super) fn force_and_pressure(&self, [a, b]: [usize; 2], hit: &ElasticImpact) -> [f64; 2] {
        let pair = &self.pairs[&[a.min(b), a.max(b)]];
        let at_true_stiffness = ElasticImpact {
            effective_youngs_modulus: pair.effective_youngs_modulus,
            ..*hit
        };
        let force = pair.damped_share * at_true_stiffness.peak_force();
        [force, at_true_stiffness.pressure(force)]
    }
}

impl TruePair {
    fn new(setup: &Setup, materials: [usize; 2], properties: &PairProperties) -> Self {
        let [a, b] = materials.map(|index| setup.materials[index].true_material());
        let effective_youngs_modulus =
            MaterialPair::new(&a, &b, properties).effective_youngs_modulus;
        // Which body and how fast does not matter to the share.
        let any = ElasticImpact {
            effective_youngs_modulus,
            effective_radius: 0.01,
            effective_mass: 0.01,
            speed: 1.0,
        };
        // Where damping is so strong that the solver finds no release, the elastic force bounds it.
        let damping = Damping::Restitution(properties.restitution);
        let damped_share = Outlines::default()
            .of(&any, damping)
            .map_or(1.0, |outline| outline.peak_force / any.peak_force());
        Self {
            effective_youngs_modulus,
            damped_share,
        }
    }
}
