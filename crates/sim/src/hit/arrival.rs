//! The force that two bodies make by their arrival alone, at their true stiffness.

use crate::setup::Setup;
use pelletflow_core::MaterialPair;
use pelletflow_impact::{Damping, ElasticImpact, Impact};

/// Two materials that meet, by their true stiffness.
#[derive(Debug, Clone, Copy)]
struct TruePair {
    effective_youngs_modulus: f64,
    /// Greatest force of a damped hit over that of an elastic one; the same at any speed.
    damped_share: f64,
}

/// The true stiffness and the damping of every pair of materials.
#[derive(Debug, Clone)]
pub(crate) struct Arrivals {
    materials: usize,
    pairs: Vec<Option<TruePair>>,
}

impl Arrivals {
    pub(crate) fn new(setup: &Setup) -> Self {
        let materials = setup.materials.len();
        let pairs = (0..materials * materials)
            .map(|index| TruePair::new(setup, index / materials, index % materials))
            .collect();
        Self { materials, pairs }
    }

    /// Greatest force of two bodies, by material, whose arrival is that of `hit` but for their stiffness [N].
    pub(super) fn force(&self, [a, b]: [usize; 2], hit: &ElasticImpact) -> f64 {
        let pair = self.pairs[a * self.materials + b]
            .expect("validation refuses a missing pair of materials that can meet");
        let at_true_stiffness = ElasticImpact {
            effective_youngs_modulus: pair.effective_youngs_modulus,
            ..*hit
        };
        pair.damped_share * at_true_stiffness.peak_force()
    }
}

impl TruePair {
    fn new(setup: &Setup, a: usize, b: usize) -> Option<Self> {
        let properties = setup.pair_properties(a, b)?;
        let [a, b] = [a, b].map(|index| setup.materials[index].true_material());
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
        let damped_share = Impact::new(&any, Damping::Restitution(properties.restitution), None)
            .map_or(1.0, |impact| impact.peak_force / any.peak_force());
        Some(Self {
            effective_youngs_modulus,
            damped_share,
        })
    }
}
