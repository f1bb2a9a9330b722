//! What contacts remember between steps.

use crate::state::Row;
use pelletflow_core::{ContactHistory, ContactLaws, Vec3};
use std::ops::Range;

/// What every listed contact remembers, in half a cache line.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
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
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ContactMemories {
    /// What every contact remembers.
    pub rows: Vec<ContactMemory>,
    /// What else the laws of the scene need, as many numbers for each contact [units of
    /// [`ContactHistory`]].
    pub extra: Vec<f64>,
}

impl ContactMemory {
    /// As the contact laws need it.
    #[inline]
    pub(crate) fn history(&self) -> ContactHistory {
        ContactHistory {
            tangential_stretch: Vec3::from(self.tangential_stretch),
            normal_force: f64::from(self.normal_force),
            ..ContactHistory::default()
        }
    }

    /// One step later.
    #[inline]
    pub(crate) fn stepped(&self, history: &ContactHistory) -> Self {
        Self {
            tangential_stretch: history.tangential_stretch.into(),
            normal_force: rounded(history.normal_force),
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
    /// All that a contact remembers.
    pub(crate) fn history(&self, slot: usize, laws: ContactLaws) -> ContactHistory {
        let mut history = self.rows[slot].history();
        laws.unpack(&self.extra[self.extra_of(slot)], &mut history);
        history
    }

    /// Remembers a contact one step later, or forgets one that is over; tells which.
    pub(crate) fn step(
        &mut self,
        slot: usize,
        history: &ContactHistory,
        laws: ContactLaws,
    ) -> bool {
        let is_over = history.normal_force == 0.0;
        if is_over {
            self.forget(slot);
        } else {
            self.rows[slot] = self.rows[slot].stepped(history);
            let extra = self.extra_of(slot);
            laws.pack(history, &mut self.extra[extra]);
        }
        !is_over
    }

    /// Whether a contact is open.
    pub(crate) fn is_open(&self, slot: usize) -> bool {
        self.rows[slot].steps > 0
    }

    /// Forgets a contact that is over.
    pub(crate) fn forget(&mut self, slot: usize) {
        self.rows[slot] = ContactMemory::default();
        let extra = self.extra_of(slot);
        self.extra[extra].fill(0.0);
    }

    /// Adds a contact that has not begun.
    pub(crate) fn push_new(&mut self, laws: ContactLaws) {
        self.rows.push(ContactMemory::default());
        self.extra
            .resize(self.rows.len() * laws.extra_numbers(), 0.0);
    }

    /// Adds a contact of another list, as its partner remembers it where `side` says so.
    pub(crate) fn push_from(&mut self, other: &Self, slot: usize, side: Side, laws: ContactLaws) {
        match side {
            Side::Same => {
                self.rows.push(other.rows[slot]);
                self.extra
                    .extend_from_slice(&other.extra[other.extra_of(slot)]);
            }
            Side::Partner => {
                self.rows.push(other.rows[slot].mirrored());
                let numbers = other.extra_of(slot).len();
                if numbers > 0 {
                    let place = self.extra.len();
                    self.extra.resize(place + numbers, 0.0);
                    let history = other.history(slot, laws).mirrored();
                    laws.pack(&history, &mut self.extra[place..]);
                }
            }
        }
    }

    /// Remembers a contact as its partner does.
    pub(crate) fn adopt(&mut self, slot: usize, other: &Self, theirs: usize, laws: ContactLaws) {
        self.rows[slot] = other.rows[theirs].mirrored();
        let extra = self.extra_of(slot);
        laws.pack(
            &other.history(theirs, laws).mirrored(),
            &mut self.extra[extra],
        );
    }

    /// Where the extra numbers of a contact are.
    fn extra_of(&self, slot: usize) -> Range<usize> {
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
