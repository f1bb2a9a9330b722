//! Storage order: pellets near in space are near in memory.

use crate::SphereRow;

/// Bits of each coordinate in a key: three times 21 fit in 64 [-].
const BITS: u32 = 21;

/// Order of the pellets along Morton's curve over cells of a width [m]: the n-th entry is the row to put n-th.
///
/// Pellets of one cell keep their order, so the result depends on nothing but the rows.
pub fn order(rows: &[SphereRow], cell_width: f64) -> Vec<u32> {
    let mut low = [f64::INFINITY; 3];
    for row in rows {
        for axis in 0..3 {
            low[axis] = low[axis].min(row[axis]);
        }
    }
    let per_meter = 1.0 / cell_width;
    let largest = f64::from((1_u32 << BITS) - 1);
    let mut keys: Vec<(u64, u32)> = rows
        .iter()
        .enumerate()
        .map(|(index, row)| {
            let spread = |axis: usize| {
                spread_bits((((row[axis] - low[axis]) * per_meter).min(largest)) as u64)
            };
            (spread(0) | spread(1) << 1 | spread(2) << 2, index as u32)
        })
        .collect();
    keys.sort_unstable();
    keys.into_iter().map(|(_, index)| index).collect()
}

/// Puts two zeros between every two bits.
fn spread_bits(value: u64) -> u64 {
    let mut spread = value & 0x1f_ffff;
    spread = (spread | spread << 32) & 0x001f_0000_0000_ffff;
    spread = (spread | spread << 16) & 0x001f_0000_ff00_00ff;
    spread = (spread | spread << 8) & 0x100f_00f0_0f00_f00f;
    spread = (spread | spread << 4) & 0x10c3_0c30_c30c_30c3;
    (spread | spread << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_each_octant_of_a_cube_before_the_next() {
        let corner = |index: usize| {
            let bit = |shift: usize| (index >> shift & 1) as f64;
            [bit(0), bit(1), bit(2), 0.1]
        };
        let rows: Vec<SphereRow> = (0..8).rev().map(corner).collect();
        let order = order(&rows, 0.5);
        let visited: Vec<SphereRow> = order.iter().map(|&index| rows[index as usize]).collect();
        assert_eq!(visited, (0..8).map(corner).collect::<Vec<_>>());
    }
}
