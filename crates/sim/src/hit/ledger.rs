//! The ledger of all hits: exact counts and sums of all, rows of those that matter.

use super::{Hit, HitPartner};
use crate::ledger::MOST_COUNTED;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// What is kept of the hits of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HitRequest {
    /// Greatest force from which on every hit is kept in full [N]; infinite where only those are that no earlier hit of
    /// one of their pellets reached.
    pub threshold: f64,
}

/// Classes of force per doubling [-].
const CLASSES_PER_OCTAVE: f64 = 8.0;
/// Exponents of the least normal and of the greatest finite number [-].
const OCTAVES: [i32; 2] = [f64::MIN_EXP - 1, f64::MAX_EXP - 1];

/// Hits with one partner and of nearly the same force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct HitClassKey {
    /// Index of the wall; none where the partner is a pellet.
    pub wall: Option<usize>,
    /// Number of the class of force [-].
    pub force_class: i32,
}

/// What the hits of one class did together.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct HitClass {
    /// How many [-].
    pub count: u64,
    /// How many of them are kept in full [-].
    pub kept: u64,
    /// Sum of their normal impulses [N·s].
    pub normal_impulse: f64,
    /// Sum of their tangential impulses [N·s].
    pub tangential_impulse: f64,
    /// Energy that they took from motion [J].
    pub lost_energy: f64,
    /// Energy of their approaches along the normal [J].
    pub approach_energy: f64,
}

/// All hits so far: a sketch of all of them, and rows of those that matter.
///
/// A row is kept of a hit that reaches the threshold, and of one that is harder than every hit before it of one of its
/// pellets: what decides whether a pellet of any strength breaks. A pellet makes about as many of these as the
/// logarithm of its hits, so that memory is bounded.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct HitLedger {
    classes: BTreeMap<HitClassKey, HitClass>,
    rows: Vec<Hit>,
}

impl HitClassKey {
    fn new(hit: &Hit) -> Self {
        let wall = match hit.partner {
            HitPartner::Pellet { .. } => None,
            HitPartner::Wall(wall) => Some(wall),
        };
        // A hit without force, as of two that graze each other, goes to the class of the least force there is, and one
        // that a forged checkpoint tells as infinite to that of the greatest.
        let force = hit.peak_force.max(f64::MIN_POSITIVE);
        let class = (CLASSES_PER_OCTAVE * force.log2()).floor() as i32;
        let (least, greatest) = Self::FORCE_CLASSES.into_inner();
        Self {
            wall,
            force_class: class.clamp(least, greatest),
        }
    }

    /// Numbers of the classes of all forces there are, from the least to the greatest [-].
    pub const FORCE_CLASSES: RangeInclusive<i32> = 8 * OCTAVES[0]..=8 * OCTAVES[1] + 7;

    /// Bounds of the greatest force of the class, the upper one outside [N].
    pub fn forces(self) -> [f64; 2] {
        [self.force_class, self.force_class + 1]
            .map(|class| (f64::from(class) / CLASSES_PER_OCTAVE).exp2())
    }
}

impl HitClass {
    /// Adds what other hits did.
    pub fn add(&mut self, other: &Self) {
        self.count += other.count;
        self.kept += other.kept;
        self.normal_impulse += other.normal_impulse;
        self.tangential_impulse += other.tangential_impulse;
        self.lost_energy += other.lost_energy;
        self.approach_energy += other.approach_energy;
    }
}

impl HitLedger {
    /// Enters a hit, in full where `is_kept`.
    pub(super) fn enter(&mut self, hit: Hit, is_kept: IsKept) {
        let class = HitClass {
            count: 1,
            kept: u64::from(is_kept == IsKept::InFull),
            normal_impulse: hit.normal_impulse,
            tangential_impulse: hit.tangential_impulse,
            lost_energy: hit.lost_energy,
            approach_energy: hit.approach_energy(),
        };
        self.classes
            .entry(HitClassKey::new(&hit))
            .or_default()
            .add(&class);
        if is_kept == IsKept::InFull {
            self.rows.push(hit);
        }
    }

