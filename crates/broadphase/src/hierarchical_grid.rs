//! Grids of several cell widths, each for the pellets of one octave of sizes: best where sizes are far apart.
//!
//! Pellets of one octave find each other as in a single grid.
//! Across octaves it is the coarser pellet that looks for the finer ones: they are many and their cells are small, so
//! that a box about the coarser one holds little else but its partners.

use crate::block::{Block, Reach, is_listed};
use crate::cells::{Cells, ROUNDING};
use crate::periodic::is_image_within_reach;
use crate::{PeriodicBox, SphereRow, is_within_reach};
use pelletflow_core::{Bounds, Vec3};
use std::ops::Range;

/// Octaves beyond which all pellets share the coarsest grid [-].
const MOST_LEVELS: usize = 24;

/// Pellets sorted into cells by size and place.
#[derive(Debug)]
pub struct HierarchicalGrid<'a> {
    rows: &'a [SphereRow],
    reach: Reach,
    /// Finest first.
    levels: Vec<Level>,
}

/// The pellets of one octave of sizes.
#[derive(Debug)]
struct Level {
    /// Rising.
    pellets: Vec<u32>,
    /// Largest radius among them [m].
    largest: f64,
    cells: Cells,
}

/// A pellet of a chunk, by its place in the chunk, and a pellet that it lists.
type Entry = (u32, u32);

impl<'a> HierarchicalGrid<'a> {
    /// Sorts the pellets into cells; two pellets are partners when their gap is less than `skin` [m].
    pub fn new(rows: &'a [SphereRow], skin: f64, periodic: Option<PeriodicBox>) -> Self {
        // A pellet reaches half the skin beyond its surface: nothing is gained by sorting what is smaller than that.
        let size = |row: &SphereRow| row[3] + skin / 2.0;
        let smallest = rows.iter().map(size).fold(f64::INFINITY, f64::min);
        let mut octaves = vec![Vec::new(); MOST_LEVELS];
        for (index, row) in rows.iter().enumerate() {
            let mut octave = 0;
            let mut end = 2.0 * smallest;
            while size(row) >= end && octave + 1 < MOST_LEVELS {
                octave += 1;
                end *= 2.0;
            }
            octaves[octave].push(index as u32);
        }
        let level = |pellets: Vec<u32>| {
            let radii = pellets.iter().map(|&pellet| rows[pellet as usize][3]);
            let largest = radii.fold(0.0, f64::max);
            let width = 2.0 * largest + skin;
            Level {
                largest,
                cells: Cells::new(rows, pellets.iter().copied(), width, periodic),
                pellets,
            }
        };
        Self {
            rows,
            reach: Reach { skin, periodic },
            levels: octaves
                .into_iter()
                .filter(|pellets| !pellets.is_empty())
                .map(level)
                .collect(),
        }
    }

    /// Appends what every pellet of a chunk lists, and its end to `offsets`.
    pub(crate) fn list(
        &self,
        chunk: &Range<usize>,
        offsets: &mut Vec<u32>,
        partners: &mut Vec<u32>,
    ) {
        let mut entries = Vec::new();
        for level in &self.levels {
            self.list_within(level, chunk, &mut entries);
        }
        let mut about_finer: Option<Bounds> = None;
        for (number, level) in self.levels.iter().enumerate() {
            let (finer, _) = self.levels.split_at(number);
            let pellets = level.of(chunk);
            for &pellet in pellets {
                self.list_finer(pellet as usize, finer, chunk, &mut entries);
            }
            if let Some(bounds) = &about_finer {
                self.list_from_outside(level, finer, bounds, chunk, &mut entries);
            }
            let bodies = pellets
                .iter()
                .map(|&pellet| body(&self.rows[pellet as usize]));
            about_finer = about_finer
                .into_iter()
                .chain(bodies)
                .reduce(|a, b| a.merged(&b));
        }
        sort(chunk.len(), &entries, offsets, partners);
    }

    /// Adds the pairs of one octave.
    fn list_within(&self, level: &Level, chunk: &Range<usize>, entries: &mut Vec<Entry>) {
        let mut block = Block::default();
        let mut gathered = None;
        let pellets = level.of(chunk).iter();
        let mut by_cell: Vec<_> = pellets
            .map(|&pellet| (level.cells.at(&self.rows[pellet as usize]), pellet))
            .collect();
        // Pellets of one cell are stored in a row where it is of the finest octave, but not in others.
        if level.largest > self.levels[0].largest {
            by_cell.sort_unstable();
        }
        for (at, pellet) in by_cell {
            let index = pellet as usize;
            if gathered != Some(at) {
                block.gather(&level.cells, at, index, chunk);
                gathered = Some(at);
            }
            let partners = block.list(index, &self.rows[index], chunk, &self.reach);
            let local = (index - chunk.start) as u32;
            entries.extend(partners.iter().map(|&partner| (local, partner)));
        }
    }

