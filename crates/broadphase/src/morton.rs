//! Storage order: pellets near in space are near in memory.

use crate::SphereRow;

/// Bits of each coordinate in a key: three times 21 fit in 64 [-].
const BITS: u32 = 21;

/// Cells on either side of the origin along an axis [-].
const HALF: f64 = (1_u32 << (BITS - 1)) as f64;

/// Place of a pellet along Morton's curve over cells of a width [m].
///
/// The cells lie where the width says, wherever the pellets are: what rests keeps its key.
#[inline]
pub fn key(row: &SphereRow, cell_width: f64) -> u64 {
    let spread = |axis: usize| {
        // A conversion to a whole number saturates; truncation is the next whole number below of what is positive.
        let cell = (row[axis] / cell_width + HALF) as u64;
        spread_bits(cell.min((1 << BITS) - 1))
    };
    spread(0) | spread(1) << 1 | spread(2) << 2
}

/// Order of the pellets along Morton's curve: the n-th entry is the row to put n-th.
///
/// Pellets of one cell keep their order, so the result depends on nothing but the keys.
pub fn order(keys: &[u64]) -> Vec<u32> {
    let mut places: Vec<(u64, u32)> = keys.iter().copied().zip(0..).collect();
    places.sort_unstable();
    places.into_iter().map(|(_, index)| index).collect()
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
        let keys: Vec<u64> = rows.iter().map(|row| key(row, 0.5)).collect();
        let order = order(&keys);
        let visited: Vec<SphereRow> = order.iter().map(|&index| rows[index as usize]).collect();
        assert_eq!(visited, (0..8).map(corner).collect::<Vec<_>>());
    }
}
