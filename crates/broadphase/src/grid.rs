//! A grid of cells as wide as the largest pellet's reach: best where sizes are near equal.

use crate::periodic::is_image_within_reach;
use crate::{PeriodicBox, SphereRow, is_within_reach};
use std::ops::Range;

/// Cells per pellet beyond which the cells are widened: a stray pellet far away must not cost memory [-].
const CELLS_PER_PELLET: f64 = 8.0;

/// Pellets sorted into cells; a partner is in the same cell or beside it.
#[derive(Debug)]
pub struct Grid {
    skin: f64,
    periodic: Option<PeriodicBox>,
    origin: [f64; 3],
    cells_per_meter: [f64; 3],
    counts: [usize; 3],
    /// First entry of each cell in the two arrays below, and the end of the last.
    starts: Vec<u32>,
    members: Vec<u32>,
    /// Rows in the order of `members`, so that a cell is read in one go.
    member_rows: Vec<SphereRow>,
    cell_of: Vec<u32>,
}

impl Grid {
    /// Sorts the pellets into cells; two pellets are partners when their gap is less than `skin` [m].
    pub fn new(rows: &[SphereRow], skin: f64, periodic: Option<PeriodicBox>) -> Self {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        let mut largest_radius: f64 = 0.0;
        for row in rows {
            for axis in 0..3 {
                low[axis] = low[axis].min(row[axis]);
                high[axis] = high[axis].max(row[axis]);
            }
            largest_radius = largest_radius.max(row[3]);
        }
        let repeats = |axis: usize| periodic.is_some_and(|periodic| periodic.is_periodic(axis));
        if let Some(periodic) = &periodic {
            for axis in (0..3).filter(|&axis| repeats(axis)) {
                // The first cell follows the last, so the cells fill the box.
                low[axis] = periodic.low(axis);
                high[axis] = low[axis] + periodic.length(axis);
            }
        }
        // Points without reach would ask for cells without width.
        let mut width = (2.0 * largest_radius + skin).max(f64::MIN_POSITIVE.sqrt());
        let counts = loop {
            let counts = [0, 1, 2].map(|axis| {
                let whole = ((high[axis] - low[axis]).max(0.0) / width).floor();
                if repeats(axis) {
                    whole.max(1.0)
                } else {
                    whole + 1.0
                }
            });
            let total: f64 = counts.iter().product();
            // With no pellet the bounds are inverted and one cell is left.
            if total <= CELLS_PER_PELLET * rows.len() as f64 + 64.0 {
                break counts.map(|count| count as usize);
            }
            width *= 1.3;
        };
        let mut grid = Self {
            skin,
            periodic,
            origin: low,
            cells_per_meter: [0, 1, 2].map(|axis| {
                if repeats(axis) {
                    counts[axis] as f64 / (high[axis] - low[axis])
                } else {
                    1.0 / width
                }
            }),
            counts,
            starts: Vec::new(),
            members: vec![0; rows.len()],
            member_rows: vec![[0.0; 4]; rows.len()],
            cell_of: Vec::with_capacity(rows.len()),
        };
        grid.sort(rows);
        grid
    }

    fn sort(&mut self, rows: &[SphereRow]) {
        let mut starts = vec![0_u32; self.counts.iter().product::<usize>() + 1];
        for row in rows {
            let cell = self.cell(self.coordinates(row)) as u32;
            self.cell_of.push(cell);
            starts[cell as usize + 1] += 1;
        }
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut next = starts.clone();
        for (index, row) in rows.iter().enumerate() {
            let slot = &mut next[self.cell_of[index] as usize];
            self.members[*slot as usize] = index as u32;
            self.member_rows[*slot as usize] = *row;
            *slot += 1;
        }
        self.starts = starts;
    }

    fn coordinates(&self, row: &SphereRow) -> [usize; 3] {
        [0, 1, 2].map(|axis| {
            let cell = ((row[axis] - self.origin[axis]) * self.cells_per_meter[axis]) as usize;
            cell.min(self.counts[axis] - 1)
        })
    }

    fn cell(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// Cells beside one along an axis, itself among them; the second range is what lies across a periodic border.
    fn beside(&self, at: usize, axis: usize) -> [Range<usize>; 2] {
        let count = self.counts[axis];
        let repeats = self
            .periodic
            .is_some_and(|periodic| periodic.is_periodic(axis));
        let inside = at.saturating_sub(1)..(at + 2).min(count);
        if !repeats || inside.len() == count {
            [inside, 0..0]
        } else if at == 0 {
            [inside, count - 1..count]
        } else if at + 1 == count {
            [inside, 0..1]
        } else {
            [inside, 0..0]
        }
    }

    /// Calls `visit` with every other pellet within reach of `index`.
    ///
    /// # Panics
    /// Only if `index` is not a row that the grid was made of.
    pub fn for_each_within_reach(&self, index: usize, visit: &mut impl FnMut(usize)) {
        match &self.periodic {
            None => self.visit(index, visit, |a, b| is_within_reach(a, b, self.skin)),
            Some(periodic) => {
                self.visit(index, visit, |a, b| {
                    is_image_within_reach(periodic, a, b, self.skin)
                });
            }
        }
    }

    fn visit(
        &self,
        index: usize,
        visit: &mut impl FnMut(usize),
        is_partner: impl Fn(&SphereRow, &SphereRow) -> bool,
    ) {
        let cell = self.cell_of[index] as usize;
        let x = cell % self.counts[0];
        let y = cell / self.counts[0] % self.counts[1];
        let z = cell / (self.counts[0] * self.counts[1]);
        let own_slot = self.starts[cell] as usize
            + self.members[self.starts[cell] as usize..self.starts[cell + 1] as usize]
                .iter()
                .position(|&member| member as usize == index)
                .expect("a pellet is a member of its own cell");
        let row = self.member_rows[own_slot];
        let columns = self.beside(x, 0);
        for z in self.beside(z, 2).into_iter().flatten() {
            for y in self.beside(y, 1).into_iter().flatten() {
                // Cells along x are neighbors in memory: three of them are one range.
                for columns in columns.iter().filter(|columns| !columns.is_empty()) {
                    let first = self.starts[self.cell([columns.start, y, z])] as usize;
                    let end = self.starts[self.cell([columns.end - 1, y, z]) + 1] as usize;
                    for slot in first..end {
                        if slot != own_slot && is_partner(&row, &self.member_rows[slot]) {
                            visit(self.members[slot] as usize);
                        }
                    }
                }
            }
        }
    }
}
