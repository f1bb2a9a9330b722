//! The triangles of a mesh in parry's tree of boxes.

use crate::tree::box_about;
use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::Vector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode};
use parry3d_f64::query::PointQuery;
use pelletflow_core::{TriangleMesh, Vec3};

/// Boxes of all triangles of a mesh, in the frame of the mesh.
#[derive(Debug, Clone)]
pub struct MeshTree {
    mesh: TriangleMesh,
    boxes: Bvh,
}

impl MeshTree {
    /// Builds the tree.
    pub fn new(mesh: TriangleMesh) -> Self {
        let boxes: Vec<Aabb> = mesh
            .triangles()
            .map(|triangle| Aabb::from_points(triangle.corners.map(vector)))
            .collect();
        Self {
            mesh,
            boxes: Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes),
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    /// Appends the triangles that are nearer than `reach` [m] to a point [m], rising.
    pub fn triangles_near(&self, point: Vec3, reach: f64, triangles: &mut Vec<u32>) {
        let first = triangles.len();
        let row = [point.x, point.y, point.z, reach];
        triangles.extend(
            self.boxes
                .intersect_aabb(&box_about(&row, 0.0))
                .filter(|&index| self.mesh.triangle(index).distance(point) < reach),
        );
        triangles[first..].sort_unstable();
    }

    /// Distance of a point [m] from the nearest triangle, never negative [m].
    pub fn distance(&self, point: Vec3) -> f64 {
        self.nearest(point).1
    }

    /// Number of the triangle nearest to a point [m], and its distance [m].
    ///
    /// # Panics
    /// Only for a point that is not a number.
    pub fn nearest(&self, point: Vec3) -> (u32, f64) {
        let at = vector(point);
        self.boxes
            .find_best(
                f64::MAX,
                |node: &BvhNode, _| node.aabb().distance_to_local_point(at, true),
                |index, _| Some(self.mesh.triangle(index).distance(point)),
            )
            .expect("a mesh has a triangle")
    }
}

fn vector(point: Vec3) -> Vector {
    Vector::new(point.x, point.y, point.z)
}
