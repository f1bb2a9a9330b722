//! Neighbors: storage order, lists, and the contacts' memory carried from the old lists to the new.

mod carry;
mod near_walls;
mod order;
mod skin;

use crate::chunk;
use crate::model::Model;
use crate::setup::NeighborSearch;
use crate::state::{Row, State};
use crate::workspace::{ChunkList, Workspace};
use carry::OldContacts;
use near_walls::Walls;
use pelletflow_broadphase::{Grid, HierarchicalGrid, Search, Tree};
use std::ops::Range;

pub(crate) use order::{is_due as is_order_due, steps_before_look};
pub(crate) use skin::SkinChoice;

/// Size ratio up to which one grid finds neighbors faster than one for each octave [-] (docs/decisions/0012).
const GRID_SIZE_RATIO: f64 = 2.0;

/// Whether some pellet may have come within reach of a body that its list does not name.
pub(crate) fn is_search_due(model: &Model, state: &State) -> bool {
    is_search_due_after(model, state, 0.0, 0)
        || state.searched_position.len() != state.pellets.len()
}

/// The same after a number of steps in which no pellet moves by more than `ahead` [m].
pub(crate) fn is_search_due_after(model: &Model, state: &State, ahead: f64, steps: u64) -> bool {
    closed_in(model, state, ahead, steps + 1) > state.skin - model.holding_gap()
}

/// Bound of how far two bodies have come nearer to each other since the last search [m], after a number of steps more in which
/// no pellet moves by more than `ahead` [m].
fn closed_in(model: &Model, state: &State, ahead: f64, steps: u64) -> f64 {
    let walls_moved = model.greatest_wall_speed()
        * model.time_step().seconds
        * (state.steps_since_search + steps) as f64;
    let moved = state.moved_since_search + ahead;
    moved + moved.max(walls_moved)
}

/// Stores the pellets named by `kept` (indices into the present rows) and lists their neighbors.
///
/// Rows not named are dropped with their contacts. Nothing has moved by more than half the skin since the last search.
pub(crate) fn search(model: &Model, state: &mut State, workspace: &mut Workspace, kept: &[u32]) {
    let old_lists = std::mem::take(&mut workspace.lists);
    let old_contacts = std::mem::take(&mut state.contacts);
    let old_count = state.searched_position.len();
    let order = order::of(model, state, kept, workspace.is_parallel);
    state.skin = skin::next(model, state);
    state.pellets.select(&order);
    let count = state.pellets.len();

    let old = OldContacts {
        chunk_size: chunk::size(old_count),
        count: old_count,
        lists: &old_lists,
        contacts: &old_contacts,
    };
    let positions = &state.pellets.position;
    let search = searcher(model, positions, state.skin);
    let walls = Walls::new(model, &workspace.walls, state.skin);
    let listed = chunk::map(
        workspace.is_parallel,
        chunk::ranges(count).collect(),
        |range| {
            let list = list_near(&search, &walls, positions, &range);
            let contacts = old.carry(model, &list, &order, &range);
            (list, contacts)
        },
    );
    (workspace.lists, state.contacts) = listed.into_iter().unzip();
    state.searched_position.clone_from(&state.pellets.position);
    state.moved_since_search = 0.0;
    state.steps_since_search = 0;
}

fn searcher<'a>(model: &Model, positions: &'a [Row], skin: f64) -> Search<'a> {
    let periodic = model.periodic();
    let is_grid_best = model.largest_diameter() <= GRID_SIZE_RATIO * model.smallest_diameter();
    match (model.setup().search, is_grid_best) {
        (NeighborSearch::Grid, _) | (NeighborSearch::Auto, true) => {
            Search::Grid(Grid::new(positions, skin, periodic))
        }
        (NeighborSearch::HierarchicalGrid, _) | (NeighborSearch::Auto, false) => {
            Search::HierarchicalGrid(HierarchicalGrid::new(positions, skin, periodic))
        }
        (NeighborSearch::Tree, _) => Search::Tree(Tree::new(positions, skin, periodic)),
        (NeighborSearch::AllPairs, _) => Search::AllPairs {
            rows: positions,
            skin,
            periodic,
        },
    }
}

/// Makes the lists of the last search again, with the walls where they were then.
///
/// They follow from where the pellets were and from the skin, so that a restart needs none of them.
pub(crate) fn list_again(model: &Model, state: &State, workspace: &mut Workspace) {
    let positions = &state.searched_position;
    let search = searcher(model, positions, state.skin);
    let walls = Walls::new(model, &workspace.walls, state.skin);
    workspace.lists = chunk::map(
        workspace.is_parallel,
        chunk::ranges(positions.len()).collect(),
        |range| list_near(&search, &walls, positions, &range),
    );
}

/// The list of one chunk.
fn list_near(search: &Search, walls: &Walls, positions: &[Row], range: &Range<usize>) -> ChunkList {
    let mut list = ChunkList {
        offsets: vec![0],
        ..ChunkList::default()
    };
    search.list(range, &mut list.offsets, &mut list.partners);
    walls.list(positions, range, &mut list);
    list
}
