//! Pellets sorted into cells: what the grids are made of.

use crate::{PeriodicBox, SphereRow};
use pelletflow_core::Bounds;
use std::ops::Range;

/// Cells per pellet beyond which the cells are widened: a stray pellet far away must not cost memory [-].
const CELLS_PER_PELLET: f64 = 8.0;

/// Widening by which the rounding of a distance cannot hide a partner two cells away [-].
pub(crate) const ROUNDING: f64 = 1.0 + 1.0e-9;

/// Pellets sorted into cells; of the pellets in a cell, the indices rise.
#[derive(Debug)]
pub(crate) struct Cells {
    periodic: Option<PeriodicBox>,
    origin: [f64; 3],
    per_meter: [f64; 3],
    counts: [i64; 3],
    /// First entry of each cell in the two arrays below, and the end of the last.
    starts: Vec<u32>,
    members: Vec<u32>,
    /// Rows in the order of `members`, so that a cell is read in one go.
    member_rows: Vec<SphereRow>,
}

/// Cells beside each other along one axis; the second range is what lies across a periodic border.
type Span = [Range<i64>; 2];

impl Cells {
    /// Sorts the pellets with these rising indices into cells at least as wide as `width` [m].
    pub(crate) fn new(
        rows: &[SphereRow],
        indices: impl ExactSizeIterator<Item = u32> + Clone,
        width: f64,
        periodic: Option<PeriodicBox>,
    ) -> Self {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for index in indices.clone() {
            for axis in 0..3 {
                low[axis] = low[axis].min(rows[index as usize][axis]);
                high[axis] = high[axis].max(rows[index as usize][axis]);
            }
        }
        let most_cells = CELLS_PER_PELLET * indices.len() as f64 + 64.0;
        // Points without reach would ask for cells without width.
        let mut width = (width * ROUNDING).max(f64::MIN_POSITIVE.sqrt());
        let axes = loop {
            let axes = [0, 1, 2].map(|axis| match periodic {
                Some(periodic) if periodic.is_periodic(axis) => {
                    // The first cell follows the last, so the cells fill the box.
                    let count = (periodic.length(axis) / width).floor().max(1.0);
                    (periodic.low(axis), count / periodic.length(axis), count)
                }
                // With no pellet the bounds are inverted and one cell is left.
                _ if low[axis] > high[axis] => (0.0, 1.0 / width, 1.0),
                // The cells lie as those of Morton's curve do, so that a cell is a run of stored pellets.
                _ => {
                    let origin = (low[axis] / width).floor() * width;
                    let count = ((high[axis] - origin) / width).floor() + 1.0;
                    (origin, 1.0 / width, count)
                }
            });
            if axes.iter().map(|(_, _, count)| count).product::<f64>() <= most_cells {
                break axes;
            }
            width *= 1.3;
        };
        let mut cells = Self {
            periodic,
            origin: axes.map(|(origin, _, _)| origin),
            per_meter: axes.map(|(_, per_meter, _)| per_meter),
            counts: axes.map(|(_, _, count)| count as i64),
            starts: Vec::new(),
            members: vec![0; indices.len()],
            member_rows: vec![[0.0; 4]; indices.len()],
        };
        cells.sort(rows, indices);
        cells
    }

    fn sort(&mut self, rows: &[SphereRow], indices: impl Iterator<Item = u32> + Clone) {
        let mut starts = vec![0_u32; self.counts.iter().product::<i64>() as usize + 1];
        let cell_of: Vec<u32> = indices
            .clone()
            .map(|index| self.cell(self.at(&rows[index as usize])) as u32)
            .collect();
        for &cell in &cell_of {
            starts[cell as usize + 1] += 1;
        }
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        // Each start becomes the end of its cell, which is the start of the next.
        for (index, cell) in indices.zip(cell_of) {
            let slot = &mut starts[cell as usize];
            self.members[*slot as usize] = index;
            self.member_rows[*slot as usize] = rows[index as usize];
            *slot += 1;
        }
        starts.rotate_right(1);
        starts[0] = 0;
        self.starts = starts;
    }

    /// The cell of a pellet, along the axes.
    #[inline]
    pub(crate) fn at(&self, row: &SphereRow) -> [i64; 3] {
        [0, 1, 2].map(|axis| {
            let cell = ((row[axis] - self.origin[axis]) * self.per_meter[axis]) as i64;
            cell.clamp(0, self.counts[axis] - 1)
        })
    }

    fn cell(&self, [x, y, z]: [i64; 3]) -> usize {
        ((z * self.counts[1] + y) * self.counts[0] + x) as usize
    }

    /// A pellet and its row, by slot.
    #[inline]
    pub(crate) fn member(&self, slot: usize) -> (u32, &SphereRow) {
        (self.members[slot], &self.member_rows[slot])
    }

    /// Pellets and their rows, by slot.
    pub(crate) fn members(&self, slots: Range<usize>) -> (&[u32], &[SphereRow]) {
        (&self.members[slots.clone()], &self.member_rows[slots])
    }

    /// Calls `visit` with the slots of a cell and of those beside it, in runs.
    #[inline]
    pub(crate) fn visit_beside(&self, at: [i64; 3], visit: impl FnMut(Range<usize>)) {
        let spans = [0, 1, 2].map(|axis| self.span(axis, at[axis] - 1, at[axis] + 1));
        self.visit(&spans, visit);
    }

    /// Calls `visit` with the slots of all cells that hold points of a box [m], in runs.
    #[inline]
    pub(crate) fn visit_box(&self, bounds: &Bounds, visit: impl FnMut(Range<usize>)) {
        let spans = [0, 1, 2].map(|axis| {
            let margin = (ROUNDING - 1.0) * (bounds.max[axis] - bounds.min[axis]);
            let cell =
                |coordinate: f64| floor((coordinate - self.origin[axis]) * self.per_meter[axis]);
            let (low, high) = (bounds.min[axis] - margin, bounds.max[axis] + margin);
            self.span(axis, cell(low), cell(high))
        });
        self.visit(&spans, visit);
    }

    /// Cells from one to another along an axis, both of them among these.
    #[inline]
    fn span(&self, axis: usize, first: i64, last: i64) -> Span {
        let count = self.counts[axis];
        let range = |first: i64, end: i64| {
            let first = first.clamp(0, count);
            first..end.clamp(first, count)
        };
        let is_periodic = self
            .periodic
            .is_some_and(|periodic| periodic.is_periodic(axis));
        let is_whole = last.saturating_sub(first) + 1 >= count;
        match (is_periodic, is_whole) {
            (false, _) => [range(first, last.saturating_add(1)), 0..0],
            (true, true) => [range(0, count), 0..0],
            (true, false) => {
                let start = first.rem_euclid(count);
                let end = start + (last - first) + 1;
                [range(start, end), range(0, end - count)]
            }
        }
    }

    #[inline]
    fn visit(&self, [x, y, z]: &[Span; 3], mut visit: impl FnMut(Range<usize>)) {
        for z in z.iter().cloned() {
            for z in z {
                for y in y.iter().cloned() {
                    for y in y {
                        // Cells along x are neighbors in memory: several of them are one run.
                        for x in x.iter().filter(|x| !x.is_empty()) {
                            let first = self.starts[self.cell([x.start, y, z])] as usize;
                            let end = self.starts[self.cell([x.end, y, z])] as usize;
                            visit(first..end);
                        }
                    }
                }
            }
        }
    }
}

/// The whole number below; `f64::floor` is a call on old processors.
#[inline]
fn floor(value: f64) -> i64 {
    let whole = value as i64;
    whole - i64::from(value < whole as f64)
}
