//! One whole neighbor search, lists of all chunks included: time per pellet by way of searching, number and size ratio.
//!
//! The pellets lie at random and not packed; each octave of sizes takes up as much volume as any other.
//! `cargo bench --bench neighbor_search` prints pellets per second; equal sizes are spread by a tenth about their mean.

use criterion::{
    BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main,
    measurement::WallTime,
};
use pelletflow::broadphase::{Grid, HierarchicalGrid, Search, SphereRow, Tree, morton};
use std::hint::black_box;

/// Smallest radius [m].
const SMALLEST: f64 = 0.0075;
/// Gap up to which pellets are partners [m].
const SKIN: f64 = 0.2 * SMALLEST;
/// Share of space that pellets take up [-].
const VOLUME_FRACTION: f64 = 0.6;
/// Pellets of a chunk [-].
const CHUNK: usize = 2048;
/// Beyond this ratio one grid takes minutes [-].
const WIDEST_FOR_ONE_GRID: f64 = 5.0;

/// Numbers from 0 to 1 by Marsaglia's xorshift (2003): the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Pellets in storage order, their radii from the smallest to `size_ratio` times it.
fn pellets(count: usize, size_ratio: f64) -> Vec<SphereRow> {
    let mut random = Random(88_172_645_463_325_252);
    // Number density ∝ r⁻⁴, whose integral over an octave is ∝ r⁻³.
    let finest = size_ratio.powi(-3);
    let radii: Vec<f64> = (0..count)
        .map(|_| SMALLEST * (1.0 - random.next() * (1.0 - finest)).powf(-1.0 / 3.0))
        .collect();
    let cubes: f64 = radii.iter().map(|radius| radius.powi(3)).sum();
    let side = (4.0 / 3.0 * std::f64::consts::PI * cubes / VOLUME_FRACTION).cbrt();
    let mut at = || side * random.next();
    let rows: Vec<SphereRow> = radii
        .into_iter()
        .map(|radius| [at(), at(), at(), radius])
        .collect();
    let width = 2.0 * SMALLEST * size_ratio.min(2.0) + SKIN;
    let keys: Vec<u64> = rows.iter().map(|row| morton::key(row, width)).collect();
    let order = morton::order(&keys);
    order
        .into_iter()
        .map(|index| rows[index as usize])
        .collect()
}

/// Lists of all chunks; gives how many partners they name.
fn list(search: &Search, count: usize) -> usize {
    let (mut offsets, mut partners) = (Vec::new(), Vec::new());
    for first in (0..count).step_by(CHUNK) {
        let chunk = first..(first + CHUNK).min(count);
        search.list(&chunk, &mut offsets, &mut partners);
    }
    partners.len()
}

fn way<'a>(
    group: &mut BenchmarkGroup<WallTime>,
    name: &str,
    (rows, case): (&'a [SphereRow], &str),
    search: impl Fn(&'a [SphereRow]) -> Search<'a>,
) {
    group.bench_function(BenchmarkId::new(name, case), |bencher| {
        bencher.iter(|| list(&search(black_box(rows)), rows.len()));
    });
}

fn neighbor_search(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("neighbor-search");
    group.sample_size(10);
    for count in [10_000, 100_000] {
        group.throughput(Throughput::Elements(count as u64));
        for size_ratio in [1.1, 2.0, 3.0, 5.0, 10.0] {
            let rows = pellets(count, size_ratio);
            let case = format!("{count}/1:{size_ratio}");
            let case = (rows.as_slice(), case.as_str());
            if size_ratio <= WIDEST_FOR_ONE_GRID {
                way(&mut group, "grid", case, |rows| {
                    Search::Grid(Grid::new(rows, SKIN, None))
                });
            }
            way(&mut group, "hierarchical-grid", case, |rows| {
                Search::HierarchicalGrid(HierarchicalGrid::new(rows, SKIN, None))
            });
            way(&mut group, "tree", case, |rows| {
                Search::Tree(Tree::new(rows, SKIN, None))
            });
        }
    }
    group.finish();
}

criterion_group!(benches, neighbor_search);
criterion_main!(benches);
