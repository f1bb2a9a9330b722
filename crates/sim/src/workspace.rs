//! Scratch: deleting it changes no answer.

use crate::chunk;
use crate::contact_view::KeptContact;
use crate::hit::Ended;
use crate::profile::{ChunkClock, Profile};
use crate::state::Row;
use crate::tally::Tally;
use crate::wall::WallNow;
use crate::wall_contacts::Waiting;
use pelletflow_core::contact::Batch;

/// Lists, loads and clocks.
#[derive(Debug, Default)]
pub struct Workspace {
    /// Who might touch whom, chunk by chunk.
    pub(crate) lists: Vec<ChunkList>,
    /// What else each chunk works with.
    pub(crate) chunks: Vec<ChunkScratch>,
    /// Where the pellets will be after this step.
    pub(crate) next: NextRows,
    /// What all chunks did in this step.
    pub(crate) tally: Tally,
    /// Whether no list names anything.
    pub(crate) is_free: bool,
    /// Steps taken in free flight so far.
    pub(crate) free_steps: u64,
    /// Where each wall is in this step.
    pub(crate) walls: Vec<WallNow>,
    /// Whether stages run in parallel.
    pub(crate) is_parallel: bool,
    /// Whether the step at work keeps its contacts for those who look, or the last one has.
    pub(crate) keeps_contacts: bool,
    /// Wall-clock time of each stage.
    pub(crate) profile: Profile,
}

/// The neighbor list of one chunk of pellets.
#[derive(Debug, Clone, Default)]
pub(crate) struct ChunkList {
    /// First partner of each pellet of the chunk, and the end of the last.
    pub(crate) offsets: Vec<u32>,
    /// Partners, rising for each pellet.
    pub(crate) partners: Vec<u32>,
    /// Walls near a pellet, by pellet; one that is touched at several places as many times in a row.
    pub(crate) near_walls: Vec<NearWall>,
    /// Triangles near a pellet, of every near wall that is a mesh, in the order of the walls.
    pub(crate) near_triangles: Vec<u32>,
    /// End of those of each such wall.
    pub(crate) near_triangle_ends: Vec<u32>,
}

/// What a chunk works with between two steps.
#[derive(Debug, Clone, Default)]
pub(crate) struct ChunkScratch {
    /// Pairs that touched in the last step, in the order of the list.
    pub(crate) touches: Vec<Touch>,
    /// Room for those of the next.
    pub(crate) spare_touches: Vec<Touch>,
    /// Room for a batch of pairs, and of contacts with walls.
    pub(crate) pairs: Option<Box<Batch>>,
    pub(crate) walls: Option<Box<Waiting>>,
    /// What acts on each pellet in this step, and one row more that takes what is not the chunk's own.
    pub(crate) loads: Vec<Load>,
    /// What the chunk did in this step.
    pub(crate) tally: Tally,
    /// Contacts that ended in this step.
    pub(crate) ended: Vec<Ended>,
    /// Contacts of the last step that kept them.
    pub(crate) kept: Vec<KeptContact>,
    /// Time of its stages.
    pub(crate) clock: ChunkClock,
}

/// Rows of the pellets one step on, to be exchanged for the present ones.
#[derive(Debug, Clone, Default)]
pub(crate) struct NextRows {
    pub(crate) position: Vec<Row>,
    pub(crate) velocity: Vec<Row>,
    pub(crate) spin: Vec<Row>,
}

/// Two pellets that touch.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Touch {
    /// Place of the first in its chunk.
    pub(crate) local: u32,
    /// Place of the pair in the chunk's list, which names the second.
    pub(crate) slot: u32,
}

/// A wall within reach of a pellet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NearWall {
    /// Place of the pellet in its chunk.
    pub(crate) pellet: u32,
    /// Index of the wall.
    pub(crate) wall: u32,
}

/// What acts on one pellet.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Load {
    /// Force of all contacts [N], and the greatest normal force of one [N].
    pub(crate) force: Row,
    /// Torque of all contacts [N·m].
    pub(crate) torque: Row,
}

impl Workspace {
    /// What acted on a pellet in the last step; nothing on one that has come since.
    pub(crate) fn load(&self, index: usize, pellets: usize) -> Load {
        let size = chunk::size(pellets);
        let chunk = self.chunks.get(index / size);
        let load = chunk.and_then(|chunk| chunk.loads.get(index % size));
        load.copied().unwrap_or_default()
    }
}

impl NextRows {
    /// Makes room for a number of pellets.
    pub(crate) fn resize(&mut self, pellets: usize) {
        for rows in [&mut self.position, &mut self.velocity, &mut self.spin] {
            rows.resize(pellets, Row::default());
        }
    }
}
