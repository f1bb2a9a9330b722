//! Contacts as they are written: of all that are listed, those that remember something.

use crate::hit::Trace;
use crate::memory::{ContactMemories, ContactMemory};
use crate::model::Model;
use crate::state::ChunkContacts;
use crate::workspace::ChunkList;
use pelletflow_core::Vec3;
use serde::{Deserialize, Serialize};

/// What the contacts of one chunk remember.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct KeptContacts {
    pellet: KeptMemories,
    wall: KeptMemories,
    /// Of all listed places; few pellets are near a wall.
    wall_normals: Vec<Vec3>,
}

/// Memories that are not empty, and their places in the list, rising.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
struct KeptMemories {
    slots: Vec<u32>,
    memories: ContactMemories,
}

impl KeptContacts {
    pub(super) fn of(contacts: &ChunkContacts) -> Self {
        Self {
            pellet: KeptMemories::of(&contacts.pellet),
            wall: KeptMemories::of(&contacts.wall),
            wall_normals: contacts.wall_normals.clone(),
        }
    }
}

/// The contacts of lists after a number of steps [-], each as it was; nothing where they are those of other lists, or older
/// than the run.
pub(super) fn put_back(
    model: &Model,
    lists: &[ChunkList],
    steps: u64,
    kept: Vec<KeptContacts>,
) -> Option<Vec<ChunkContacts>> {
    if lists.len() != kept.len() {
        return None;
    }
    let chunks = lists.iter().zip(kept);
    chunks
        .map(|(list, kept)| {
            let of_walls = list.near_walls.len();
            (kept.wall_normals.len() == of_walls).then_some(())?;
            Some(ChunkContacts {
                pellet: kept.pellet.put_back(model, list.partners.len(), steps)?,
                wall: kept.wall.put_back(model, of_walls, steps)?,
                wall_normals: kept.wall_normals,
            })
        })
        .collect()
}

impl KeptMemories {
    fn of(memories: &ContactMemories) -> Self {
        let numbers = memories.extra.len() / memories.rows.len().max(1);
        let mut kept = Self::default();
        for (slot, row) in memories.rows.iter().enumerate() {
            let extra = &memories.extra[slot * numbers..(slot + 1) * numbers];
            let trace = memories.traces.get(slot);
            let is_empty = is_empty(row)
                && extra.iter().all(|number| number.to_bits() == 0)
                && trace.is_none_or(is_untouched);
            if !is_empty {
                kept.slots.push(slot as u32);
                kept.memories.rows.push(*row);
                kept.memories.extra.extend_from_slice(extra);
                kept.memories.traces.extend(trace);
            }
        }
        kept
    }

    /// As many memories as a list has places, with those kept in theirs.
    fn put_back(&self, model: &Model, places: usize, steps: u64) -> Option<ContactMemories> {
        let numbers = model.laws().extra_numbers();
        let kept = self.slots.len();
        let traces = if model.follows_hits() { kept } else { 0 };
        let is_whole = self.memories.rows.len() == kept
            && self.memories.extra.len() == kept * numbers
            && self.memories.traces.len() == traces;
        let mut rows = self.memories.rows.iter();
        if !is_whole || rows.any(|row| u64::from(row.steps) > steps) {
            return None;
        }
        let mut all = ContactMemories::new(places, model);
        for (place, &slot) in self.slots.iter().enumerate() {
            let slot = slot as usize;
            *all.rows.get_mut(slot)? = self.memories.rows[place];
            all.extra[slot * numbers..(slot + 1) * numbers]
                .copy_from_slice(&self.memories.extra[place * numbers..(place + 1) * numbers]);
            if let Some(trace) = self.memories.traces.get(place) {
                all.traces[slot] = *trace;
            }
        }
        Some(all)
    }
}

/// Whether it is empty to the last bit: a negative zero is not.
fn is_empty(row: &ContactMemory) -> bool {
    row.steps == 0
        && row.normal_force.to_bits() == 0
        && row
            .tangential_stretch
            .iter()
            .all(|stretch| stretch.to_bits() == 0)
}

/// The same of what a contact has done.
fn is_untouched(trace: &Trace) -> bool {
    let Trace {
        sampled_force,
        normal_forces,
        tangential_forces,
        powers,
        place,
        approach_speed,
        sliding_speed,
        effective_radius,
        top_force,
        steps_to_peak,
    } = *trace;
    let of_steps = [sampled_force, normal_forces, tangential_forces, powers];
    let of_touch = [approach_speed, sliding_speed, effective_radius, top_force];
    steps_to_peak == 0
        && of_steps.iter().all(|number| number.to_bits() == 0)
        && of_touch
            .iter()
            .chain(&place)
            .all(|number| number.to_bits() == 0)
}
