//! Neighbors: storage order, lists, and the contacts' memory carried from the old lists to the new.

use crate::chunk;
use crate::memory::Side;
use crate::model::Model;
use crate::setup::NeighborSearch;
use crate::state::{ChunkContacts, Pellets, Row, State, vector};
use crate::workspace::{ChunkList, NearWall, Workspace};
use pelletflow_broadphase::{Grid, Search, Tree, WallTree, morton};
use pelletflow_core::{Bounds, ContactLaws, Vec3};
use std::ops::Range;

/// Size ratio up to which the grid finds neighbors faster than the tree [-] (measured: 1:3 to 1:4).
const GRID_SIZE_RATIO: f64 = 3.5;

/// Whether some pellet may have come within reach of a body that its list does not name.
pub(crate) fn is_search_due(model: &Model, state: &State) -> bool {
    is_search_due_after(model, state, 0.0, 0)
        || state.searched_position.len() != state.pellets.len()
}

/// The same after a number of steps in which no pellet moves by more than `ahead` [m].
pub(crate) fn is_search_due_after(model: &Model, state: &State, ahead: f64, steps: u64) -> bool {
    let walls_moved = model.greatest_wall_speed()
        * model.time_step().seconds
        * (state.steps_since_search + steps + 1) as f64;
    let moved = state.moved_since_search + ahead;
    moved + moved.max(walls_moved) > model.skin() - model.holding_gap()
}

/// Stores the pellets named by `kept` (indices into the present rows) in Morton order and lists their neighbors.
///
/// Rows not named are dropped with their contacts. Nothing has moved by more than half the skin since the last search.
pub(crate) fn search(model: &Model, state: &mut State, workspace: &mut Workspace, kept: &[u32]) {
    let old_lists = std::mem::take(&mut workspace.lists);
    let old_contacts = std::mem::take(&mut state.contacts);
    let old_count = state.searched_position.len();
    let order = storage_order(model, &state.pellets, kept);
    state.pellets.select(&order);
    let count = state.pellets.len();

    let old = OldContacts {
        chunk_size: chunk::size(old_count),
        count: old_count,
        lists: &old_lists,
        contacts: &old_contacts,
    };
    let positions = &state.pellets.position;
    let search = searcher(model, positions);
    let wall_bounds: Vec<Bounds> = model
        .setup()
        .walls
        .iter()
        .zip(&workspace.walls)
        .map(|(wall, now)| wall.bounds(&now.pose))
        .collect();
    let wall_tree = WallTree::new(&wall_bounds);
    let walls = &workspace.walls;
    let listed = chunk::map(
        workspace.is_parallel,
        chunk::ranges(count).collect(),
        |range| {
            let mut list = list_partners(&search, &range);
            list_walls(model, walls, &wall_tree, positions, &range, &mut list);
            let contacts = carry(model.laws(), &old, &list, &order, &range);
            (list, contacts)
        },
    );
    (workspace.lists, state.contacts) = listed.into_iter().unzip();
    state.searched_position.clone_from(&state.pellets.position);
    state.moved_since_search = 0.0;
    state.steps_since_search = 0;
}

fn storage_order(model: &Model, pellets: &Pellets, kept: &[u32]) -> Vec<u32> {
    let rows: Vec<Row> = kept
        .iter()
        .map(|&index| pellets.position[index as usize])
        .collect();
    let cell_width = model.largest_diameter() + model.skin();
    morton::order(&rows, cell_width)
        .into_iter()
        .map(|place| kept[place as usize])
        .collect()
}

fn searcher<'a>(model: &Model, positions: &'a [Row]) -> Search<'a> {
    let (skin, periodic) = (model.skin(), model.periodic());
    let is_grid_best = model.largest_diameter() <= GRID_SIZE_RATIO * model.smallest_diameter();
    match (model.setup().search, is_grid_best) {
        (NeighborSearch::Grid, _) | (NeighborSearch::Auto, true) => {
            Search::Grid(Grid::new(positions, skin, periodic))
        }
        (NeighborSearch::Tree, _) | (NeighborSearch::Auto, false) => {
            Search::Tree(Tree::new(positions, skin, periodic))
        }
        (NeighborSearch::AllPairs, _) => Search::AllPairs {
            rows: positions,
            skin,
            periodic,
        },
    }
}

