//! What makes a file no mesh.

use pelletflow_core::Vec3;

/// A file that holds no mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum MeshFileError {
    #[error("its name does not tell its format; expected a file that ends in .stl or .obj")]
    UnknownFormat,
    #[error("it holds no triangles; export the surface as a mesh, not as lines or as a solid")]
    Empty,
    #[error(
        "it has {bytes} bytes; a binary STL file has at least 84: export it again, or name another file"
    )]
    TooShort { bytes: usize },
    #[error(
        "it says {said} triangles and holds {held}: the file is cut off or its header is wrong; export it again"
    )]
    CutOff { said: usize, held: usize },
    #[error("it cannot be read at triangle {triangle}: {reason}; export it again")]
    Malformed { triangle: usize, reason: String },
    #[error("it cannot be read: {reason}; export it again")]
    Unreadable { reason: String },
    #[error(
        "triangle {triangle} has a corner at ({}, {}, {}); expected finite numbers: export it again",
        at.x, at.y, at.z
    )]
    NotFinite { triangle: usize, at: Vec3 },
}
