//! What one chunk did in one step; put together in chunk order.

use crate::ledger::ContactStatistics;
use crate::meter::WallTouch;
use crate::model::Model;
use pelletflow_core::contact::batch::Totals;
use pelletflow_core::{Contact, ContactHistory, MaterialPair, Vec3};

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

/// Sums and extremes over the contacts and pellets of a chunk, or of all.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tally {
    /// Open contacts.
    pub(crate) open: u64,
    /// Open contacts with walls.
    pub(crate) open_with_walls: u64,
    /// Greatest so far, in this step or before.
    pub(crate) max_force: f64,
    /// Greatest so far, in this step or before.
    pub(crate) max_overlap_ratio: f64,
    /// Deepest sample of this step, of those that may be too deep.
    pub(crate) deepest: Option<DeepestContact>,
    /// What contacts did, summed.
    pub(crate) totals: Totals,
    pub(crate) wall_power: f64,
    pub(crate) wall_force: Vec<Vec3>,
    /// Contacts with walls that meters watch.
    pub(crate) wall_touches: Vec<WallTouch>,
    /// Contacts that closed.
    pub(crate) finished: u64,
    pub(crate) finished_steps: u64,
    pub(crate) fewest_steps: u32,
    /// Kinetic energy at the start of the step [J].
    pub(crate) kinetic: f64,
    /// Potential energy at the start of the step [J].
    pub(crate) potential: f64,
    /// Square of the greatest speed after the step [m²/s²].
    pub(crate) max_speed_squared: f64,
}

impl Tally {
    /// Starts a step among a number of walls.
    pub(crate) fn begin(&mut self, walls: usize, so_far: &ContactStatistics) {
        let mut wall_force = std::mem::take(&mut self.wall_force);
        let mut wall_touches = std::mem::take(&mut self.wall_touches);
        wall_force.clear();
        wall_force.resize(walls, Vec3::zeros());
        wall_touches.clear();
        *self = Self {
            max_force: so_far.max_force,
            max_overlap_ratio: so_far.max_overlap_ratio,
            fewest_steps: u32::MAX,
            wall_force,
            wall_touches,
            ..Self::default()
        };
    }

    /// Force beyond which a contact may hold a record [N].
    #[inline]
    pub(crate) fn noteworthy_force(&self) -> f64 {
        LIKELY_RECORD * self.max_force
    }

    /// Overlap over the smaller radius beyond which a contact may hold a record, or be too deep [-].
    #[inline]
    pub(crate) fn noteworthy_overlap_ratio(&self, limit: f64) -> f64 {
        (LIKELY_RECORD * self.max_overlap_ratio).min(limit)
    }

    /// Looks closely at a contact that may hold a record.
    ///
    /// Between two steps force and overlap rise by a few percent; so a record is nearly one in the step before.
    pub(crate) fn look_at(
        &mut self,
        model: &Model,
        depth: DeepestContact,
        normal_force: f64,
        (contact, pair, history): (&Contact, &MaterialPair, &ContactHistory),
    ) {
        let (laws, sampling) = (model.laws(), model.sampling());
        if normal_force > self.noteworthy_force() {
            let peak = laws.peak_force_near(1, contact, pair, history, sampling);
            self.max_force = self.max_force.max(peak);
        }
        if depth.ratio > LIKELY_RECORD * self.max_overlap_ratio {
            let peak = laws.peak_overlap_near(contact, pair, history, sampling);
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

    /// Enters what another chunk did; the order of the chunks fixes the bits.
    pub(crate) fn add(&mut self, other: &Self) {
        self.open += other.open;
        self.open_with_walls += other.open_with_walls;
        self.max_force = self.max_force.max(other.max_force);
        self.max_overlap_ratio = self.max_overlap_ratio.max(other.max_overlap_ratio);
        if let Some(deepest) = other.deepest {
            self.deepen(deepest);
        }
        self.totals.add(&other.totals);
        self.wall_power += other.wall_power;
        for (mine, theirs) in self.wall_force.iter_mut().zip(&other.wall_force) {
            *mine += theirs;
        }
        self.wall_touches.extend_from_slice(&other.wall_touches);
        self.finished += other.finished;
        self.finished_steps += other.finished_steps;
        self.fewest_steps = self.fewest_steps.min(other.fewest_steps);
        self.kinetic += other.kinetic;
        self.potential += other.potential;
        self.max_speed_squared = greater(self.max_speed_squared, other.max_speed_squared);
    }
}

/// The greater of two numbers; the sum of kinetic energies knows of those that are none.
#[inline(always)]
#[expect(clippy::inline_always, reason = "it stands in a vectorized loop")]
pub(crate) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
