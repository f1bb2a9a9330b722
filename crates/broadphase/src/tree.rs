//! Parry's tree of boxes: best where sizes are far apart.

use crate::periodic::is_image_within_reach;
use crate::{PeriodicBox, SphereRow, is_within_reach};
use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::Vector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy};
use pelletflow_core::Vec3;

/// Pellets in a bounding-volume hierarchy.
#[derive(Debug)]
pub struct Tree<'a> {
    rows: &'a [SphereRow],
    skin: f64,
    periodic: Option<PeriodicBox>,
    boxes: Bvh,
}

impl<'a> Tree<'a> {
    /// Builds the tree; two pellets are partners when their gap is less than `skin` [m].
    pub fn new(rows: &'a [SphereRow], skin: f64, periodic: Option<PeriodicBox>) -> Self {
        let boxes: Vec<Aabb> = rows.iter().map(|row| box_about(row, skin / 2.0)).collect();
        Self {
            rows,
            skin,
            periodic,
            boxes: Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes),
        }
    }

    /// Calls `visit` with every other pellet within reach of `index`.
    pub fn for_each_within_reach(&self, index: usize, visit: &mut impl FnMut(usize)) {
        if let Some(periodic) = &self.periodic {
            self.for_each_image_within_reach(periodic, index, visit);
            return;
        }
        let row = &self.rows[index];
        for other in self.boxes.intersect_aabb(&box_about(row, self.skin / 2.0)) {
            let other = other as usize;
            if other != index && is_within_reach(row, &self.rows[other], self.skin) {
                visit(other);
            }
        }
    }

    fn for_each_image_within_reach(
        &self,
        periodic: &PeriodicBox,
        index: usize,
        visit: &mut impl FnMut(usize),
    ) {
        let row = &self.rows[index];
        let center = Vec3::new(row[0], row[1], row[2]);
        let mut candidates: Vec<u32> = Vec::new();
        for image in periodic.images(center) {
            let about = box_about(&[image.x, image.y, image.z, row[3]], self.skin / 2.0);
            candidates.extend(self.boxes.intersect_aabb(&about));
        }
        // The corners of two boxes may meet although the balls in them do not, and so more than one image be found.
        candidates.sort_unstable();
        candidates.dedup();
        for other in candidates.into_iter().map(|other| other as usize) {
            if other != index && is_image_within_reach(periodic, row, &self.rows[other], self.skin)
            {
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
