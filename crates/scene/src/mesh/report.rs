//! What was found in a mesh, and what was done about it.

use super::BakeReport;
use pelletflow_core::Vec3;

/// A mesh as it was read, and what was found in it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshReport {
    /// Name of the wall.
    pub wall: String,
    /// The file, as the scene names it.
    pub file: String,
    /// Triangles kept [-].
    pub triangles: usize,
    /// Corners kept [-].
    pub vertices: usize,
    /// Sides of the box about it [m].
    pub size: Vec3,
    /// Triangles without area [-].
    pub degenerate: usize,
    /// Triangles that are there more than once [-].
    pub duplicates: usize,
    /// Corners that were within the welding distance of another [-].
    pub welded: usize,
    /// Triangles turned over, so that neighbors have one side [-].
    pub flipped: usize,
    /// Edges of one triangle only [-].
    pub open_edges: usize,
    /// Lines of such edges, each a hole or the border of a sheet [-].
    pub rims: usize,
    /// The largest of them.
    pub largest_rim: Option<Rim>,
    /// Edges of more than two triangles [-].
    pub crowded_edges: usize,
    /// Bytes after the last triangle that were not read [-].
    pub unread_bytes: usize,
    /// Whether what can be mended was.
    pub is_repaired: bool,
    /// The grid that stands in for it, where it is baked.
    pub bake: Option<BakeReport>,
}

/// A line of open edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rim {
    /// Middle of the box about it [m].
    pub center: Vec3,
    /// Diagonal of that box [m].
    pub size: f64,
}

impl MeshReport {
    /// What is harmless, in a sentence: `1204 triangles, 0.8 x 0.5 x 1.2 m; dropped 3 without area`.
    pub fn summary(&self) -> String {
        let size = self.size;
        let mut parts = vec![format!(
            "{}: {} triangles, {:.4} x {:.4} x {:.4} m",
            self.file, self.triangles, size.x, size.y, size.z
        )];
        let verb = |done: &'static str| if self.is_repaired { done } else { "has" };
        for (verb, number, what) in [
            (verb("dropped"), self.degenerate, "triangles without area"),
            (verb("dropped"), self.duplicates, "triangles there twice"),
            (verb("welded"), self.welded, "corners near others"),
            (
                verb("turned over"),
                self.flipped,
                "triangles against their neighbors",
            ),
        ] {
            if number > 0 {
                parts.push(format!("{verb} {number} {what}"));
            }
        }
        parts.join("; ")
    }

    /// What may be a mistake, each in a sentence with its cure.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        if let Some(rim) = self.largest_rim {
            warnings.push(format!(
                "{} open edges in {}; the largest is {:.4} m across, about ({:.4}, {:.4}, {:.4}) m: a hole lets pellets \
                 through, the border of a sheet is harmless; close holes in CAD, or raise `weld`",
                self.open_edges,
                match self.rims {
                    1 => "1 line".to_owned(),
                    rims => format!("{rims} lines"),
                },
                rim.size,
                rim.center.x,
                rim.center.y,
                rim.center.z
            ));
        }
        if self.crowded_edges > 0 {
            warnings.push(format!(
                "{} edges belong to more than two triangles: sheets meet there, or parts overlap; contact is right all the same",
                self.crowded_edges
            ));
        }
        warnings.extend(self.bake.and_then(|bake| bake.warning()));
        if self.unread_bytes > 0 {
            warnings.push(format!(
                "{} bytes after the last triangle were not read; if triangles are missing, export it again",
                self.unread_bytes
            ));
        }
        warnings
    }
}
