//! What contacts remember, carried from the old lists to the new.

use crate::memory::{ContactMemories, Side};
use crate::model::Model;
use crate::state::ChunkContacts;
use crate::workspace::ChunkList;
use pelletflow_core::{ContactLaws, Vec3};
use std::ops::Range;

/// The lists and memories that the contacts had before the pellets were stored anew.
pub(super) struct OldContacts<'a> {
    pub(super) chunk_size: usize,
    pub(super) count: usize,
    pub(super) lists: &'a [ChunkList],
    pub(super) contacts: &'a [ChunkContacts],
}

/// The old list of one pellet.
struct OldList<'a> {
    chunk: usize,
    /// First pellet of the chunk.
    chunk_start: usize,
    /// Place of the first partner in the list of the chunk.
    first: usize,
    partners: &'a [u32],
}

impl OldContacts<'_> {
    /// The memories of a new list of a chunk; `order` names the old index of each new one.
    pub(super) fn carry(
        &self,
        model: &Model,
        list: &ChunkList,
        order: &[u32],
        range: &Range<usize>,
    ) -> ChunkContacts {
        let laws = model.laws();
        let mut contacts = ChunkContacts {
            pellet: ContactMemories::new(list.partners.len(), model),
            wall: ContactMemories::new(list.near_walls.len(), model),
            wall_normals: vec![Vec3::zeros(); list.near_walls.len()],
        };
        for (index, ends) in range.clone().zip(list.offsets.windows(2)) {
            let a = order[index] as usize;
            if a < self.count {
                let slots = ends[0] as usize..ends[1] as usize;
                self.carry_partners(laws, list, order, (a, slots), &mut contacts.pellet);
            }
        }
        self.carry_walls(laws, list, &order[range.clone()], &mut contacts);
        contacts
    }

    /// Carries the memories of one pellet, by old index, to its slots of the new list.
    fn carry_partners(
        &self,
        laws: ContactLaws,
        list: &ChunkList,
        order: &[u32],
        (a, slots): (usize, Range<usize>),
        memories: &mut ContactMemories,
    ) {
        let own = self.list_of(a);
        let mut next = 0;
        for slot in slots {
            let b = order[list.partners[slot] as usize];
            let is_listed_at_b = (own.chunk_start..a).contains(&(b as usize));
            let found = if is_listed_at_b {
                let other = self.list_of(b as usize);
                let place = other.partners.iter().position(|&c| c as usize == a);
                place.map(|place| (other.chunk, other.first + place, Side::Partner))
            } else {
                // Both lists rise while the order is kept: the search goes on where it ended.
                if next > 0 && own.partners[next - 1] >= b {
                    next = 0;
                }
                let rest = own.partners[next..].iter();
                next += rest.take_while(|&&partner| partner < b).count();
                let is_found = own.partners.get(next) == Some(&b);
                is_found.then_some((own.chunk, own.first + next, Side::Same))
            };
            if let Some((chunk, from, side)) = found {
                memories.carry(slot, &self.contacts[chunk].pellet, from, side, laws);
            }
        }
    }

    /// Carries the memories of walls.
    fn carry_walls(
        &self,
        laws: ContactLaws,
        list: &ChunkList,
        order: &[u32],
        contacts: &mut ChunkContacts,
    ) {
        let mut slot = 0;
        // A wall that is touched at several places is listed as many times in a row, and so are its memories.
        for places in list.near_walls.chunk_by(PartialEq::eq) {
            let near = places[0];
            if let Some((chunk, first)) =
                self.of_wall(order[near.pellet as usize] as usize, near.wall)
            {
                let from = &self.contacts[chunk];
                for place in 0..places.len() {
                    let wall = &mut contacts.wall;
                    wall.carry(slot + place, &from.wall, first + place, Side::Same, laws);
                    contacts.wall_normals[slot + place] = from.wall_normals[first + place];
                }
            }
            slot += places.len();
        }
    }

    fn list_of(&self, a: usize) -> OldList<'_> {
        let chunk = a / self.chunk_size;
        let chunk_start = chunk * self.chunk_size;
        let list = &self.lists[chunk];
        let first = list.offsets[a - chunk_start] as usize;
        let end = list.offsets[a - chunk_start + 1] as usize;
        OldList {
            chunk,
            chunk_start,
            first,
            partners: &list.partners[first..end],
        }
    }

    /// Where the memory that pellet `a`, by old index, holds of a wall begins: chunk and first slot.
    fn of_wall(&self, a: usize, wall: u32) -> Option<(usize, usize)> {
        if a >= self.count {
            return None;
        }
        let (chunk, local) = (a / self.chunk_size, a % self.chunk_size);
        let near_walls = &self.lists[chunk].near_walls;
        let sought = (local as u32, wall);
        let place = near_walls.partition_point(|near| (near.pellet, near.wall) < sought);
        let found = near_walls.get(place)?;
        ((found.pellet, found.wall) == sought).then_some((chunk, place))
    }
}
