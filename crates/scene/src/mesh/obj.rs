//! OBJ files: faces of any number of corners, cut into triangles.

use super::{MeshFileError, Soup};
use pelletflow_core::Vec3;
use tobj::LoadOptions;

pub(super) fn read(bytes: &[u8]) -> Result<Soup, MeshFileError> {
    let file = without_looks(bytes);
    let options = LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..LoadOptions::default()
    };
    // Colors are of no use here, so that files of materials may be missing.
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let (models, _) =
        tobj::load_obj_buf(&mut file.as_slice(), &options, no_materials).map_err(|error| {
            MeshFileError::Unreadable {
                reason: error.to_string(),
            }
        })?;
    let mut soup = Soup::default();
    for model in &models {
        let first = soup.vertices.len() as u32;
        let (positions, _) = model.mesh.positions.as_chunks::<3>();
        soup.vertices
            .extend(positions.iter().map(|&corner| Vec3::from(corner)));
        let (triangles, _) = model.mesh.indices.as_chunks::<3>();
        soup.triangles.extend(
            triangles
                .iter()
                .map(|corners| corners.map(|corner| first + corner)),
        );
    }
    Ok(soup)
}

/// The file without normals and places in pictures, which are of no use here: tobj 4.0.5 panics where a face names one
/// that is far beyond those there are.
fn without_looks(bytes: &[u8]) -> Vec<u8> {
    let is_of_use = |line: &&[u8]| {
        let line = std::str::from_utf8(line).unwrap_or_default();
        !matches!(line.split_whitespace().next(), Some("vn" | "vt"))
    };
    let lines = bytes.split_inclusive(|&byte| byte == b'\n');
    lines.filter(is_of_use).collect::<Vec<_>>().concat()
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn a_face_that_names_a_normal_far_beyond_those_there_are_has_its_corners() {
        let file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n vt 0 0\nf 1/1/1 2/1/-41 3/1/1\n";
        let soup = read(file.as_bytes()).expect("its corners are there");
        assert_eq!(soup.triangles, [[0, 1, 2]]);
        assert_eq!(soup.vertices.len(), 3);
    }
}
