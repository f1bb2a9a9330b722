//! Parry's tree of boxes: best where sizes are far apart.

use crate::{SphereRow, is_within_reach};
use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::Vector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy};

/// Pellets in a bounding-volume hierarchy.
#[derive(Debug)]
pub struct Tree<'a> {
    rows: &'a [SphereRow],
    skin: f64,
    boxes: Bvh,
}

impl<'a> Tree<'a> {
    /// Builds the tree; two pellets are partners when their gap is less than `skin` [m].
    pub fn new(rows: &'a [SphereRow], skin: f64) -> Self {
        let boxes: Vec<Aabb> = rows.iter().map(|row| box_about(row, skin / 2.0)).collect();
        Self {
            rows,
            skin,
            boxes: Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes),
        }
    }

    /// Calls `visit` with every other pellet within reach of `index`.
    pub fn for_each_within_reach(&self, index: usize, visit: &mut impl FnMut(usize)) {
        let row = &self.rows[index];
        for other in self.boxes.intersect_aabb(&box_about(row, self.skin / 2.0)) {
            let other = other as usize;
            if other != index && is_within_reach(row, &self.rows[other], self.skin) {
                visit(other);
            }
        }
    }
}

pub(crate) fn box_about(row: &SphereRow, margin: f64) -> Aabb {
    let half_side = row[3] + margin;
    Aabb::new(
        Vector::new(row[0] - half_side, row[1] - half_side, row[2] - half_side),
        Vector::new(row[0] + half_side, row[1] + half_side, row[2] + half_side),
    )
}
