//! What a file of CAD often has wrong, mended.

use super::rims::{Edges, rims};
use super::{MeshReport, Soup};
use pelletflow_core::mesh::Triangle;
use pelletflow_core::{MeshError, TriangleMesh, Vec3};
use std::collections::{BTreeSet, HashMap};

/// Share of its size within which corners of a mesh are one: beyond the rounding of single precision [-].
const WELD: f64 = 1.0e-6;
/// Height of a triangle over the size of the mesh up to which it has no area [-].
const FLATTEST: f64 = 1.0e-9;

/// What is to be done about what is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Repair {
    /// Only tell.
    No,
    /// Mend, with corners one within a distance [m]; a share of the size of the mesh where none is given.
    Within(Option<f64>),
}

/// A mesh and what was found in it.
#[derive(Debug)]
pub(crate) struct Mended {
    pub(crate) mesh: TriangleMesh,
    pub(crate) report: MeshReport,
}

/// Mends triangles whose corners are in meters, and tells what was found.
pub(crate) fn mend(soup: &Soup, repair: Repair) -> Result<Mended, MeshError> {
    let size = size(&soup.vertices);
    let distance = match repair {
        Repair::Within(Some(distance)) => distance,
        _ => WELD * size,
    };
    let welded = Welded::new(soup, distance);
    let mut report = MeshReport {
        degenerate: soup.triangles.len() - welded.triangles.len(),
        welded: soup.vertices.len() - welded.vertices.len(),
        unread_bytes: soup.unread_bytes,
        is_repaired: repair != Repair::No,
        ..MeshReport::default()
    };
    let mut seen = BTreeSet::new();
    let (mut triangles, twice): (Vec<_>, Vec<_>) = welded.triangles.iter().partition(|&&corners| {
        let mut sorted = corners;
        sorted.sort_unstable();
        seen.insert(sorted)
    });
    report.duplicates = twice.len();

    // Slivers still join their neighbors; they go only after the edges have been looked at.
    let edges = Edges::new(&triangles);
    report.open_edges = edges.open().count();
    report.crowded_edges = edges.crowded();
    (report.rims, report.largest_rim) = rims(&edges, &welded.vertices);
    let turned = edges.turned(triangles.len());
    report.flipped = turned.iter().filter(|turned| **turned).count();
    for (corners, turned) in triangles.iter_mut().zip(turned) {
        if turned {
            corners.swap(1, 2);
        }
    }
    let with_slivers = triangles.len();
    triangles.retain(|corners| {
        let corners = corners.map(|corner| welded.vertices[corner as usize]);
        Triangle { corners }.height() > FLATTEST * size
    });
    report.degenerate += with_slivers - triangles.len();

    let mesh = match repair {
        Repair::No => TriangleMesh::new(soup.vertices.clone(), soup.triangles.clone()),
        Repair::Within(_) => TriangleMesh::new(welded.vertices, triangles),
    }?;
    let bounds = mesh.bounds();
    Ok(Mended {
        report: MeshReport {
            triangles: mesh.indices().len(),
            vertices: mesh.vertices().len(),
            size: bounds.max - bounds.min,
            ..report
        },
        mesh,
    })
}

/// Diagonal of the box about some corners [m].
fn size(vertices: &[Vec3]) -> f64 {
    let (min, max) = vertices.iter().fold(
        (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY)),
        |(min, max), vertex| (min.inf(vertex), max.sup(vertex)),
    );
    (max - min).norm()
}

/// Triangles whose near corners are one, without those of fewer than three.
struct Welded {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Welded {
    fn new(soup: &Soup, distance: f64) -> Self {
        let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
        // Cells of twice the distance: a ball of that radius reaches into eight at most.
        let cell = |at: Vec3| {
            <[f64; 3]>::from(at / (2.0 * distance)).map(|coordinate| coordinate.floor() as i64)
        };
        let mut vertices: Vec<Vec3> = Vec::new();
        let place: Vec<u32> = soup
            .vertices
            .iter()
            .map(|&at| {
                let (low, high) = (
                    cell(at.add_scalar(-distance)),
                    cell(at.add_scalar(distance)),
                );
                let near = (0..8_usize)
                    .map(|choice| {
                        let side = |axis: usize| if choice >> axis & 1 == 0 { low } else { high };
                        [0, 1, 2].map(|axis| side(axis)[axis])
                    })
                    .filter_map(|key| cells.get(&key))
                    .flatten()
                    .copied()
                    .filter(|&known| (vertices[known as usize] - at).norm() <= distance)
                    .min();
                near.unwrap_or_else(|| {
                    let new = vertices.len() as u32;
                    vertices.push(at);
                    cells.entry(cell(at)).or_default().push(new);
                    new
                })
            })
            .collect();
        let triangles = soup
            .triangles
            .iter()
            .map(|corners| corners.map(|corner| place[corner as usize]))
            .filter(|[a, b, c]| a != b && b != c && c != a)
            .collect();
        Self {
            vertices,
            triangles,
        }
    }
}