    /// The sketch of all hits, by partner and force.
    pub fn classes(&self) -> &BTreeMap<HitClassKey, HitClass> {
        &self.classes
    }

    /// All hits together.
    pub fn total(&self) -> HitClass {
        self.classes
            .values()
            .fold(HitClass::default(), |mut sum, class| {
                sum.add(class);
                sum
            })
    }

    /// The hits kept in full that nobody has taken yet, in the order in which they ended.
    pub fn rows(&self) -> &[Hit] {
        &self.rows
    }

    /// Whether it can be that of a number of walls [-].
    pub(crate) fn fits(&self, walls: usize) -> bool {
        let is_known = |key: &HitClassKey| {
            key.wall.is_none_or(|wall| wall < walls)
                && HitClassKey::FORCE_CLASSES.contains(&key.force_class)
        };
        let mut classes = self.classes.iter();
        classes.all(|(key, class)| {
            is_known(key) && class.kept <= class.count && class.count <= MOST_COUNTED
        })
    }

    /// Its sketch alone.
    pub(super) fn without_rows(&self) -> Self {
        Self {
            classes: self.classes.clone(),
            rows: Vec::new(),
        }
    }

    pub(crate) fn take_rows(&mut self) -> Vec<Hit> {
        std::mem::take(&mut self.rows)
    }
}

/// Whether a hit is kept in full.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum IsKept {
    InFull,
    InSums,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hit::Cause;
    use pelletflow_core::Vec3;

    fn hit(peak_force: f64) -> Hit {
        Hit {
            pellet: 0,
            diameter: 0.012,
            mass: 0.003,
            partner: HitPartner::Wall(0),
            cause: Cause::Drop,
            is_open: false,
            begin: 0.0,
            duration: 1.0e-4,
            steps: 30,
            peak_time: 5.0e-5,
            place: Vec3::zeros(),
            peak_force,
            sampled_force: peak_force,
            arrival_force: peak_force,
            arrival_pressure: 0.0,
            peak_pressure: 0.0,
            normal_impulse: 0.01,
            tangential_impulse: 0.0,
            lost_energy: 0.0,
            approach_speed: 3.0,
            sliding_speed: 0.0,
            effective_radius: 0.006,
        }
    }

    #[test]
    fn every_force_has_a_class_that_holds_it_and_what_is_no_force_has_one_too() {
        for force in [1.0e-300, 1.0e-3, 1.0, 2450.0, 1.0e300] {
            let key = HitClassKey::new(&hit(force));
            let [from, to] = key.forces();
            assert!(from <= force && force < to, "{force}: {from} to {to}");
        }
        for forged in [0.0, -1.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            let key = HitClassKey::new(&hit(forged));
            let class = key.force_class;
            assert!(HitClassKey::FORCE_CLASSES.contains(&class), "{forged}");
        }
    }

    #[test]
    fn a_ledger_of_forces_walls_or_counts_that_there_are_none_of_does_not_fit() {
        let ledger = |wall, force_class, count, kept| HitLedger {
            classes: BTreeMap::from([(
                HitClassKey { wall, force_class },
                HitClass {
                    count,
                    kept,
                    ..HitClass::default()
                },
            )]),
            rows: Vec::new(),
        };
        assert!(ledger(Some(1), 0, 2, 2).fits(2));
        assert!(ledger(None, *HitClassKey::FORCE_CLASSES.end(), 2, 0).fits(0));
        for forged in [
            ledger(Some(2), 0, 2, 2),
            ledger(None, i32::MAX, 2, 2),
            ledger(None, 0, 2, 3),
            ledger(None, 0, u64::MAX, 0),
        ] {
            assert!(!forged.fits(2), "{forged:?}");
        }
    }
}
