//! A closed mesh whose distances are taken from a grid.

use crate::MeshTree;
use pelletflow_core::mesh::{DistanceGrid, GridLayout, GridTooFine, Probes, Sides, SidesError};
use pelletflow_core::{Surface, TriangleMesh, Vec3};
use std::sync::Arc;

/// Triangles near a block up to which looking at all of them is quicker than the tree [-].
const FEW: usize = 48;

/// Twice the bound of a trilinear distance's deviation, in cells [-]: half the diagonal of a cell, as a distance changes by
/// no more than the way.
const MOST_CELLS_OFF: f64 = 2.0;

/// A mesh that cannot be baked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BakeError {
    /// It has no two sides.
    #[error(
        "the mesh {0}; expected a closed surface with one side out: close it in CAD, or leave `bake` out"
    )]
    Sides(#[from] SidesError),
    /// Its sides change where no triangle is: parts overlap, or one is inside out.
    #[error(
        "the mesh changes its side about ({}, {}, {}) m, where no triangle is: parts overlap, or one is inside out; \
         join the parts in CAD, or leave `bake` out", at.x, at.y, at.z
    )]
    Torn {
        /// Where [m].
        at: Vec3,
    },
    /// Its grid is too fine.
    #[error("the baked mesh {0}: take a longer `bake`, or leave it out")]
    TooFine(#[from] GridTooFine),
}

/// How far baked distances are from exact ones.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Deviation {
    /// Greatest, with edges and corners looked at closely [m].
    pub greatest: f64,
    /// Root mean square over points spread evenly about the surface [m].
    pub root_mean_square: f64,
}

/// A closed mesh with a grid of distances about it, in the frame of the mesh.
///
/// It is a sheet with two sides, as the mesh is: a pellet inside is held as one outside. A ball touches it at the nearest
/// point only, and the grid rounds its edges by a cell.
#[derive(Debug, Clone)]
pub struct BakedMesh {
    tree: Arc<MeshTree>,
    sides: Sides,
    grid: DistanceGrid,
    reach: f64,
}

impl BakedMesh {
    /// Bakes a mesh in cells of a length [m], to be asked within `reach` [m] of it.
    ///
    /// # Errors
    /// The mesh is open or has no sides, or the grid takes too much memory.
    pub fn new(mesh: TriangleMesh, spacing: f64, reach: f64) -> Result<Self, BakeError> {
        let sides = Sides::new(&mesh)?;
        let layout = GridLayout::new(&mesh, spacing, reach + MOST_CELLS_OFF * spacing)?;
        let tree = MeshTree::new(mesh);
        let block_size = 2.0 * layout.half_diagonal();
        let mut near = Vec::new();
        let grid = DistanceGrid::new(layout, |center, points, distances| {
            // The triangle nearest to a point of the block is no farther from its middle.
            near.clear();
            tree.triangles_near(center, tree.distance(center) + block_size, &mut near);
            distances.extend(points.iter().map(|&point| {
                let nearest = if near.len() <= FEW {
                    nearest_of(tree.mesh(), &near, point)
                } else {
                    tree.nearest(point).0
                };
                sides.distance(nearest, point)
            }));
        });
        if let Some(at) = grid.tear() {
            return Err(BakeError::Torn { at });
        }
        Ok(Self {
            tree: Arc::new(tree),
            sides,
            grid,
            reach,
        })
    }

    /// The mesh.
    pub fn mesh(&self) -> &TriangleMesh {
        self.tree.mesh()
    }

    /// Its triangles, ready to be asked.
    pub fn tree(&self) -> &Arc<MeshTree> {
        &self.tree
    }

    /// Length of a cell [m].
    pub fn spacing(&self) -> f64 {
        self.grid.layout().spacing()
    }

    /// Memory of the grid [B].
    pub fn bytes(&self) -> f64 {
        self.grid.layout().bytes()
    }

    /// The surface nearest to a point [m], taken for flat, if it is nearer than `reach` [m].
    ///
    /// Within the reach it was baked for, the grid alone is asked.
    #[inline]
    pub fn surface_within(&self, point: Vec3, reach: f64) -> Option<Surface> {
        let (signed, gradient) = match self.grid.at(point) {
            Some(found) => found,
            None if self.is_beyond(reach) => return None,
            None => self.exact(point),
        };
        let distance = signed.abs();
        if distance >= reach {
            return None;
        }
        let way = 1.0_f64.copysign(signed) * gradient;
        Some(Surface {
            distance,
            normal: way.try_normalize(0.0).unwrap_or_else(Vec3::z),
            principal_curvatures: [0.0; 2],
        })
    }

    /// Whether a point [m] may be nearer than `reach` [m] by the baked or by the exact distance.
    pub fn is_near(&self, point: Vec3, reach: f64) -> bool {
        // The distance is off here, and again after the pellet has moved.
        let most = reach + MOST_CELLS_OFF * self.spacing();
        match self.grid.at(point) {
            Some((distance, _)) => distance.abs() < most,
            None => !self.is_beyond(reach) && self.tree.distance(point) < most,
        }
    }

    /// How far the baked distance is from the exact one up to `reach` [m] from the surface, or that it was baked for.
    ///
    /// # Panics
    /// Never: cells are kept about all these points.
    pub fn deviation(&self, reach: f64) -> Deviation {
        let probes = Probes::new(&self.sides, reach.min(self.reach));
        let off = |&point: &Vec3| {
            let exact = self.sides.distance(self.tree.nearest(point).0, point);
            let (baked, _) = self.grid.at(point).expect("cells are kept within reach");
            (baked - exact).abs()
        };
        let on_faces: Vec<f64> = probes.faces.iter().map(off).collect();
        let squares: f64 = on_faces.iter().map(|off| off * off).sum();
        Deviation {
            greatest: probes
                .edges
                .iter()
                .map(off)
                .chain(on_faces.iter().copied())
                .fold(0.0, f64::max),
            root_mean_square: (squares / on_faces.len() as f64).sqrt(),
        }
    }

    /// Whether a point without a cell is certainly farther away than that [m]: cells are kept for more.
    fn is_beyond(&self, reach: f64) -> bool {
        reach <= self.reach
    }

    /// The exact signed distance with its gradient.
    fn exact(&self, point: Vec3) -> (f64, Vec3) {
        let nearest = self.tree.nearest(point).0;
        let signed = self.sides.distance(nearest, point);
        let foot = self.mesh().triangle(nearest).foot(point);
        (signed, (point - foot.at) / signed)
    }
}

impl PartialEq for BakedMesh {
    fn eq(&self, other: &Self) -> bool {
        self.mesh() == other.mesh()
            && self.spacing() == other.spacing()
            && self.reach == other.reach
    }
}

fn nearest_of(mesh: &TriangleMesh, triangles: &[u32], point: Vec3) -> u32 {
    let mut best = (f64::INFINITY, 0);
    for &index in triangles {
        let foot = mesh.triangle(index).foot(point).at;
        let squared = (point - foot).norm_squared();
        if squared < best.0 {
            best = (squared, index);
        }
    }
    best.1
}

#[cfg(test)]
mod contract;
