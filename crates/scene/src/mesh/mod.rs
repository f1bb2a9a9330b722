//! Meshes from files of CAD: read, mended and judged.

mod bake;
mod error;
mod obj;
mod repair;
mod report;
mod rims;
mod stl;

pub use bake::BakeReport;
pub(crate) use error::MeshFileError;
pub(crate) use repair::{Repair, mend};
pub use report::{MeshReport, Rim};

use pelletflow_core::Vec3;
use std::path::Path;

/// Triangles as a file lists them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Soup {
    /// Corners, in the unit of the file.
    pub(crate) vertices: Vec<Vec3>,
    /// Places of three corners each [-].
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Bytes after the last triangle that were not read [-].
    pub(crate) unread_bytes: usize,
}

/// Reads the bytes of a file in the format that its name tells.
pub(crate) fn read(path: &Path, bytes: &[u8]) -> Result<Soup, MeshFileError> {
    let ending = path
        .extension()
        .map(|ending| ending.to_string_lossy().to_lowercase());
    let soup = match ending.as_deref() {
        Some("stl") => stl::read(bytes),
        Some("obj") => obj::read(bytes),
        _ => Err(MeshFileError::UnknownFormat),
    }?;
    if soup.triangles.is_empty() {
        return Err(MeshFileError::Empty);
    }
    let is_finite = |corner: &u32| {
        soup.vertices[*corner as usize]
            .iter()
            .all(|value| value.is_finite())
    };
    for (index, corners) in soup.triangles.iter().enumerate() {
        if let Some(&corner) = corners.iter().find(|corner| !is_finite(corner)) {
            return Err(MeshFileError::NotFinite {
                triangle: index + 1,
                at: soup.vertices[corner as usize],
            });
        }
    }
    Ok(soup)
}

#[cfg(test)]
mod contract;
