//! What reading and mending of meshes promise.

use super::{MeshFileError, Repair, Soup, mend, read};
use pelletflow_core::Vec3;
use std::path::Path;

/// A tetrahedron: corners and faces.
const CORNERS: [[f32; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

/// The tetrahedron as binary STL, with a header.
fn binary(header: &[u8]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend((FACES.len() as u32).to_le_bytes());
    for face in FACES {
        bytes.extend([0; 12]);
        for corner in face {
            bytes.extend(CORNERS[corner].iter().flat_map(|value| value.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// The tetrahedron as text.
fn text() -> String {
    let mut text = String::from("solid tetrahedron\n");
    for face in FACES {
        text.push_str("  facet normal 0 0 0\n    outer loop\n");
        for corner in face {
            let [x, y, z] = CORNERS[corner];
            text.extend(["      vertex ", &format!("{x:e} {y} {z}"), "\n"]);
        }
        text.push_str("    endloop\n  endfacet\n");
    }
    text + "endsolid tetrahedron\n"
}

fn stl(bytes: &[u8]) -> Result<Soup, MeshFileError> {
    read(Path::new("part.STL"), bytes)
}

fn obj(text: &str) -> Result<Soup, MeshFileError> {
    read(Path::new("part.obj"), text.as_bytes())
}

#[test]
fn one_body_is_the_same_in_every_form_of_stl() {
    let expected = stl(&binary(b"made by CAD")).expect("binary");
    assert_eq!((expected.vertices.len(), expected.triangles.len()), (4, 4));
    let text = text();
    let two_solids = text.replacen(
        "    endloop\n  endfacet\n  facet",
        "    endloop\n  endfacet\nendsolid\n\nsolid second part\n  facet",
        1,
    );
    for (what, bytes) in [
        (
            "a header that begins with solid",
            binary(b"solid part of CAD"),
        ),
        ("text", text.clone().into_bytes()),
        ("Windows lines", text.replace('\n', "\r\n").into_bytes()),
        ("large letters", text.to_uppercase().into_bytes()),
        (
            "no name",
            text.replace("solid tetrahedron", "solid").into_bytes(),
        ),
        (
            "normals that are no numbers",
            text.replace("normal 0 0 0", "normal nan nan nan")
                .into_bytes(),
        ),
        (
            "no end",
            text.replace("endsolid tetrahedron", "").into_bytes(),
        ),
        (
            "a name that is no UTF-8",
            [b"solid t\xe4trahedron\n", &text.as_bytes()[18..]].concat(),
        ),
        ("two solids", two_solids.into_bytes()),
    ] {
        assert_eq!(stl(&bytes).as_ref(), Ok(&expected), "{what}");
    }
}

#[test]
fn bytes_after_the_last_triangle_are_told_and_not_read() {
    let mut bytes = binary(b"");
    bytes.extend([7; 60]);
    let soup = stl(&bytes).expect("the rest is right");
    assert_eq!((soup.triangles.len(), soup.unread_bytes), (4, 60));
    let report = mend(&soup, Repair::Within(None)).expect("a body").report;
    assert!(report.warnings()[0].starts_with("60 bytes after the last triangle"));
}

#[test]
fn files_that_are_no_mesh_are_refused_with_the_cause() {
    let whole = binary(b"");
    let mut boundless = whole.clone();
    boundless[84 + 12..84 + 16].copy_from_slice(&f32::INFINITY.to_le_bytes());
    let mut many = whole.clone();
    many[80..84].copy_from_slice(&1_000_000_u32.to_le_bytes());
    let mut none = whole.clone();
    none[80..84].fill(0);
    for (bytes, expected) in [
        (
            &whole[..whole.len() - 1],
            "it says 4 triangles and holds 3: the file is cut off",
        ),
        (&many, "it says 1000000 triangles and holds 4"),
        (&none, "it holds no triangles"),
        (
            &boundless,
            "triangle 1 has a corner at (inf, 0, 0); expected finite",
        ),
        (
            b"<html>",
            "it has 6 bytes; a binary STL file has at least 84",
        ),
        (b"solid \nendsolid\n", "it holds no triangles"),
        (
            &text().as_bytes()[..200],
            "it cannot be read at triangle 2: ",
        ),
        (
            text().replacen("1e0", "one", 1).as_bytes(),
            "it cannot be read at triangle 1: invalid float",
        ),
    ] {
        let message = stl(bytes).expect_err(expected).to_string();
        assert!(message.starts_with(expected), "{message}");
    }
    let message = obj("v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n")
        .expect_err("nan")
        .to_string();
    assert!(
        message.starts_with("triangle 1 has a corner at (NaN, 1, 0)"),
        "{message}"
    );
    let message = obj("v 0 0 0\nv 1 0 0\nf 1 2 3\n")
        .expect_err("no third")
        .to_string();
    assert!(message.contains("out of bounds"), "{message}");
    let step = read(Path::new("part.step"), b"").expect_err("another format");
    assert_eq!(step, MeshFileError::UnknownFormat);
}

#[test]
fn an_obj_of_quads_groups_and_materials_is_cut_into_triangles() {
    let text = "mtllib missing.mtl\no first\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl steel\nf 1/1/1 2 3 4\n\
                g second\nv 0 0 1\nf -5 -4 -1\nl 1 2\n";
    let soup = obj(&text.replace("1/1/1", "1")).expect("an OBJ file");
    assert_eq!(soup.triangles.len(), 3);
    let mended = mend(&soup, Repair::Within(None)).expect("a sheet");
    assert_eq!(mended.report.vertices, 5);
    assert_eq!(mended.report.size, Vec3::repeat(1.0));
}

fn tetrahedron() -> Soup {
    stl(&binary(b"")).expect("binary")
}

#[test]
fn a_sound_body_is_left_as_it_is() {
    let soup = tetrahedron();
    let mended = mend(&soup, Repair::Within(None)).expect("a body");
    assert_eq!(mended.mesh.vertices(), soup.vertices);
    assert_eq!(mended.mesh.indices(), soup.triangles);
    assert!(mended.report.warnings().is_empty());
    assert_eq!(
        mended.report.summary(),
        ": 4 triangles, 1.0000 x 1.0000 x 1.0000 m"
    );
}

#[test]
fn what_is_wrong_is_counted_and_mended() {
    let mut soup = tetrahedron();
    // A corner that is there a second time, off by rounding; a triangle that is there a second time, turned over;
    // a line and a point; and a neighbor with its other side out.
    soup.vertices.push(Vec3::new(1.0e-7, 1.0, 0.0));
    soup.triangles[2] = [1, 4, 3];
    soup.triangles.push([3, 1, 0]);
    soup.triangles.push([0, 1, 1]);
    soup.vertices.push(Vec3::new(0.5, 0.0, 0.0));
    soup.triangles.push([0, 5, 1]);
    soup.triangles[3].swap(0, 1);
    let mended = mend(&soup, Repair::Within(None)).expect("a body");
    let report = &mended.report;
    assert_eq!(report.welded, 1);
    assert_eq!(report.duplicates, 1);
    assert_eq!(report.degenerate, 2);
    assert_eq!(report.flipped, 1);
    assert_eq!(report.triangles, 4);
    let told = "dropped 2 triangles without area; dropped 1 triangles there twice; welded 1 corners near others; \
                turned over 1 triangles against their neighbors";
    assert!(report.summary().ends_with(told), "{}", report.summary());
    let refused = mend(&soup, Repair::No).expect_err("a line");
    assert!(
        refused.to_string().contains("no more than a line"),
        "{refused}"
    );
}

#[test]
fn holes_are_counted_and_the_largest_is_placed() {
    let mut soup = tetrahedron();
    soup.triangles.remove(2);
    let far = soup.vertices.len() as u32;
    let more: Vec<Vec3> = soup
        .vertices
        .iter()
        .map(|at| at * 0.5 + Vec3::repeat(3.0))
        .collect();
    soup.vertices.extend(more);
    let copies: Vec<[u32; 3]> = soup
        .triangles
        .iter()
        .map(|t| t.map(|corner| corner + far))
        .collect();
    soup.triangles.extend(copies);
    let report = mend(&soup, Repair::Within(None)).expect("sheets").report;
    assert_eq!((report.open_edges, report.rims), (6, 2));
    let rim = report.largest_rim.expect("there are two");
    assert_eq!(rim.center, Vec3::repeat(0.5));
    assert_eq!(rim.size, 3.0_f64.sqrt());
    assert!(report.warnings()[0].starts_with("6 open edges in 2 lines; the largest is 1.7321 m"));
}

#[test]
fn sheets_that_meet_in_a_line_are_told() {
    let mut soup = tetrahedron();
    soup.vertices.push(Vec3::new(1.0, -1.0, 0.0));
    soup.triangles.push([0, 1, 4]);
    let report = mend(&soup, Repair::Within(None))
        .expect("a body with a fin")
        .report;
    assert_eq!(report.crowded_edges, 1);
    assert_eq!(report.open_edges, 2);
}