    /// Adds the pairs of a pellet of the chunk with finer ones, wherever the chunk lists them.
    fn list_finer(
        &self,
        index: usize,
        finer: &[Level],
        chunk: &Range<usize>,
        entries: &mut Vec<Entry>,
    ) {
        let local = |index: usize| (index - chunk.start) as u32;
        self.visit_finer(index, finer, None, |other| {
            if is_listed(other, index, chunk) {
                entries.push((local(index), other as u32));
            } else {
                entries.push((local(other), index as u32));
            }
        });
    }

    /// Adds the pairs of finer pellets of the chunk, which lie in `bounds`, with pellets of a level from other chunks.
    fn list_from_outside(
        &self,
        level: &Level,
        finer: &[Level],
        bounds: &Bounds,
        chunk: &Range<usize>,
        entries: &mut Vec<Entry>,
    ) {
        let near = bounds.grown(level.largest + self.reach.skin);
        level.cells.visit_box(&near, |slots| {
            let (members, rows) = level.cells.members(slots);
            for (&pellet, row) in members.iter().zip(rows) {
                let index = pellet as usize;
                if chunk.contains(&index) || !self.may_touch(row, bounds) {
                    continue;
                }
                self.visit_finer(index, finer, Some(bounds), |other| {
                    if chunk.contains(&other) {
                        entries.push(((other - chunk.start) as u32, pellet));
                    }
                });
            }
        });
    }

    /// False only where a pellet and its images are out of reach of all in a box.
    fn may_touch(&self, row: &SphereRow, bounds: &Bounds) -> bool {
        let center = (bounds.min + bounds.max) / 2.0;
        let half_sides = (bounds.max - bounds.min) / 2.0;
        let away = [0, 1, 2].map(|axis| row[axis] - center[axis]);
        let away = match &self.reach.periodic {
            None => away,
            Some(periodic) => periodic.nearest(away),
        };
        let reach = ROUNDING * (row[3] + self.reach.skin);
        (0..3).all(|axis| away[axis].abs() <= half_sides[axis] + reach)
    }

    /// The box about a pellet that may hold the centers of its partners up to a radius [m]; its part in `clip`, where no
    /// image lies elsewhere.
    fn about(&self, row: &SphereRow, largest: f64, clip: Option<&Bounds>) -> Bounds {
        let about = body(row).grown(largest + self.reach.skin);
        match (clip, self.reach.periodic) {
            (Some(clip), None) => about.common(clip),
            _ => about,
        }
    }

    /// Calls `visit` with every finer pellet within reach of one.
    fn visit_finer(
        &self,
        index: usize,
        finer: &[Level],
        clip: Option<&Bounds>,
        mut visit: impl FnMut(usize),
    ) {
        let row = &self.rows[index];
        let skin = self.reach.skin;
        for level in finer {
            let about = self.about(row, level.largest, clip);
            if (0..3).any(|axis| about.min[axis] > about.max[axis]) {
                continue;
            }
            level.cells.visit_box(&about, |slots| {
                let (members, rows) = level.cells.members(slots);
                for (&other, other_row) in members.iter().zip(rows) {
                    let is_partner = match &self.reach.periodic {
                        None => is_within_reach(row, other_row, skin),
                        Some(periodic) => is_image_within_reach(periodic, row, other_row, skin),
                    };
                    if is_partner {
                        visit(other as usize);
                    }
                }
            });
        }
    }
}

impl Level {
    /// Those of its pellets that are in a chunk.
    fn of(&self, chunk: &Range<usize>) -> &[u32] {
        let place = |end: usize| {
            self.pellets
                .partition_point(|&pellet| (pellet as usize) < end)
        };
        &self.pellets[place(chunk.start)..place(chunk.end)]
    }
}

/// A box about a pellet [m].
fn body(row: &SphereRow) -> Bounds {
    let center = Vec3::new(row[0], row[1], row[2]);
    Bounds {
        min: center.add_scalar(-row[3]),
        max: center.add_scalar(row[3]),
    }
}

/// Appends entries as lists: sorted by pellet of the chunk, and rising for each.
fn sort(count: usize, entries: &[Entry], offsets: &mut Vec<u32>, partners: &mut Vec<u32>) {
    let base = partners.len() as u32;
    let mut next = vec![0_u32; count + 1];
    for &(local, _) in entries {
        next[local as usize + 1] += 1;
    }
    next[0] = base;
    for local in 0..count {
        next[local + 1] += next[local];
    }
    partners.resize(partners.len() + entries.len(), 0);
    // Each start becomes the end of its list.
    for &(local, partner) in entries {
        let slot = &mut next[local as usize];
        partners[*slot as usize] = partner;
        *slot += 1;
    }
    let mut first = base as usize;
    for &end in &next[..count] {
        partners[first..end as usize].sort_unstable();
        first = end as usize;
        offsets.push(end);
    }
}
