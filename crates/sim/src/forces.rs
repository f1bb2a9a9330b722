//! Contacts and forces: every listed pair and near wall, chunk by chunk.

use crate::chunk;
use crate::model::Model;
use crate::pair_contacts;
use crate::state::{ChunkContacts, Pellets, State};
use crate::tally::ForceTally;
use crate::wall::WallNow;
use crate::wall_contacts;
use crate::workspace::{ChunkList, Load, Touch, Workspace};
use std::ops::Range;

/// One chunk's share of the stage: what it reads and what it writes.
pub(crate) struct ForceChunk<'a> {
    pub(crate) model: &'a Model,
    pub(crate) pellets: &'a Pellets,
    pub(crate) walls: &'a [WallNow],
    pub(crate) time: f64,
    pub(crate) range: Range<usize>,
    pub(crate) list: &'a ChunkList,
    pub(crate) contacts: &'a mut ChunkContacts,
    pub(crate) touches: &'a mut Vec<Touch>,
    pub(crate) loads: &'a mut [Load],
    pub(crate) tally: ForceTally,
}

/// Sums the loads on every pellet and gives what the contacts did.
///
/// Each pellet's forces are summed by its own chunk in list order, so the bits do not depend on the threads.
pub(crate) fn sum_loads(model: &Model, state: &mut State, workspace: &mut Workspace) -> ForceTally {
    let is_parallel = workspace.is_parallel;
    let State {
        step,
        pellets,
        contacts,
        books,
        ..
    } = state;
    let time = *step as f64 * model.time_step().seconds;
    workspace.loads.resize(pellets.len(), Load::default());
    workspace.touches.resize_with(contacts.len(), Vec::new);
    let mut loads = workspace.loads.as_mut_slice();
    let mut work = Vec::with_capacity(contacts.len());
    let chunks = chunk::ranges(pellets.len())
        .zip(&workspace.lists)
        .zip(contacts)
        .zip(&mut workspace.touches);
    for (((range, list), contacts), touches) in chunks {
        let (own, rest) = loads.split_at_mut(range.len());
        loads = rest;
        work.push(ForceChunk {
            model,
            pellets,
            walls: &workspace.walls,
            time,
            range,
            list,
            contacts,
            touches,
            loads: own,
            tally: ForceTally::new(model.setup().walls.len(), &books.contacts),
        });
    }
    let tallies = chunk::map(is_parallel, work, |mut chunk| {
        chunk.loads.fill(Load::default());
        pair_contacts::add_forces(&mut chunk);
        wall_contacts::add_forces(&mut chunk);
        chunk.tally
    });
    let nothing = ForceTally::new(model.setup().walls.len(), &books.contacts);
    tallies.into_iter().fold(nothing, ForceTally::merged)
}
