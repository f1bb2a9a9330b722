//! What the contacts of one chunk did in one step; merged in chunk order.

use crate::ledger::ContactStatistics;
use crate::meter::WallTouch;
use crate::model::Model;
use pelletflow_core::{Contact, ContactForce, ContactHistory, MaterialPair, Vec3};

/// The other body of a contact, by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Partner {
    Pellet(usize),
    Wall(usize),
}

/// A record is looked for from this share of the last one on [-].
const LIKELY_RECORD: f64 = 0.9;

/// How deep a contact is, over the radius that it is measured by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DeepestContact {
    pub(crate) ratio: f64,
    pub(crate) pellet: usize,
    pub(crate) partner: Partner,
}

/// Sums and extremes over contacts.
#[derive(Debug, Clone)]
pub(crate) struct ForceTally {
    /// Open contacts.
    pub(crate) open: u64,
    /// Open contacts with walls.
    pub(crate) open_with_walls: u64,
    /// Greatest so far, in this step or before.
    pub(crate) max_force: f64,
    /// Greatest so far, in this step or before.
    pub(crate) max_overlap_ratio: f64,
    /// Deepest sample of this step.
    pub(crate) deepest: Option<DeepestContact>,
    pub(crate) elastic_energy: f64,
    pub(crate) dissipation: f64,
    pub(crate) shear_energy: f64,
    pub(crate) shear_power: f64,
    pub(crate) wall_power: f64,
    pub(crate) wall_force: Vec<Vec3>,
    /// Contacts with walls that meters watch.
    pub(crate) wall_touches: Vec<WallTouch>,
    /// Contacts that closed.
    pub(crate) finished: u64,
    pub(crate) finished_steps: u64,
    pub(crate) fewest_steps: u32,
}

impl ForceTally {
    pub(crate) fn new(walls: usize, so_far: &ContactStatistics) -> Self {
        Self {
            open: 0,
            open_with_walls: 0,
            max_force: so_far.max_force,
            max_overlap_ratio: so_far.max_overlap_ratio,
            deepest: None,
            elastic_energy: 0.0,
            dissipation: 0.0,
            shear_energy: 0.0,
            shear_power: 0.0,
            wall_power: 0.0,
            wall_force: vec![Vec3::zeros(); walls],
            wall_touches: Vec::new(),
            finished: 0,
            finished_steps: 0,
            fewest_steps: u32::MAX,
        }
    }

    /// Enters an open contact; `contact` is asked for only where it may hold a record.
    #[inline]
    pub(crate) fn open(
        &mut self,
        force: &ContactForce,
        depth: DeepestContact,
        contact: impl Fn() -> (Contact, MaterialPair, ContactHistory),
        model: &Model,
    ) {
        self.open += 1;
        self.elastic_energy += force.elastic_energy;
        self.dissipation += force.dissipation;
        self.shear_energy += force.shear_energy;
        self.shear_power += force.shear_power;
        // Between two steps force and overlap rise by a few percent; only a likely record is looked at closely.
        if force.normal > LIKELY_RECORD * self.max_force {
            let (contact, pair, history) = contact();
            let laws = model.laws();
            let peak = laws.peak_force_near(&contact, &pair, &history, model.sampling());
            self.max_force = self.max_force.max(peak);
        }
        if depth.ratio > LIKELY_RECORD * self.max_overlap_ratio {
            let (contact, pair, history) = contact();
            let laws = model.laws();
            let peak = laws.peak_overlap_near(&contact, &pair, &history, model.sampling());
            let ratio = depth.ratio * peak / contact.overlap;
            self.max_overlap_ratio = self.max_overlap_ratio.max(ratio);
        }
        self.deepen(depth);
    }

    #[inline]
    fn deepen(&mut self, depth: DeepestContact) {
        if self
            .deepest
            .is_none_or(|deepest| depth.ratio > deepest.ratio)
        {
            self.deepest = Some(depth);
        }
    }

    /// Enters the end of a contact that was open for a number of steps.
    #[inline]
    pub(crate) fn finish(&mut self, steps: u32) {
        self.finished += 1;
        self.finished_steps += u64::from(steps);
        self.fewest_steps = self.fewest_steps.min(steps);
    }

    /// Both together; the order of merging fixes the bits.
    pub(crate) fn merged(mut self, other: Self) -> Self {
        self.open += other.open;
        self.open_with_walls += other.open_with_walls;
        self.max_force = self.max_force.max(other.max_force);
        self.max_overlap_ratio = self.max_overlap_ratio.max(other.max_overlap_ratio);
        if let Some(deepest) = other.deepest {
            self.deepen(deepest);
        }
        self.elastic_energy += other.elastic_energy;
        self.dissipation += other.dissipation;
        self.shear_energy += other.shear_energy;
        self.shear_power += other.shear_power;
        self.wall_power += other.wall_power;
        for (mine, theirs) in self.wall_force.iter_mut().zip(other.wall_force) {
            *mine += theirs;
        }
        self.wall_touches.extend(other.wall_touches);
        self.finished += other.finished;
        self.finished_steps += other.finished_steps;
        self.fewest_steps = self.fewest_steps.min(other.fewest_steps);
        self
    }
}
