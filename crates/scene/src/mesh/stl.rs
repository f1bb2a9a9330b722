//! STL files, as text and in binary.

use super::{MeshFileError, Soup};
use pelletflow_core::Vec3;
use std::collections::HashMap;
use std::io::Cursor;

/// Bytes of a binary file before its number of triangles: free text [-].
const HEADER: usize = 80;
/// Bytes before its first triangle [-].
const START: usize = HEADER + size_of::<u32>();
/// Bytes of one of its triangles [-].
const TRIANGLE: usize = 50;

pub(super) fn read(bytes: &[u8]) -> Result<Soup, MeshFileError> {
    if is_text(bytes) {
        return triangles(plain(bytes));
    }
    if bytes.len() < START {
        return Err(MeshFileError::TooShort { bytes: bytes.len() });
    }
    let count: [u8; 4] = std::array::from_fn(|place| bytes[HEADER + place]);
    let said = u32::from_le_bytes(count) as usize;
    let held = (bytes.len() - START) / TRIANGLE;
    if held < said {
        return Err(MeshFileError::CutOff { said, held });
    }
    // The reader takes a header that begins with "solid" for a text.
    let mut blank = bytes.to_vec();
    blank[..HEADER].fill(0);
    Ok(Soup {
        unread_bytes: bytes.len() - START - said * TRIANGLE,
        ..triangles(blank)?
    })
}

/// Many binary files begin with "solid" too; but a text holds no zero byte, and the two bytes after a triangle are zero.
fn is_text(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.len() >= 5 && text[..5].eq_ignore_ascii_case(b"solid") && !bytes.contains(&0)
}

/// A text as the reader wants it: one solid, small letters, and normals that are numbers. They are not used.
fn plain(bytes: &[u8]) -> Vec<u8> {
    let mut plain = String::from("solid \n");
    for line in String::from_utf8_lossy(bytes).to_lowercase().lines() {
        let line = line.trim();
        let is_frame = line.starts_with("solid") || line.starts_with("endsolid");
        if line.starts_with("facet") {
            plain.push_str("facet normal 0 0 1\n");
        } else if !is_frame && !line.is_empty() {
            plain.push_str(line);
            plain.push('\n');
        }
    }
    // Where the last triangle is whole, a missing end is no loss.
    if plain.ends_with("endfacet\n") || !plain.contains("facet") {
        plain.push_str("endsolid\n");
    }
    plain.into_bytes()
}

fn triangles(file: Vec<u8>) -> Result<Soup, MeshFileError> {
    let mut file = Cursor::new(file);
    let reader =
        stl_io::create_stl_reader(&mut file).map_err(|error| MeshFileError::Unreadable {
            reason: error.to_string(),
        })?;
    let mut soup = Soup::default();
    let mut known = HashMap::new();
    for (index, triangle) in reader.enumerate() {
        let triangle = triangle.map_err(|error| MeshFileError::Malformed {
            triangle: index + 1,
            reason: error.to_string(),
        })?;
        let corners = triangle.vertices.map(|corner| {
            let at = corner.0.map(f64::from);
            // Adding zero turns -0 into 0, which is the same place with other bits.
            *known
                .entry(at.map(|value| (value + 0.0).to_bits()))
                .or_insert_with(|| {
                    soup.vertices.push(Vec3::from(at));
                    soup.vertices.len() as u32 - 1
                })
        });
        soup.triangles.push(corners);
    }
    Ok(soup)
}
