//! Meshes of triangles, as they come from CAD: thin sheets, touched from both sides.
//!
//! A mesh has no inside. Its surface is where its triangles are, and its normal points from there to whoever asks.
//! A ball touches it where a point of it is nearer than all points about that one, be that in the middle of a triangle, on an
//! edge or on a corner, and each such place counts once: how finely a plane is cut must not be felt.

mod contact;
mod distance_grid;
mod error;
mod probe;
mod sides;
mod triangle;

pub use distance_grid::{DistanceGrid, GridLayout, GridTooFine, MOST_MEMORY};
pub use error::MeshError;
pub use probe::Probes;
pub use sides::{Sides, SidesError};
pub use triangle::{Foot, FootOn, Triangle};

use crate::{Bounds, Touches, Vec3};
use std::sync::Arc;

/// Height of a triangle over the size of its mesh below which it is a line [-].
const FLATTEST: f64 = 1.0e-12;

/// A mesh of triangles; a clone shares them.
///
/// ```
/// use pelletflow_core::{TriangleMesh, Vec3};
///
/// let corners = vec![Vec3::zeros(), Vec3::x(), Vec3::y()];
/// let mesh = TriangleMesh::new(corners, vec![[0, 1, 2]])?;
/// let touches = mesh.touches(&[0], Vec3::new(0.2, 0.2, 0.3), 0.4);
/// assert_eq!(touches.as_slice()[0].distance, 0.3);
/// # Ok::<(), pelletflow_core::MeshError>(())
/// ```
#[derive(Debug, Clone)]
pub struct TriangleMesh {
    parts: Arc<Parts>,
}

#[derive(Debug, PartialEq)]
struct Parts {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    bounds: Bounds,
}

impl TriangleMesh {
    /// A mesh from its corners [m] and three of them, by their places in the list, for each triangle.
    ///
    /// # Errors
    /// There is no triangle, one names a corner that is not there or is no more than a line, or a corner is not finite.
    pub fn new(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        if triangles.is_empty() || u32::try_from(triangles.len()).is_err() {
            return Err(MeshError::Count {
                triangles: triangles.len(),
            });
        }
        if let Some(vertex) = vertices
            .iter()
            .position(|at| !at.iter().all(|x| x.is_finite()))
        {
            return Err(MeshError::NotFinite {
                vertex,
                at: vertices[vertex],
            });
        }
        let is_known = |corners: &[u32; 3]| corners.iter().all(|&c| (c as usize) < vertices.len());
        if let Some(triangle) = triangles.iter().position(|corners| !is_known(corners)) {
            return Err(MeshError::UnknownVertex {
                triangle,
                vertices: vertices.len(),
            });
        }
        let bounds = triangles
            .iter()
            .flatten()
            .fold(Bounds::nothing(), |box_, &corner| {
                let at = vertices[corner as usize];
                box_.merged(&Bounds { min: at, max: at })
            });
        let mesh = Self {
            parts: Arc::new(Parts {
                vertices,
                triangles,
                bounds,
            }),
        };
        let flattest = FLATTEST * mesh.size();
        let flat = mesh
            .triangles()
            .position(|triangle| triangle.height() <= flattest);
        match flat {
            Some(triangle) => Err(MeshError::Degenerate {
                triangle,
                at: mesh.triangle(triangle as u32).corners[0],
            }),
            None => Ok(mesh),
        }
    }

    /// Corners, each once [m].
    pub fn vertices(&self) -> &[Vec3] {
        &self.parts.vertices
    }

    /// Places of the corners of each triangle in the list of corners [-].
    pub fn indices(&self) -> &[[u32; 3]] {
        &self.parts.triangles
    }

    /// A triangle by its number [-].
    #[inline]
    pub fn triangle(&self, index: u32) -> Triangle {
        let corners = self.parts.triangles[index as usize];
        Triangle {
            corners: corners.map(|corner| self.parts.vertices[corner as usize]),
        }
    }

    /// All triangles, in their order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = Triangle> + '_ {
        (0..self.parts.triangles.len()).map(|index| self.triangle(index as u32))
    }

    /// A box about all triangles [m].
    pub fn bounds(&self) -> Bounds {
        self.parts.bounds
    }

    /// Diagonal of that box [m].
    pub fn size(&self) -> f64 {
        (self.parts.bounds.max - self.parts.bounds.min).norm()
    }

    /// Where a ball of radius `reach` [m] about `center` [m] touches, of all that it can reach named in `candidates`.
    pub fn touches(&self, candidates: &[u32], center: Vec3, reach: f64) -> Touches {
        let mut touches = Touches::none(reach);
        contact::offer(self, candidates, center, &mut touches);
        touches
    }
}

impl PartialEq for TriangleMesh {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.parts, &other.parts) || self.parts == other.parts
    }
}

#[cfg(test)]
mod contract;
