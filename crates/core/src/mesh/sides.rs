//! The two sides of a closed mesh, and how far on which of them a point is.
//!
//! The sign is that of the angle-weighted pseudo-normal of the face, edge or corner that is nearest: it is right for every
//! point beside a closed surface whose triangles wind the same way (Bærentzen & Aanæs 2005).

use super::{Foot, FootOn, Triangle, TriangleMesh};
use crate::Vec3;
use std::collections::BTreeMap;

/// Distance over the length of an edge below which a foot is on a corner: beyond rounding [-].
const AT_CORNER: f64 = 1.0e-9;

/// A mesh without two sides; each names one place [m] and how often it happens.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SidesError {
    /// Edges of one triangle only.
    #[error("is open along {edges} edges, one about ({}, {}, {}) m", at.x, at.y, at.z)]
    Open {
        /// How many there are [-].
        edges: usize,
        /// Middle of the first [m].
        at: Vec3,
    },
    /// Edges of more than two triangles.
    #[error("has {edges} edges of more than two triangles, one about ({}, {}, {}) m", at.x, at.y, at.z)]
    Crowded {
        /// How many there are [-].
        edges: usize,
        /// Middle of the first [m].
        at: Vec3,
    },
    /// Edges whose two triangles wind against each other.
    #[error("turns its other side out across {edges} edges, one about ({}, {}, {}) m", at.x, at.y, at.z)]
    Turned {
        /// How many there are [-].
        edges: usize,
        /// Middle of the first [m].
        at: Vec3,
    },
}

/// A closed mesh whose triangles all wind the same way, with the normals of its edges and corners.
#[derive(Debug, Clone)]
pub struct Sides {
    mesh: TriangleMesh,
    /// Of each triangle, sums of the two unit normals at its edges, the first from its first corner to its second.
    edges: Vec<[Vec3; 3]>,
    /// Sums of unit normals about each corner, weighted by their angles.
    corners: Vec<Vec3>,
}

impl Sides {
    /// The sides of a mesh; a clone of it shares the triangles.
    ///
    /// # Errors
    /// It is open, sheets of it meet in a line, or neighbors wind against each other.
    pub fn new(mesh: &TriangleMesh) -> Result<Self, SidesError> {
        let mut beside: BTreeMap<[u32; 2], Vec<(usize, usize)>> = BTreeMap::new();
        let mut corners = vec![Vec3::zeros(); mesh.vertices().len()];
        let normals: Vec<Vec3> = mesh
            .triangles()
            .map(|triangle| triangle.area_vector().normalize())
            .collect();
        for (index, (places, triangle)) in mesh.indices().iter().zip(mesh.triangles()).enumerate() {
            for side in 0..3 {
                let (from, to) = (places[side], places[(side + 1) % 3]);
                beside
                    .entry([from.min(to), from.max(to)])
                    .or_default()
                    .push((index, side));
                corners[from as usize] += angle(&triangle, side) * normals[index];
            }
        }
        let mut edges = vec![[Vec3::zeros(); 3]; normals.len()];
        let (mut open, mut crowded, mut turned) = (Vec::new(), Vec::new(), Vec::new());
        for (&ends, beside) in &beside {
            match beside[..] {
                [_] => open.push(ends),
                [(a, side), (b, other_side)] => {
                    if mesh.indices()[a][side] == mesh.indices()[b][other_side] {
                        turned.push(ends);
                    }
                    let sum = normals[a] + normals[b];
                    (edges[a][side], edges[b][other_side]) = (sum, sum);
                }
                _ => crowded.push(ends),
            }
        }
        let middle = |ends: [u32; 2]| {
            let [a, b] = ends.map(|end| mesh.vertices()[end as usize]);
            (a + b) / 2.0
        };
        let (open, crowded, turned) = (open.as_slice(), crowded.as_slice(), turned.as_slice());
        if let [first, ..] = *open {
            return Err(SidesError::Open {
                edges: open.len(),
                at: middle(first),
            });
        }
        if let [first, ..] = *crowded {
            return Err(SidesError::Crowded {
                edges: crowded.len(),
                at: middle(first),
            });
        }
        if let [first, ..] = *turned {
            return Err(SidesError::Turned {
                edges: turned.len(),
                at: middle(first),
            });
        }
        Ok(Self {
            mesh: mesh.clone(),
            edges,
            corners,
        })
    }

    /// The mesh.
    pub fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    /// Distance of a point [m] from the triangle that is nearest to it, by its number [-]; negative behind the mesh [m].
    pub fn distance(&self, nearest: u32, point: Vec3) -> f64 {
        let triangle = self.mesh.triangle(nearest);
        let foot = triangle.foot(point);
        let way = point - foot.at;
        way.norm()
            .copysign(self.normal(nearest, &triangle, &foot).dot(&way))
    }

    /// Length of an edge [m] times how far it is from flat [-], from 0 to 1; by triangle and side [-].
    pub(super) fn sharp_length(&self, triangle: usize, side: usize) -> f64 {
        let corners = self.mesh.triangle(triangle as u32).corners;
        let flatness = self.edges[triangle][side].norm() / 2.0;
        (corners[(side + 1) % 3] - corners[side]).norm() * (1.0 - flatness).max(0.0)
    }

    /// A vector that points out of the mesh at a foot [-]; not of unit length.
    fn normal(&self, index: u32, triangle: &Triangle, foot: &Foot) -> Vec3 {
        let corners = triangle.corners;
        if foot.on == FootOn::Face {
            return triangle.area_vector();
        }
        let off_corner = |corner: usize| (foot.at - corners[corner]).norm_squared();
        let corner = least(off_corner);
        let next = corners[(corner + 1) % 3] - corners[corner];
        // By rounding, a foot on a corner may be found on an edge, and all edges there are as near.
        let is_at_corner = off_corner(corner) <= AT_CORNER * AT_CORNER * next.norm_squared();
        if foot.on == FootOn::Corner || is_at_corner {
            return self.corners[self.mesh.indices()[index as usize][corner] as usize];
        }
        let off_edge = |side: usize| {
            let along = corners[(side + 1) % 3] - corners[side];
            let across = along.cross(&(foot.at - corners[side]));
            across.norm_squared() / along.norm_squared()
        };
        self.edges[index as usize][least(off_edge)]
    }
}

/// Which of three is least.
fn least(of: impl Fn(usize) -> f64) -> usize {
    (1..3).fold(
        0,
        |best, next| if of(next) < of(best) { next } else { best },
    )
}

/// Angle at a corner of a triangle [rad].
fn angle(triangle: &Triangle, corner: usize) -> f64 {
    let [at, next, last] = [0, 1, 2].map(|step| triangle.corners[(corner + step) % 3]);
    (next - at).angle(&(last - at))
}