fn list_partners(search: &Search, range: &Range<usize>) -> ChunkList {
    let mut list = ChunkList {
        offsets: vec![0],
        ..ChunkList::default()
    };
    for index in range.clone() {
        search.partners_into(index, range, &mut list.partners);
        list.offsets.push(list.partners.len() as u32);
    }
    list
}

fn list_walls(
    model: &Model,
    walls: &[crate::wall::WallNow],
    tree: &WallTree,
    positions: &[Row],
    range: &Range<usize>,
    list: &mut ChunkList,
) {
    let setup = model.setup();
    let mut candidates = Vec::new();
    for (local, position) in positions[range.clone()].iter().enumerate() {
        let (center, radius) = (vector(position), position[3]);
        if setup.skips.distant_walls {
            tree.near_into(center, radius, model.skin(), &mut candidates);
        } else {
            candidates.clear();
            candidates.extend(0..setup.walls.len() as u32);
        }
        for &wall in &candidates {
            let index = wall as usize;
            let point = walls[index].pose.inverse_point(center);
            let reach = radius + model.skin();
            let shape = &setup.walls[index].shape;
            let is_near = shape.is_near(point, reach, &mut list.near_triangles);
            if is_near || !setup.skips.distant_walls {
                let near = NearWall {
                    pellet: local as u32,
                    wall,
                };
                list.near_walls
                    .extend(std::iter::repeat_n(near, model.touches_at(index)));
                if model.touchable(index).is_mesh() {
                    list.near_triangle_ends
                        .push(list.near_triangles.len() as u32);
                }
            }
        }
    }
}

/// The lists and memories that the contacts had before the pellets were stored anew.
struct OldContacts<'a> {
    chunk_size: usize,
    count: usize,
    lists: &'a [ChunkList],
    contacts: &'a [ChunkContacts],
}

impl OldContacts<'_> {
    /// Where the memory of a contact of pellets `a` and `b`, both by old index, is: chunk, slot, and whose view it is.
    fn of_pair(&self, a: usize, b: usize) -> Option<(usize, usize, Side)> {
        if a >= self.count || b >= self.count {
            return None;
        }
        let own = self
            .listed_at(a, b)
            .map(|(chunk, slot)| (chunk, slot, Side::Same));
        own.or_else(|| {
            let (chunk, slot) = self.listed_at(b, a)?;
            Some((chunk, slot, Side::Partner))
        })
    }

    fn listed_at(&self, a: usize, b: usize) -> Option<(usize, usize)> {
        let (chunk, local) = (a / self.chunk_size, a % self.chunk_size);
        let list = &self.lists[chunk];
        let first = list.offsets[local] as usize;
        let end = list.offsets[local + 1] as usize;
        let place = list.partners[first..end]
            .iter()
            .position(|&partner| partner as usize == b)?;
        Some((chunk, first + place))
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

fn carry(
    laws: ContactLaws,
    old: &OldContacts,
    list: &ChunkList,
    order: &[u32],
    range: &Range<usize>,
) -> ChunkContacts {
    let mut contacts = ChunkContacts::default();
    contacts.pellet.rows.reserve(list.partners.len());
    for (local, index) in range.clone().enumerate() {
        let a = order[index] as usize;
        let slots = list.offsets[local] as usize..list.offsets[local + 1] as usize;
        for &partner in &list.partners[slots] {
            match old.of_pair(a, order[partner as usize] as usize) {
                Some((chunk, slot, side)) => {
                    let from = &old.contacts[chunk].pellet;
                    contacts.pellet.push_from(from, slot, side, laws);
                }
                None => contacts.pellet.push_new(laws),
            }
        }
    }
    // A wall that is touched at several places is listed as many times in a row, and so are its memories.
    for places in list.near_walls.chunk_by(PartialEq::eq) {
        let near = places[0];
        let a = order[range.start + near.pellet as usize] as usize;
        let first = old.of_wall(a, near.wall);
        for place in 0..places.len() {
            if let Some((chunk, first)) = first {
                let from = &old.contacts[chunk];
                let slot = first + place;
                contacts.wall.push_from(&from.wall, slot, Side::Same, laws);
                contacts.wall_normals.push(from.wall_normals[slot]);
            } else {
                contacts.wall.push_new(laws);
                contacts.wall_normals.push(Vec3::zeros());
            }
        }
    }
    contacts
}
