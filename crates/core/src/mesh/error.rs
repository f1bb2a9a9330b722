//! What makes a list of triangles no mesh.

use crate::Vec3;

/// A list of triangles that is no mesh.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// None, or more than can be numbered.
    #[error("has {triangles} triangles; expected at least one and fewer than 2^32")]
    Count {
        /// How many there are [-].
        triangles: usize,
    },
    /// A corner is nowhere.
    #[error("corner {vertex} is at ({}, {}, {}); expected finite numbers", at.x, at.y, at.z)]
    NotFinite {
        /// Number of the corner, from 0 [-].
        vertex: usize,
        /// Where it is said to be [m].
        at: Vec3,
    },
    /// A triangle names a corner that is not there.
    #[error("triangle {triangle} names a corner that is not among the {vertices} there are")]
    UnknownVertex {
        /// Number of the triangle, from 0 [-].
        triangle: usize,
        /// Number of corners [-].
        vertices: usize,
    },
    /// A triangle is a line or a point.
    #[error("triangle {triangle}, about ({}, {}, {}) m, is no more than a line", at.x, at.y, at.z)]
    Degenerate {
        /// Number of the triangle, from 0 [-].
        triangle: usize,
        /// One of its corners [m].
        at: Vec3,
    },
}
