//! Walls in a tree of boxes, so that a pellet in the bulk never evaluates a distance.

use crate::tree::box_about;
use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::Vector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy};
use pelletflow_core::{Bounds, Vec3};

/// Half side of the box that stands for an infinite one; parry's boxes need numbers [m].
const FAR: f64 = 1.0e9;

/// Boxes of all walls.
#[derive(Debug)]
pub struct WallTree {
    tree: Bvh,
}

impl WallTree {
    /// Builds the tree from the bounds of each wall, in the world [m].
    pub fn new(bounds: &[Bounds]) -> Self {
        let boxes: Vec<Aabb> = bounds
            .iter()
            .map(|bounds| Aabb::new(finite(bounds.min), finite(bounds.max)))
            .collect();
        Self {
            tree: Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes),
        }
    }

    /// Puts the walls whose box is nearer than `margin` [m] to a pellet of that center and radius [m] into
    /// `walls`, rising.
    pub fn near_into(&self, center: Vec3, radius: f64, margin: f64, walls: &mut Vec<u32>) {
        walls.clear();
        let row = [center.x, center.y, center.z, radius];
        walls.extend(self.tree.intersect_aabb(&box_about(&row, margin)));
        walls.sort_unstable();
    }
}

fn finite(corner: Vec3) -> Vector {
    Vector::new(
        corner.x.clamp(-FAR, FAR),
        corner.y.clamp(-FAR, FAR),
        corner.z.clamp(-FAR, FAR),
    )
}
