//! Who might touch: partners of each pellet, the walls near it, and the triangles of a wall that is a mesh.
//!
//! One contract, several ways to fill it. Pellets are stored in chunks; a pair inside a chunk is listed once,
//! at its lower index, and a pair across chunks at both ends, so that each chunk can be advanced on its own.
//! Every way lists the same partners in the same order: [`all_pairs`] is the oracle of the others.
//! Along periodic axes the nearest image of a pellet counts; the box is longer than twice the reach of two pellets,
//! so that no two images of a pellet are partners of one.

pub mod all_pairs;
pub mod baked;
pub mod grid;
pub mod mesh;
pub mod morton;
pub mod periodic;
pub mod tree;
pub mod walls;

pub use baked::{BakeError, BakedMesh, Deviation};
pub use grid::Grid;
pub use mesh::MeshTree;
pub use periodic::PeriodicBox;
pub use tree::Tree;
pub use walls::WallTree;

use std::ops::Range;

/// A pellet as a row of `x, y, z, radius` [m].
pub type SphereRow = [f64; 4];

/// A way to find partners.
#[derive(Debug)]
pub enum Search<'a> {
    /// A grid of cells.
    Grid(Grid),
    /// A tree of boxes.
    Tree(Tree<'a>),
    /// Every pair.
    AllPairs {
        /// The pellets.
        rows: &'a [SphereRow],
        /// Gap below which two pellets are partners [m].
        skin: f64,
        /// The box, where it is periodic.
        periodic: Option<PeriodicBox>,
    },
}

impl Search<'_> {
    /// Appends the partners that pellet `index` lists, rising; `chunk` is the range of pellets stored with it.
    pub fn partners_into(&self, index: usize, chunk: &Range<usize>, partners: &mut Vec<u32>) {
        let first = partners.len();
        let mut keep = |other: usize| {
            if other > index || (other < index && !chunk.contains(&other)) {
                partners.push(other as u32);
            }
        };
        match self {
            Self::Grid(grid) => grid.for_each_within_reach(index, &mut keep),
            Self::Tree(tree) => tree.for_each_within_reach(index, &mut keep),
            Self::AllPairs {
                rows,
                skin,
                periodic,
            } => {
                all_pairs::for_each_within_reach(rows, *skin, periodic.as_ref(), index, &mut keep);
            }
        }
        partners[first..].sort_unstable();
    }
}

/// Whether the gap between two pellets is less than the skin [m].
#[inline]
pub fn is_within_reach(a: &SphereRow, b: &SphereRow, skin: f64) -> bool {
    let (dx, dy, dz) = (a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    let reach = a[3] + b[3] + skin;
    dx * dx + dy * dy + dz * dz < reach * reach
}

#[cfg(test)]
mod contract;
