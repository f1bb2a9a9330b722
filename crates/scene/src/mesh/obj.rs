//! OBJ files: faces of any number of corners, cut into triangles.

use super::{MeshFileError, Soup};
use pelletflow_core::Vec3;
use tobj::LoadOptions;

pub(super) fn read(bytes: &[u8]) -> Result<Soup, MeshFileError> {
    let options = LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..LoadOptions::default()
    };
    // Colors are of no use here, so that files of materials may be missing.
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let (models, _) =
        tobj::load_obj_buf(&mut &*bytes, &options, no_materials).map_err(|error| {
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
