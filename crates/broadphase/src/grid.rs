//! A grid of cells as wide as the largest pellet's reach: best where sizes are near equal.

use crate::block::{Block, Reach, append_rising};
use crate::cells::Cells;
use crate::periodic::is_image_within_reach;
use crate::{PeriodicBox, SphereRow, is_within_reach};
use std::ops::Range;

/// Pellets sorted into cells; a partner is in the same cell or beside it.
#[derive(Debug)]
pub struct Grid<'a> {
    rows: &'a [SphereRow],
    reach: Reach,
    cells: Cells,
}

impl<'a> Grid<'a> {
    /// Sorts the pellets into cells; two pellets are partners when their gap is less than `skin` [m].
    pub fn new(rows: &'a [SphereRow], skin: f64, periodic: Option<PeriodicBox>) -> Self {
        let largest_radius = rows.iter().map(|row| row[3]).fold(0.0, f64::max);
        let width = 2.0 * largest_radius + skin;
        Self {
            rows,
            reach: Reach { skin, periodic },
            cells: Cells::new(rows, 0..rows.len() as u32, width, periodic),
        }
    }

    /// Calls `visit` with every other pellet within reach of `index`.
    pub fn for_each_within_reach(&self, index: usize, visit: &mut impl FnMut(usize)) {
        let row = &self.rows[index];
        self.cells.visit_beside(self.cells.at(row), |slots| {
            let (members, rows) = self.cells.members(slots);
            for (&other, other_row) in members.iter().zip(rows) {
                let is_partner = match &self.reach.periodic {
                    None => is_within_reach(row, other_row, self.reach.skin),
                    Some(periodic) => {
                        is_image_within_reach(periodic, row, other_row, self.reach.skin)
                    }
                };
                if is_partner && other as usize != index {
                    visit(other as usize);
                }
            }
        });
    }

    /// Appends what every pellet of a chunk lists, and its end to `offsets`.
    pub(crate) fn list(
        &self,
        chunk: &Range<usize>,
        offsets: &mut Vec<u32>,
        partners: &mut Vec<u32>,
    ) {
        let mut block = Block::default();
        let mut gathered = None;
        for index in chunk.clone() {
            let row = &self.rows[index];
            let at = self.cells.at(row);
            // Pellets of one cell are mostly stored in a row.
            if gathered != Some(at) {
                block.gather(&self.cells, at, index, chunk);
                gathered = Some(at);
            }
            append_rising(block.list(index, row, chunk, &self.reach), partners);
            offsets.push(partners.len() as u32);
        }
    }
}
