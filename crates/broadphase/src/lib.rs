//! Who might touch: partners of each pellet, and the triangles of a wall that is a mesh.
//!
//! One contract, several ways to fill it. Pellets are stored in chunks; a pair inside a chunk is listed once,
//! at its lower index, and a pair across chunks at both ends, so that each chunk can be advanced on its own.
//! Every way lists the same partners in the same order: [`all_pairs`] is the oracle of the others.
//! Along periodic axes the nearest image of a pellet counts; the box is longer than twice the reach of two pellets,
//! so that no two images of a pellet are partners of one.

pub mod all_pairs;
pub mod baked;
mod block;
mod cells;
pub mod grid;
pub mod hierarchical_grid;
pub mod mesh;
pub mod morton;
pub mod periodic;
pub mod tree;

pub use baked::{BakeError, BakedMesh, Deviation};
pub use grid::Grid;
pub use hierarchical_grid::HierarchicalGrid;
pub use mesh::MeshTree;
pub use periodic::PeriodicBox;
pub use tree::Tree;

use std::ops::Range;

/// A pellet as a row of `x, y, z, radius` [m].
pub type SphereRow = [f64; 4];

/// A way to find partners.
#[derive(Debug)]
pub enum Search<'a> {
    /// A grid of cells.
    Grid(Grid<'a>),
    /// A grid of cells for each octave of sizes.
    HierarchicalGrid(HierarchicalGrid<'a>),
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
    /// Appends the partners that each pellet of a chunk lists, rising for each, and their end to `offsets`.
    pub fn list(&self, chunk: &Range<usize>, offsets: &mut Vec<u32>, partners: &mut Vec<u32>) {
        match self {
            Self::Grid(grid) => grid.list(chunk, offsets, partners),
            Self::HierarchicalGrid(grid) => grid.list(chunk, offsets, partners),
            Self::Tree(tree) => list_each(chunk, offsets, partners, |index, mut visit| {
                tree.for_each_within_reach(index, &mut visit);
            }),
            Self::AllPairs {
                rows,
                skin,
                periodic,
            } => list_each(chunk, offsets, partners, |index, mut visit| {
                let periodic = periodic.as_ref();
                all_pairs::for_each_within_reach(rows, *skin, periodic, index, &mut visit);
            }),
        }
    }
}

/// Lists the partners of one pellet after the other; `visit_partners` calls back with all within reach of one.
fn list_each(
    chunk: &Range<usize>,
    offsets: &mut Vec<u32>,
    partners: &mut Vec<u32>,
    visit_partners: impl Fn(usize, &mut dyn FnMut(usize)),
) {
    for index in chunk.clone() {
        let first = partners.len();
        visit_partners(index, &mut |other| {
            if block::is_listed(other, index, chunk) {
                partners.push(other as u32);
            }
        });
        partners[first..].sort_unstable();
        offsets.push(partners.len() as u32);
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
