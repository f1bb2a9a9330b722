//! A surface as triangles and the lines of its sharp edges.

use pelletflow_core::{Bounds, Vec3};
use std::collections::HashMap;

/// Triangles, counterclockwise as seen from outside, and sharp edges [m].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Corners of each triangle [m].
    pub triangles: Vec<[Vec3; 3]>,
    /// Ends of each piece of a sharp edge [m].
    pub edges: Vec<[Vec3; 2]>,
}

impl Mesh {
    /// Each different corner once [m], and the triangles as positions in that list.
    pub fn indexed(&self) -> (Vec<Vec3>, Vec<u32>) {
        let mut corners = Vec::new();
        let mut known = HashMap::new();
        let indices = self
            .triangles
            .iter()
            .flatten()
            .map(|corner| {
                // Adding zero turns -0 into 0, which is the same place with other bits.
                let bits = [corner.x, corner.y, corner.z].map(|value| (value + 0.0).to_bits());
                *known.entry(bits).or_insert_with(|| {
                    corners.push(*corner);
                    corners.len() as u32 - 1
                })
            })
            .collect();
        (corners, indices)
    }

    /// The smallest box around the triangles [m].
    pub fn bounds(&self) -> Bounds {
        self.triangles
            .iter()
            .flatten()
            .fold(Bounds::nothing(), |bounds, corner| Bounds {
                min: bounds.min.inf(corner),
                max: bounds.max.sup(corner),
            })
    }

    /// Every point taken to another place.
    #[must_use]
    pub(super) fn mapped(mut self, motion: impl Fn(Vec3) -> Vec3) -> Self {
        for point in self.triangles.iter_mut().flatten() {
            *point = motion(*point);
        }
        for point in self.edges.iter_mut().flatten() {
            *point = motion(*point);
        }
        self
    }

    /// The same surface with inside and outside exchanged.
    #[must_use]
    pub(super) fn inside_out(mut self) -> Self {
        for triangle in &mut self.triangles {
            triangle.swap(1, 2);
        }
        self
    }

    /// Adds a flat convex polygon, listed counterclockwise as seen from outside [m].
    pub(super) fn push_polygon(&mut self, corners: &[Vec3]) {
        for pair in corners.windows(2).skip(1) {
            self.triangles.push([corners[0], pair[0], pair[1]]);
        }
    }

    /// Adds a closed line of edges [m].
    pub(super) fn push_outline(&mut self, corners: &[Vec3]) {
        let next = corners.iter().cycle().skip(1);
        self.edges
            .extend(corners.iter().zip(next).map(|(&from, &to)| [from, to]));
    }
}

impl FromIterator<Mesh> for Mesh {
    fn from_iter<I: IntoIterator<Item = Mesh>>(parts: I) -> Self {
        let mut whole = Self::default();
        for part in parts {
            whole.triangles.extend(part.triangles);
            whole.edges.extend(part.edges);
        }
        whole
    }
}
