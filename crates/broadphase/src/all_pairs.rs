//! Every pair: slow, obvious, and the oracle of the other ways.

use crate::{SphereRow, is_within_reach};

/// Calls `visit` with every other pellet within reach of `index`; `skin` is in [m].
pub fn for_each_within_reach(
    rows: &[SphereRow],
    skin: f64,
    index: usize,
    visit: &mut impl FnMut(usize),
) {
    for (other, row) in rows.iter().enumerate() {
        if other != index && is_within_reach(&rows[index], row, skin) {
            visit(other);
        }
    }
}
