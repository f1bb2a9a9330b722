//! What contacts remember between steps.
#![expect(
    clippy::inline_always,
    reason = "what is not inlined is not compiled for the instruction set"
)]

use crate::hit::Trace;
use crate::model::Model;
use crate::state::Row;
use pelletflow_core::contact::Batch;
use pelletflow_core::{ContactHistory, ContactLaws, Vec3};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// What every listed contact remembers, in half a cache line.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct ContactMemory {
    /// Elastic tangential displacement of the pellet relative to its partner, times the root of its stiffness [√J].
    pub tangential_stretch: [f64; 3],
    /// Normal force of the last step [N]; rounded, for it only completes a predicted speed.
    pub normal_force: f32,
    /// Steps since first touch [-]; 0 where the two do not touch.
    pub steps: u32,
}

const _: () = assert!(size_of::<ContactMemory>() == size_of::<Row>());

/// The memories of a list of contacts.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ContactMemories {
    /// What every contact remembers.
    pub rows: Vec<ContactMemory>,
    /// What else the laws of the scene need, as many numbers for each contact [units of
    /// [`ContactHistory`]].
    pub extra: Vec<f64>,
    /// What every contact has done, where hits are followed; else empty.
    pub traces: Vec<Trace>,
}

impl ContactMemory {
    /// As the contact laws need it.
    #[inline]
    pub(crate) fn history(&self) -> ContactHistory {
        ContactHistory {
            tangential_stretch: Vec3::from(self.tangential_stretch),
            normal_force: f64::from(self.normal_force),
            samples: f64::from(self.steps),
            ..ContactHistory::default()
        }
    }

    /// One step later, by stretch [√J] and normal force [N].
    #[inline(always)]
    fn stepped(&self, [x, y, z, normal_force]: Row) -> Self {
        Self {
            tangential_stretch: [x, y, z],
            normal_force: rounded(normal_force),
            steps: self.steps.saturating_add(1),
        }
    }

    /// The same contact as its partner remembers it.
    fn mirrored(&self) -> Self {
        Self {
            tangential_stretch: self.tangential_stretch.map(|component| -component),
            ..*self
        }
    }
}

/// A force in single precision that is 0 only where the force is.
#[inline]
fn rounded(force: f64) -> f32 {
    let rounded = force as f32;
    if rounded == 0.0 && force != 0.0 {
        f32::MIN_POSITIVE
    } else {
        rounded
    }
}

impl ContactMemories {
    /// As many contacts that have not begun.
    pub(crate) fn new(count: usize, model: &Model) -> Self {
        let traces = if model.follows_hits() { count } else { 0 };
        Self {
            rows: vec![ContactMemory::default(); count],
            extra: vec![0.0; count * model.laws().extra_numbers()],
            traces: vec![Trace::default(); traces],
        }
    }

    /// All that a contact remembers.
    fn history(&self, slot: usize, laws: ContactLaws) -> ContactHistory {
        let mut history = self.rows[slot].history();
        laws.unpack(&self.extra[self.extra_of(slot)], &mut history);
        history
    }

    /// Puts what a contact remembers into a lane of a batch.
    #[inline(always)]
    pub(crate) fn fill(&self, slot: usize, batch: &mut Batch, lane: usize) {
        let row = &self.rows[slot];
        let force = f64::from(row.normal_force);
        let extra = &self.extra[self.extra_of(slot)];
        let remembered = [force, f64::from(row.steps)];
        batch.set_history(lane, row.tangential_stretch, remembered, extra);
    }

    /// Remembers a contact one step later, and tells whether it goes on; one that does not is still to be ended.
    #[inline(always)]
    pub(crate) fn step(&mut self, slot: usize, batch: &Batch, lane: usize) -> bool {
        let next = batch.next_memory(lane);
        if next[3] == 0.0 {
            return false;
        }
        self.rows[slot] = self.rows[slot].stepped(next);
        let extra = self.extra_of(slot);
        batch.next_extra(lane, &mut self.extra[extra]);
        true
    }

    /// Whether a contact is open.
    pub(crate) fn is_open(&self, slot: usize) -> bool {
        self.rows[slot].steps > 0
    }

    /// Forgets a contact that is over; gives the steps that it lasted and, where hits are followed, what it did.
    pub(crate) fn end(&mut self, slot: usize) -> (u32, Option<Trace>) {
        let steps = std::mem::take(&mut self.rows[slot]).steps;
        let extra = self.extra_of(slot);
        self.extra[extra].fill(0.0);
        (steps, self.traces.get_mut(slot).map(std::mem::take))
    }

    /// Carries on a contact of another list, as its partner remembers it where `side` says so.
    pub(crate) fn carry(
        &mut self,
        slot: usize,
        other: &Self,
        from: usize,
        side: Side,
        laws: ContactLaws,
    ) {
        let memory = other.rows[from];
        // What has not begun is empty here as it is there.
        if memory.steps == 0 {
            return;
        }
        if !self.traces.is_empty() {
            self.traces[slot] = other.traces[from];
        }
        let extra = self.extra_of(slot);
        match side {
            Side::Same => {
                self.rows[slot] = memory;
                self.extra[extra].copy_from_slice(&other.extra[other.extra_of(from)]);
            }
            Side::Partner => {
                self.rows[slot] = memory.mirrored();
                if !extra.is_empty() {
                    let history = other.history(from, laws).mirrored();
                    laws.pack(&history, &mut self.extra[extra]);
                }
            }
        }
    }

    /// Where the extra numbers of a contact are.
    #[inline(always)]
    fn extra_of(&self, slot: usize) -> Range<usize> {
        if self.extra.is_empty() {
            return 0..0;
        }
        let numbers = self.extra.len() / self.rows.len();
        slot * numbers..(slot + 1) * numbers
    }
}

/// Whose view of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// That of the body that remembers it.
    Same,
    /// That of the other.
    Partner,
}
