//! `pelletflow export` writes what the recording holds, for other programs.

mod common;

use common::{Call, call};
use pelletflow_log::{TableKind, read_frames, read_hits, read_tables};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

fn recording() -> TempDir {
    let directory = TempDir::new().expect("a directory");
    good(directory.path(), &["new", "hopper"]);
    let text = fs::read_to_string(directory.path().join("hopper.toml")).expect("a template");
    let scene = text.split("[expect]").next().expect("the scene itself");
    fs::write(directory.path().join("hopper.toml"), scene).expect("writable");
    let mut run = vec!["run", "hopper.toml", "-o", "out", "-q"];
    for setting in ["time.end=0.2", "fill.bed.count=100", "output.contacts=true"] {
        run.extend(["--set", setting]);
    }
    good(directory.path(), &run);
    directory
}

fn good(directory: &Path, arguments: &[&str]) -> Call {
    let call = call(directory, arguments);
    assert_eq!(call.code, 0, "{arguments:?}: {}", call.error);
    call
}

fn export(directory: &Path, format: &str) -> Call {
    let arguments = ["export", "out/run.mcap", "--format", format, "-o", format];
    good(directory, &arguments)
}

#[test]
fn a_spreadsheet_holds_every_pellet_of_every_frame_to_the_last_digit() {
    let directory = recording();
    let told = export(directory.path(), "csv");
    assert!(told.output.contains("bodies.csv"), "{}", told.output);
    let text = fs::read_to_string(directory.path().join("csv/bodies.csv")).expect("a table");
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some("time_s,id,x_m,y_m,z_m,radius_m,speed_m_per_s,force_n")
    );
    for frame in read_frames(directory.path().join("out/run.mcap")).expect("it opens") {
        let frame = frame.expect("it is whole");
        for pellet in frame.pellets {
            let cells: Vec<&str> = lines.next().expect("a row").split(',').collect();
            assert_eq!(cells[0].parse(), Ok(frame.time));
            assert_eq!(cells[1].parse(), Ok(pellet.id));
            assert_eq!(cells[4].parse(), Ok(pellet.position[2]));
            assert_eq!(cells[7].parse(), Ok(pellet.force));
        }
    }
    assert_eq!(lines.next(), None);
    let hits = fs::read_to_string(directory.path().join("csv/hits.csv")).expect("a table");
    let recorded = read_hits(directory.path().join("out/run.mcap")).expect("hits");
    assert_eq!(hits.lines().count(), 1 + recorded.hits.len());
    for name in [
        "mass_ledger",
        "energy_ledger",
        "hit_classes",
        "events",
        "meters/discharge",
    ] {
        let path = directory.path().join(format!("csv/{name}.csv"));
        assert!(path.is_file(), "{}", path.display());
    }
}

#[test]
fn contacts_that_were_asked_for_are_a_table_and_others_are_none() {
    let directory = recording();
    export(directory.path(), "csv");
    let text = fs::read_to_string(directory.path().join("csv/contacts.csv")).expect("a table");
    let mut lines = text.lines();
    let names = "time_s,pellet,partner,wall,x_m,y_m,z_m,normal_force_n,force_x_n,force_y_n,force_z_n,overlap_m";
    assert_eq!(lines.next(), Some(names));
    let mut rows = 0;
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        // Either another pellet or a wall.
        assert!(cells[2].is_empty() != cells[3].is_empty(), "{line}");
        rows += 1;
    }
    let read = read_tables(
        directory.path().join("out/run.mcap"),
        &[TableKind::Contacts],
    );
    let read = read.expect("it opens");
    assert_eq!(read.tables[0].rows(), rows);
    assert!(rows > 0, "pellets lie on the cone");

    let run = [
        "run",
        "hopper.toml",
        "-o",
        "plain",
        "-q",
        "--set",
        "time.end=0.01",
    ];
    good(directory.path(), &run);
    let arguments = [
        "export",
        "plain/run.mcap",
        "--format",
        "csv",
        "-o",
        "plain-csv",
    ];
    good(directory.path(), &arguments);
    assert!(directory.path().join("plain-csv/bodies.csv").is_file());
    assert!(!directory.path().join("plain-csv/contacts.csv").exists());
}

#[test]
fn parquet_files_begin_and_end_as_such() {
    let directory = recording();
    export(directory.path(), "parquet");
    for name in ["bodies", "contacts", "hits", "meters/discharge"] {
        let path = directory.path().join(format!("parquet/{name}.parquet"));
        let bytes = fs::read(path).expect("a table");
        assert!(
            bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"),
            "{name}"
        );
    }
}

#[test]
fn a_collection_names_files_that_are_there_for_every_frame() {
    let directory = recording();
    let told = export(directory.path(), "vtk");
    let folder = directory.path().join("vtk");
    let frames = read_frames(directory.path().join("out/run.mcap")).expect("it opens");
    let frames = frames.count();
    assert!(
        told.output.contains(&format!("{frames} frames")),
        "{}",
        told.output
    );
    for (list, least) in [
        ("pellets.pvd", frames),
        ("walls.pvd", frames),
        // Before the first step nothing is known of contacts.
        ("contacts.pvd", frames - 1),
    ] {
        let text = fs::read_to_string(folder.join(list)).expect("a list");
        let files: Vec<&str> = text
            .split("file=\"")
            .skip(1)
            .filter_map(|rest| rest.split('"').next())
            .collect();
        assert!(files.len() >= least, "{list}");
        for file in files {
            assert!(folder.join(file).is_file(), "{file}");
        }
    }
}

#[test]
fn an_export_that_has_no_place_is_refused_with_the_cure() {
    let directory = recording();
    fs::write(directory.path().join("taken"), "").expect("writable");
    for (arguments, code, expected) in [
        (["--format", "csv", "-o", "taken"], 2, "name a directory"),
        (
            ["--format", "csv", "-o", "taken/in"],
            4,
            "cannot write taken/in",
        ),
        (
            ["--format", "xls", "-o", "x"],
            2,
            "possible values: vtk, csv, parquet",
        ),
    ] {
        let arguments = [&["export", "out/run.mcap"][..], &arguments].concat();
        let call = call(directory.path(), &arguments);
        assert!(
            call.error.contains(expected),
            "{arguments:?}: {}",
            call.error
        );
        assert_eq!(call.code, code, "{arguments:?}");
    }
}
