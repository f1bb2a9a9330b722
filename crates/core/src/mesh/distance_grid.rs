//! Distances on a grid, kept only near a surface.
//!
//! Cells are kept in blocks; between the corners of a cell the distance is trilinear, so that a plane is exact.

use super::TriangleMesh;
use crate::{Bounds, Vec3};

/// Cells along the side of a block [-].
const CELLS: usize = 8;
/// Corners of cells along the side of a block [-].
const ROW: usize = CELLS + 1;
/// Corners of cells of a block [-].
const SAMPLES: usize = ROW * ROW * ROW;
/// No block is kept there.
const NONE: u32 = u32::MAX;

/// Most memory of one grid [B].
pub const MOST_MEMORY: f64 = 2.0e9;

/// A grid that would not fit into memory.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("needs {:.1} GB in cells of {spacing} m; expected at most {:.1} GB", bytes / 1.0e9, MOST_MEMORY / 1.0e9)]
pub struct GridTooFine {
    /// Length of a cell [m].
    pub spacing: f64,
    /// Memory needed [B].
    pub bytes: f64,
}

/// Where the blocks of a grid are that come near a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct GridLayout {
    spacing: f64,
    origin: Vec3,
    blocks: [usize; 3],
    /// Place of each block among those kept.
    places: Vec<u32>,
    /// Numbers of the blocks kept, rising.
    kept: Vec<usize>,
}

impl GridLayout {
    /// Cells of a length [m], kept where the mesh is nearer than `band` [m].
    ///
    /// # Errors
    /// The grid would take more than [`MOST_MEMORY`].
    pub fn new(mesh: &TriangleMesh, spacing: f64, band: f64) -> Result<Self, GridTooFine> {
        let side = CELLS as f64 * spacing;
        let bounds = mesh.bounds().grown(band + spacing);
        let counts = ((bounds.max - bounds.min) / side).map(f64::ceil);
        let index_bytes = counts.product() * size_of::<u32>() as f64;
        let fits = |bytes: f64| {
            if bytes <= MOST_MEMORY {
                Ok(())
            } else {
                Err(GridTooFine { spacing, bytes })
            }
        };
        fits(index_bytes)?;
        let blocks = <[f64; 3]>::from(counts).map(|count| count as usize);
        let mut layout = Self {
            spacing,
            origin: bounds.min,
            blocks,
            places: vec![NONE; blocks.iter().product()],
            kept: Vec::new(),
        };
        let reach = band + layout.half_diagonal();
        for triangle in mesh.triangles() {
            let about = triangle
                .corners
                .iter()
                .fold(Bounds::nothing(), |about, &at| {
                    about.merged(&Bounds { min: at, max: at })
                })
                .grown(band);
            let [low, high] = [about.min, about.max].map(|at| {
                <[f64; 3]>::from((at - layout.origin) / side).map(|place| place.max(0.0) as usize)
            });
            let last = |axis: usize| high[axis].min(blocks[axis] - 1);
            for z in low[2]..=last(2) {
                for y in low[1]..=last(1) {
                    for x in low[0]..=last(0) {
                        let number = x + blocks[0] * (y + blocks[1] * z);
                        if layout.places[number] == NONE
                            && triangle.distance(layout.center(number)) < reach
                        {
                            layout.places[number] = 0;
                        }
                    }
                }
            }
        }
        layout.kept = (0..layout.places.len())
            .filter(|&number| layout.places[number] != NONE)
            .collect();
        for (place, &number) in layout.kept.iter().enumerate() {
            layout.places[number] = place as u32;
        }
        fits(layout.bytes())?;
        Ok(layout)
    }

    /// Length of a cell [m].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Memory of the grid [B].
    pub fn bytes(&self) -> f64 {
        let samples = self.kept.len() * SAMPLES * size_of::<f64>();
        (samples + size_of_val(&self.places[..])) as f64
    }

    /// Half of the diagonal of a block [m].
    pub fn half_diagonal(&self) -> f64 {
        0.5 * CELLS as f64 * self.spacing * 3.0_f64.sqrt()
    }

    /// Middle of a block by its number [m].
    fn center(&self, number: usize) -> Vec3 {
        self.corner(number)
            .add_scalar(0.5 * CELLS as f64 * self.spacing)
    }

