//! Scratch: deleting it changes no answer.

use crate::profile::Profile;
use crate::state::Row;
use crate::wall::WallNow;

/// Lists, loads and clocks.
#[derive(Debug, Default)]
pub struct Workspace {
    /// Who might touch whom, chunk by chunk.
    pub(crate) lists: Vec<ChunkList>,
    /// Pairs that touch in this step, chunk by chunk.
    pub(crate) touches: Vec<Vec<Touch>>,
    /// What acts on each pellet in this step.
    pub(crate) loads: Vec<Load>,
    /// Where each wall is in this step.
    pub(crate) walls: Vec<WallNow>,
    /// Whether stages run in parallel.
    pub(crate) is_parallel: bool,
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

/// Two pellets that touch.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Touch {
    /// Place of the first in its chunk.
    pub(crate) local: u32,
    /// Index of the second.
    pub(crate) partner: u32,
    /// Place of the pair in the chunk's list.
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
