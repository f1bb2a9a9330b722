//! Random draws without memory: each is keyed by seed, purpose and serial number, so nothing is left to store.

use pelletflow_core::{Bounds, Vec3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// What a draw is for; two purposes never share numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Purpose {
    FillSize(usize),
    FillPlace(usize),
    InletSize(usize),
    /// Inlet and step.
    InletPlace(usize, u64),
    /// Of the places of an inlet that are looked at before the run.
    InletRoom,
}

/// A stream of random numbers of its own.
pub(crate) struct Draw {
    generator: ChaCha8Rng,
}

impl Draw {
    pub(crate) fn new(seed: u64, purpose: Purpose, serial: u64) -> Self {
        let (family, index, moment) = match purpose {
            Purpose::FillSize(index) => (1_u64, index, 0),
            Purpose::FillPlace(index) => (2, index, 0),
            Purpose::InletSize(index) => (3, index, 0),
            Purpose::InletPlace(index, step) => (4, index, step),
            Purpose::InletRoom => (5, 0, 0),
        };
        let mut key = [0_u8; 32];
        for (part, value) in
            key.chunks_exact_mut(8)
                .zip([seed, family << 32 | index as u64, moment, serial])
        {
            part.copy_from_slice(&value.to_le_bytes());
        }
        Self {
            generator: ChaCha8Rng::from_seed(key),
        }
    }

    /// A number from 0 to 1 [-].
    pub(crate) fn unit(&mut self) -> f64 {
        self.generator.random()
    }

    /// The generator itself, for distributions.
    pub(crate) fn generator(&mut self) -> &mut ChaCha8Rng {
        &mut self.generator
    }

    /// A point of a box [m].
    pub(crate) fn point(&mut self, bounds: &Bounds) -> Vec3 {
        let fractions = Vec3::new(self.unit(), self.unit(), self.unit());
        bounds.min + fractions.component_mul(&(bounds.max - bounds.min))
    }
}