    /// Lowest corner of a block by its number [m].
    fn corner(&self, number: usize) -> Vec3 {
        let [x, y, z] = [
            number % self.blocks[0],
            number / self.blocks[0] % self.blocks[1],
            number / self.blocks[0] / self.blocks[1],
        ]
        .map(|place| (place * CELLS) as f64);
        self.origin + self.spacing * Vec3::new(x, y, z)
    }
}

/// Signed distances on the corners of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct DistanceGrid {
    layout: GridLayout,
    samples: Vec<f64>,
}

impl DistanceGrid {
    /// Takes samples block by block: `sample` is given the middle of a block [m] and its points [m], and adds a distance [m]
    /// for each.
    pub fn new(layout: GridLayout, mut sample: impl FnMut(Vec3, &[Vec3], &mut Vec<f64>)) -> Self {
        let mut samples = Vec::with_capacity(layout.kept.len() * SAMPLES);
        let mut points = Vec::with_capacity(SAMPLES);
        for &number in &layout.kept {
            let corner = layout.corner(number);
            points.clear();
            points.extend((0..SAMPLES).map(|index| {
                let [x, y, z] =
                    [index % ROW, index / ROW % ROW, index / ROW / ROW].map(|step| step as f64);
                corner + layout.spacing * Vec3::new(x, y, z)
            }));
            sample(layout.center(number), &points, &mut samples);
        }
        Self { layout, samples }
    }

    /// Where the cells are.
    pub fn layout(&self) -> &GridLayout {
        &self.layout
    }

    /// Distance at a point [m] with its gradient [-]; none where no cell is kept.
    #[inline]
    pub fn at(&self, point: Vec3) -> Option<(f64, Vec3)> {
        let layout = &self.layout;
        let cells = (point - layout.origin) / layout.spacing;
        let is_within =
            |axis: usize| cells[axis] >= 0.0 && cells[axis] < (layout.blocks[axis] * CELLS) as f64;
        if !(is_within(0) && is_within(1) && is_within(2)) {
            return None;
        }
        let [i, j, k] = [0, 1, 2].map(|axis| cells[axis] as usize);
        let number = i / CELLS + layout.blocks[0] * (j / CELLS + layout.blocks[1] * (k / CELLS));
        let place = layout.places[number];
        if place == NONE {
            return None;
        }
        let first = place as usize * SAMPLES + i % CELLS + ROW * (j % CELLS + ROW * (k % CELLS));
        let (x, y, z) = (cells.x - i as f64, cells.y - j as f64, cells.z - k as f64);
        let pair = |step: usize| [self.samples[first + step], self.samples[first + step + 1]];
        let mix = |share: f64, [low, high]: [f64; 2]| low + share * (high - low);
        let rows = [pair(0), pair(ROW), pair(ROW * ROW), pair(ROW * ROW + ROW)];
        let along_x = rows.map(|row| mix(x, row));
        let slope_x = rows.map(|[low, high]| high - low);
        let low = mix(y, [along_x[0], along_x[1]]);
        let high = mix(y, [along_x[2], along_x[3]]);
        let slope = Vec3::new(
            mix(
                z,
                [
                    mix(y, [slope_x[0], slope_x[1]]),
                    mix(y, [slope_x[2], slope_x[3]]),
                ],
            ),
            mix(z, [along_x[1] - along_x[0], along_x[3] - along_x[2]]),
            high - low,
        );
        Some((mix(z, [low, high]), slope / layout.spacing))
    }

    /// A point of the grid [m] where the distance changes by more than the way to a neighbor, as no distance does.
    pub fn tear(&self) -> Option<Vec3> {
        let spacing = self.layout.spacing;
        // Rounding of a difference of two distances.
        let most = spacing * (1.0 + 1.0e-6);
        self.layout
            .kept
            .iter()
            .enumerate()
            .find_map(|(place, &number)| {
                let samples = &self.samples[place * SAMPLES..][..SAMPLES];
                (0..SAMPLES).find_map(|index| {
                    let steps = [index % ROW, index / ROW % ROW, index / ROW / ROW];
                    let is_torn = (0..3).any(|axis| {
                        let next = index + ROW.pow(axis as u32);
                        steps[axis] < CELLS && (samples[next] - samples[index]).abs() > most
                    });
                    let [x, y, z] = steps.map(|step| step as f64);
                    is_torn.then(|| self.layout.corner(number) + spacing * Vec3::new(x, y, z))
                })
            })
    }
}
