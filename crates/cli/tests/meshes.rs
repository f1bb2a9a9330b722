//! Meshes from files: read beside the scene, told of, copied beside the results, and refused with their cause.

mod common;

use common::call;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A pellet above a tray of triangles, made in millimeters.
const SCENE: &str = r#"schema_version = 1

[materials.pellet]
density = "3700 kg/m3"
shear_modulus = "60 MPa"
poisson_ratio = 0.22

[materials.steel]
density = "7850 kg/m3"
shear_modulus = "81 GPa"
poisson_ratio = 0.28

[pairs."pellet-pellet"]
restitution = 0.5
friction = 0.5

[pairs."pellet-steel"]
restitution = 0.5
friction = 0.5

[pellets.ore]
material = "pellet"
diameter = "15 mm"

[walls.tray]
material = "steel"
mesh = { file = "parts/tray.stl", unit = "mm", translate = [0, 0, "-10 mm"] }

[fill.drop]
pellets = "ore"
at = [[0.1, 0.1, -0.002]]

[time]
end = "20 ms"
"#;

/// A tray of 200 x 200 x 80 mm without a lid as an STL text, every side cut in two.
fn tray() -> String {
    let corner = |index: usize| {
        let side = |axis: usize, length: f64| if index >> axis & 1 == 0 { 0.0 } else { length };
        [side(0, 200.0), side(1, 200.0), side(2, 80.0)]
    };
    let sides = [
        [0, 2, 3, 1],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let mut text = String::from("solid tray\n");
    for [a, b, c, d] in sides {
        for triangle in [[a, b, c], [a, c, d]] {
            text.push_str("facet normal 0 0 0\nouter loop\n");
            for at in triangle.map(corner) {
                text.extend(["vertex ", &at.map(|x| x.to_string()).join(" "), "\n"]);
            }
            text.push_str("endloop\nendfacet\n");
        }
    }
    text + "endsolid tray\n"
}

/// The tray with a lid.
fn chest() -> String {
    let mut text = tray();
    for corners in [
        [[0, 0], [200, 0], [200, 200]],
        [[0, 0], [200, 200], [0, 200]],
    ] {
        let at = corners
            .map(|[x, y]| format!("vertex {x} {y} 80\n"))
            .concat();
        let facet = format!("facet normal 0 0 0\nouter loop\n{at}endloop\nendfacet\nendsolid");
        text = text.replacen("endsolid", &facet, 1);
    }
    text
}

/// A directory with a scene and its mesh.
fn directory(scene: &str, mesh: &[u8]) -> TempDir {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    fs::create_dir_all(path.join("plant/parts")).expect("writable");
    fs::write(path.join("plant/scene.toml"), scene).expect("writable");
    fs::write(path.join("plant/parts/tray.stl"), mesh).expect("writable");
    directory
}

fn json(directory: &Path, arguments: &[&str]) -> Value {
    let call = call(directory, arguments);
    assert_eq!(call.code, 0, "{}", call.error);
    serde_json::from_str(&call.output).expect("JSON")
}

const CHECK: &[&str] = &["check", "plant/scene.toml", "--json"];

#[test]
fn check_tells_what_a_mesh_is_and_where_it_is_open() {
    let directory = directory(SCENE, tray().as_bytes());
    let check = json(directory.path(), CHECK);
    let mesh = &check["meshes"][0];
    assert_eq!(mesh["triangles"], 10);
    assert_eq!(mesh["open_edges"], 4);
    assert_eq!(mesh["rims"], 1);
    let top = mesh["largest_rim"]["center_m"][2]
        .as_f64()
        .expect("a number");
    // Single precision of 80 mm.
    assert!((top - 0.07).abs() < 1.0e-8, "{top}");
    let page = call(directory.path(), &CHECK[..2]).output;
    assert!(
        page.contains("parts/tray.stl: 10 triangles, 0.2000 x 0.2000 x 0.0800 m"),
        "{page}"
    );
    assert!(
        page.contains("4 open edges in 1 line; the largest is 0.2828 m across"),
        "{page}"
    );
}

#[test]
fn a_run_lays_the_mesh_beside_its_scene_which_then_runs_again_as_the_same_scene() {
    let inside = directory(SCENE, tray().as_bytes());
    let first = json(
        inside.path(),
        &["run", "plant/scene.toml", "-o", "out", "--json", "--quiet"],
    );
    let copy = fs::read(inside.path().join("out/parts/tray.stl")).expect("a copy");
    assert_eq!(copy, tray().as_bytes());
    fs::remove_dir_all(inside.path().join("plant")).expect("removable");
    let again = json(
        inside.path(),
        &["run", "out/scene.toml", "-o", "again", "--json", "--quiet"],
    );
    assert_eq!(first["scene_hash"], again["scene_hash"]);
    assert_eq!(first["contacts"], again["contacts"]);
    assert!(
        first["contacts"]["max_force_n"].as_f64() > Some(0.0),
        "it has hit the tray"
    );

    // From elsewhere, it comes under a name of its own.
    let outside = directory(&SCENE.replace("parts/", "../elsewhere/"), b"");
    fs::create_dir(outside.path().join("elsewhere")).expect("writable");
    fs::write(outside.path().join("elsewhere/tray.stl"), tray()).expect("writable");
    let first = json(
        outside.path(),
        &["run", "plant/scene.toml", "-o", "out", "--json", "--quiet"],
    );
    assert!(outside.path().join("out/tray-tray.stl").is_file());
    fs::remove_dir_all(outside.path().join("elsewhere")).expect("removable");
    let again = json(outside.path(), &["check", "out/scene.toml", "--json"]);
    assert_eq!(first["scene_hash"], again["scene_hash"]);
}

#[test]
fn another_mesh_makes_another_scene() {
    let directory = directory(SCENE, tray().as_bytes());
    let hash = json(directory.path(), CHECK)["scene_hash"].clone();
    let higher = tray().replace(" 80", " 81");
    fs::write(directory.path().join("plant/parts/tray.stl"), higher).expect("writable");
    assert_ne!(json(directory.path(), CHECK)["scene_hash"], hash);
}

fn refused(scene: &str, mesh: &[u8], expected: &str) {
    let directory = directory(scene, mesh);
    let call = call(directory.path(), &CHECK[..2]);
    assert!(call.error.contains(expected), "{expected}:\n{}", call.error);
    assert_eq!(call.code, 2, "{}", call.error);
}

#[test]
fn bad_mesh_files_are_bad_input_with_file_place_and_cure() {
    let tray = tray();
    let key = "plant/scene.toml:27: walls.tray.mesh.file: `file` is \"parts/tray.stl\": ";
    for (mesh, expected) in [
        (
            tray.replacen("0 0 0\n", "nan 0 0\n", 2).as_bytes(),
            "it cannot be read at triangle 1: ",
        ),
        (
            &tray.as_bytes()[..300],
            "it cannot be read at triangle 4: EOF while expecting",
        ),
        (b"solid tray\nendsolid tray\n", "it holds no triangles"),
        (&[0; 84], "it holds no triangles"),
        (
            &[1; 200],
            "it says 16843009 triangles and holds 2: the file is cut off",
        ),
        (b"", "it has 0 bytes"),
    ] {
        refused(SCENE, mesh, &format!("{key}{expected}"));
    }
    let missing = SCENE.replace("tray.stl", "try.stl");
    refused(
        &missing,
        b"",
        "`file` is \"parts/try.stl\": there is no such file at plant/parts/try.stl; expected",
    );
    refused(
        &SCENE.replace("/tray.stl", ""),
        b"",
        "`file` is \"parts\": this is a directory",
    );
    refused(
        &SCENE.replace("tray.stl", "tray.step"),
        b"",
        "there is no such file",
    );
}

#[test]
fn a_mistaken_unit_is_named_with_the_size_and_the_cure() {
    let tray = tray();
    let meters = SCENE.replace("unit = \"mm\", ", "");

    refused(
        &meters.replace("translate", "scale = 15, translate"),
        tray.as_bytes(),
        "walls.tray.mesh: the mesh is 3000 m long with its numbers taken for m; expected at most 200 m: most CAD writes millimeters, \
         add `unit = \"mm\"`",
    );
    refused(
        &meters.replace("translate", "scale = 0.0001, translate"),
        tray.as_bytes(),
        "the mesh is 0.02 m long with its numbers taken for m, less than 5 of the smallest pellets of 0.015 m; tell its unit",
    );
    refused(
        &SCENE.replace("unit = \"mm\"", "unit = \"yd\""),
        tray.as_bytes(),
        "unknown unit `yd`",
    );
}

#[test]
fn a_wall_is_a_shape_or_a_mesh_and_not_both() {
    let shape = "shape = { kind = \"sphere\", center = [0, 0, 0], radius = 1 }\n";
    let tray = tray();
    refused(
        &SCENE.replace("mesh = {", &format!("{shape}mesh = {{")),
        tray.as_bytes(),
        "`shape` and `mesh` are both given",
    );
    let neither = SCENE
        .lines()
        .filter(|line| !line.starts_with("mesh"))
        .collect::<Vec<_>>()
        .join("\n");
    refused(&neither, tray.as_bytes(), "missing `shape` or `mesh`");
}

#[test]
fn check_walls_drops_a_pellet_onto_faces_edges_tips_and_corners() {
    let solid = "[walls.block]\nmaterial = \"steel\"\nshape = { kind = \"box\", center = [0.5, 0.5, 0.5], size = [0.1, 0.2, 0.1] }\n";
    let directory = directory(
        &SCENE.replace("[fill", &format!("{solid}\n[fill")),
        tray().as_bytes(),
    );
    let check = json(
        directory.path(),
        &["check", "plant/scene.toml", "--walls", "--json"],
    );
    for (wall, spots) in [
        (0, ["face", "edge", "tip", "corner"].as_slice()),
        (1, &["face", "edge", "tip"]),
    ] {
        for spot in spots {
            let hit = &check["walls"][wall][spot];
            // The step is chosen for 0.1 %.
            let error = hit["force_error"].as_f64().expect(spot);
            assert!(error.abs() < 2.0e-3, "{wall} {spot}: {hit}");
            let rebound = hit["rebound"].as_f64().expect(spot);
            assert!((rebound - 1.0).abs() < 5.0e-3, "{wall} {spot}: {hit}");
        }
    }
    assert!(check["walls"][1]["corner"].is_null());
    let page = call(directory.path(), &["check", "plant/scene.toml", "--walls"]).output;
    let row = page
        .lines()
        .find(|line| line.contains("block") && line.contains("corner"));
    assert!(row.is_some_and(|row| row.contains(" - ")), "{page}");
}

#[test]
fn check_states_the_error_of_a_baked_mesh_and_warns_where_it_is_too_large() {
    let bake = |spacing: &str| SCENE.replace("unit", &format!("bake = \"{spacing}\", unit"));
    let inside = directory(&bake("2 mm"), chest().as_bytes());
    let check = json(inside.path(), CHECK);
    let baked = &check["meshes"][0]["bake"];
    let number = |key: &str| baked[key].as_f64().expect("a number");
    assert_eq!(number("spacing_m"), 0.002);
    // Half of the diagonal of a cell is the most that interpolation can be off.
    assert!(number("greatest_deviation_m") < 0.87 * 0.002, "{baked}");
    let share = number("greatest_deviation_m") / 0.0075;
    assert!((number("greatest_deviation_share") - share).abs() < 1.0e-12);
    assert!(share > 0.01, "its edges are rounded: {baked}");
    assert!(number("likely_spacing_m") < 0.0005, "{baked}");
    let page = call(inside.path(), &CHECK[..2]).output;
    assert!(page.contains("cells of 2 mm, "), "{page}");
    assert!(
        page.contains("expected at most 1 %: edges are rounded by a cell; leave `bake` out"),
        "{page}"
    );

    let plain = directory(SCENE, chest().as_bytes());
    assert!(json(plain.path(), CHECK)["meshes"][0]["bake"].is_null());
}

#[test]
fn a_baked_chest_is_hit_as_its_triangles_are() {
    let run = |scene: &str| {
        let directory = directory(scene, chest().as_bytes());
        json(
            directory.path(),
            &["run", "plant/scene.toml", "-o", "out", "--json", "--quiet"],
        )["contacts"]["max_force_n"]
            .as_f64()
            .expect("a number")
    };
    let (triangles, baked) = (
        run(SCENE),
        run(&SCENE.replace("unit", "bake = \"2 mm\", unit")),
    );
    // Single precision of 80 mm against an overlap of some micrometers.
    assert!(
        (baked / triangles - 1.0).abs() < 1.0e-3,
        "{baked} {triangles}"
    );
}

#[test]
fn an_open_mesh_is_not_baked_and_the_cure_is_named() {
    refused(
        &SCENE.replace("unit", "bake = \"2 mm\", unit"),
        tray().as_bytes(),
        "walls.tray.mesh.bake: `bake` is 0.002 m: the mesh is open along 4 edges, one about (",
    );
    refused(
        &SCENE.replace("unit", "bake = \"2 mm\", unit"),
        tray().as_bytes(),
        "expected a closed surface with one side out: close it in CAD, or leave `bake` out",
    );
    refused(
        &SCENE.replace("unit", "bake = \"0.01 mm\", unit"),
        chest().as_bytes(),
        "in cells of 0.00001 m; expected at most 2.0 GB: take a longer `bake`, or leave it out",
    );
}
