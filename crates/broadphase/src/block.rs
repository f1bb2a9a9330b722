//! Pellets near a cell, gathered once for all pellets of the cell.

use crate::cells::Cells;
use crate::periodic::is_image_within_reach;
use crate::{PeriodicBox, SphereRow, is_within_reach};
use std::ops::Range;

/// Slots written at a time.
const LANES: usize = 8;
/// Partners up to which a list is sorted by counting [-].
const FEW: usize = 24;

/// Pellets in a cell and beside it that a pellet of a chunk may list.
#[derive(Debug, Default)]
pub(crate) struct Block {
    count: usize,
    pellets: Vec<u32>,
    rows: Vec<SphereRow>,
    slots: Vec<u32>,
    found: Vec<u32>,
}

impl Block {
    /// Gathers the pellets in and beside a cell that pellets of a chunk from `first` on may list.
    pub(crate) fn gather(
        &mut self,
        cells: &Cells,
        at: [i64; 3],
        first: usize,
        chunk: &Range<usize>,
    ) {
        let mut all = 0;
        cells.visit_beside(at, |run| {
            if all + run.len() + LANES > self.slots.len() {
                self.slots.resize(2 * (all + run.len() + LANES), 0);
            }
            // A fixed number is written and a shorter run overwritten by the next: cheaper than to count to few.
            for start in run.clone().step_by(LANES) {
                let place = all + start - run.start;
                for (lane, slot) in self.slots[place..place + LANES].iter_mut().enumerate() {
                    *slot = (start + lane) as u32;
                }
            }
            all += run.len();
        });
        if all > self.pellets.len() {
            self.pellets.resize(2 * all, 0);
            self.rows.resize(2 * all, [0.0; 4]);
            self.found.resize(2 * all, 0);
        }
        self.count = 0;
        for &slot in &self.slots[..all] {
            let (member, row) = cells.member(slot as usize);
            // Written in any case and kept only by the count: cheaper than a branch that half the members take.
            self.pellets[self.count] = member;
            self.rows[self.count] = *row;
            self.count += usize::from(is_listed(member as usize, first, chunk));
        }
    }

    /// What a pellet of the cell lists, unsorted.
    pub(crate) fn list(
        &mut self,
        index: usize,
        row: &SphereRow,
        chunk: &Range<usize>,
        reach: &Reach,
    ) -> &[u32] {
        match reach.periodic {
            None => self.list_partners(index, chunk, |other| {
                is_within_reach(row, other, reach.skin)
            }),
            Some(periodic) => self.list_partners(index, chunk, |other| {
                is_image_within_reach(&periodic, row, other, reach.skin)
            }),
        }
    }

    #[inline]
    fn list_partners(
        &mut self,
        index: usize,
        chunk: &Range<usize>,
        is_partner: impl Fn(&SphereRow) -> bool,
    ) -> &[u32] {
        let mut count = 0;
        let candidates = self.pellets[..self.count]
            .iter()
            .zip(&self.rows[..self.count]);
        for (&other, row) in candidates {
            self.found[count] = other;
            let is_listed = is_listed(other as usize, index, chunk);
            count += usize::from(is_listed & is_partner(row));
        }
        &self.found[..count]
    }
}

/// Appends different numbers, rising.
pub(crate) fn append_rising(numbers: &[u32], list: &mut Vec<u32>) {
    let first = list.len();
    list.extend_from_slice(numbers);
    let list = &mut list[first..];
    if numbers.len() > FEW {
        list.sort_unstable();
    } else {
        // The place of each is the number of lesser ones: no branch depends on the order.
        for &number in numbers {
            let place = numbers.iter().map(|&other| usize::from(other < number));
            list[place.sum::<usize>()] = number;
        }
    }
}

/// What makes two pellets partners.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    /// Gap below which they are [m].
    pub(crate) skin: f64,
    /// The box, where it is periodic.
    pub(crate) periodic: Option<PeriodicBox>,
}

/// Whether a pellet of a chunk lists another: a pair inside the chunk at its lower index, and any other.
#[inline]
pub(crate) fn is_listed(other: usize, index: usize, chunk: &Range<usize>) -> bool {
    other > index || other < chunk.start
}
