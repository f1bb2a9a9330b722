//! A grid of cells as wide as the largest pellet's reach: best where sizes are near equal.

use crate::{SphereRow, is_within_reach};

/// Cells per pellet beyond which the cells are widened: a stray pellet far away must not cost memory [-].
const CELLS_PER_PELLET: f64 = 8.0;

/// Pellets sorted into cells; a partner is in the same cell or beside it.
#[derive(Debug)]
pub struct Grid {
    skin: f64,
    origin: [f64; 3],
    cells_per_meter: f64,
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
    pub fn new(rows: &[SphereRow], skin: f64) -> Self {
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
        let mut width = 2.0 * largest_radius + skin;
        let counts = loop {
            let counts =
                [0, 1, 2].map(|axis| ((high[axis] - low[axis]).max(0.0) / width).floor() + 1.0);
            let total: f64 = counts.iter().product();
            // With no pellet the bounds are inverted and one cell is left.
            if total <= CELLS_PER_PELLET * rows.len() as f64 + 64.0 {
                break counts.map(|count| count as usize);
            }
            width *= 1.3;
        };
        let mut grid = Self {
            skin,
            origin: low,
            cells_per_meter: 1.0 / width,
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
            let cell = ((row[axis] - self.origin[axis]) * self.cells_per_meter) as usize;
            cell.min(self.counts[axis] - 1)
        })
    }

    fn cell(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// Calls `visit` with every other pellet within reach of `index`.
    ///
    /// # Panics
    /// Only if `index` is not a row that the grid was made of.
    pub fn for_each_within_reach(&self, index: usize, visit: &mut impl FnMut(usize)) {
        let cell = self.cell_of[index] as usize;
        let x = cell % self.counts[0];
        let y = cell / self.counts[0] % self.counts[1];
        let z = cell / (self.counts[0] * self.counts[1]);
        let beside = |at: usize, count: usize| at.saturating_sub(1)..=(at + 1).min(count - 1);
        let own_slot = self.starts[cell] as usize
            + self.members[self.starts[cell] as usize..self.starts[cell + 1] as usize]
                .iter()
                .position(|&member| member as usize == index)
                .expect("a pellet is a member of its own cell");
        let row = self.member_rows[own_slot];
        for z in beside(z, self.counts[2]) {
            for y in beside(y, self.counts[1]) {
                // Cells along x are neighbors in memory: three of them are one range.
                let columns = beside(x, self.counts[0]);
                let first = self.starts[self.cell([*columns.start(), y, z])] as usize;
                let end = self.starts[self.cell([*columns.end(), y, z]) + 1] as usize;
                for slot in first..end {
                    if slot != own_slot && is_within_reach(&row, &self.member_rows[slot], self.skin)
                    {
                        visit(self.members[slot] as usize);
                    }
                }
            }
        }
    }
}
