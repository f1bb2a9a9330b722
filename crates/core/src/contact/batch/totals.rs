//! What the contacts of a batch do together.

use super::{BLOCK, Batch, LANES, whole_blocks};

/// What the contacts of a batch did together, of those that are counted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Totals {
    /// Energy stored in normal springs [J].
    pub elastic_energy: f64,
    /// Heat made by the normal direction [W].
    pub dissipation: f64,
    /// Energy stored in springs against sliding, rolling and twisting [J].
    pub shear_energy: f64,
    /// Work on springs, dampers and sliders against sliding, rolling and twisting [W].
    pub shear_power: f64,
}

impl Totals {
    /// Adds what other contacts did.
    #[inline(always)]
    pub fn add(&mut self, other: &Self) {
        self.elastic_energy += other.elastic_energy;
        self.dissipation += other.dissipation;
        self.shear_energy += other.shear_energy;
        self.shear_power += other.shear_power;
    }
}

impl Batch {
    /// How many of the first `count` contacts are counted [-].
    #[inline(always)]
    pub fn counted(&self, count: usize) -> u64 {
        let counted = &self.counted[..count.min(LANES)];
        counted.iter().map(|&counted| counted as u64).sum()
    }

    /// Whether some contact of the first `count` has a greater normal force than `force` [N].
    #[inline(always)]
    pub fn exceeds_force(&self, count: usize, force: f64) -> bool {
        let mut exceeds = false;
        for lane in 0..count.min(LANES) {
            exceeds |= self.force[3][lane] > force;
        }
        exceeds
    }

    /// Whether some overlap of the first `count` is more than `share` of the smaller sphere's radius.
    #[inline(always)]
    pub fn exceeds_overlap(&self, count: usize, share: f64) -> bool {
        let mut exceeds = false;
        for lane in 0..count.min(LANES) {
            let (a, b) = (self.radii[0][lane], self.radii[1][lane]);
            let smaller = if a < b { a } else { b };
            exceeds |= self.overlap[lane] > share * smaller;
        }
        exceeds
    }

    /// What the counted contacts of the first `count` did together, summed in an order that is always the same.
    #[inline(always)]
    pub fn totals(&self, count: usize) -> Totals {
        let mut sums = [[0.0; BLOCK]; 4];
        for first in (0..whole_blocks(count)).step_by(BLOCK) {
            for place in 0..BLOCK {
                let lane = first + place;
                let is_counted = lane < count && self.counted[lane] > 0.0;
                for (sum, values) in sums.iter_mut().zip(&self.scalar) {
                    sum[place] += if is_counted { values[lane] } else { 0.0 };
                }
            }
        }
        let [elastic_energy, dissipation, shear_energy, shear_power] =
            sums.map(|sum| sum.into_iter().sum());
        Totals {
            elastic_energy,
            dissipation,
            shear_energy,
            shear_power,
        }
    }
}
