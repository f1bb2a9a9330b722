//! Every pair: slow, obvious, and the oracle of the other ways.

use crate::periodic::is_image_within_reach;
use crate::{PeriodicBox, SphereRow, is_within_reach};

/// Calls `visit` with every other pellet within reach of `index`; `skin` is in [m].
pub fn for_each_within_reach(
    rows: &[SphereRow],
    skin: f64,
    periodic: Option<&PeriodicBox>,
    index: usize,
    visit: &mut impl FnMut(usize),
) {
    for (other, row) in rows.iter().enumerate() {
        let is_partner = match periodic {
            None => is_within_reach(&rows[index], row, skin),
            Some(periodic) => is_image_within_reach(periodic, &rows[index], row, skin),
        };
        if other != index && is_partner {
            visit(other);
        }
    }
}
