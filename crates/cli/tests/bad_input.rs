//! Bad input is told apart, named with its place and its cure, and never panics.

mod common;

use common::{Call, call, program};
use std::fs;
use std::path::Path;
use std::process::Stdio;
use tempfile::TempDir;

/// A template in a directory of its own, with one text replaced.
fn spoiled(good: &str, bad: &str) -> TempDir {
    let directory = TempDir::new().expect("a directory");
    let drop = call(directory.path(), &["new", "drop", "-o", "-"]).output;
    assert!(drop.contains(good), "{good}");
    let scene = drop.replacen(good, bad, 1);
    fs::write(directory.path().join("scene.toml"), scene).expect("writable");
    directory
}

fn check_fails(directory: &Path, code: i32, expected: &str) {
    for command in ["check", "run"] {
        let Call {
            code: found,
            output,
            error,
        } = call(directory, &[command, "scene.toml"]);
        assert!(error.contains(expected), "{command}: {error}");
        assert_eq!(found, code, "{command}: {error}");
        assert_eq!(output, "", "{command}");
        assert!(!error.contains("panicked"), "{command}: {error}");
    }
}

/// What of the template is replaced, by what, and a part of the message.
#[rustfmt::skip]
const CASES: &[(&str, &str, &str)] = &[
    ("density = \"3700 kg/m3\"", "densty = \"3700 kg/m3\"", "unknown key `densty`; did you mean `density`?"),
    ("density = \"3700 kg/m3\"", "density = \"-3700 kg/m3\"", "`density` is \"-3700 kg/m3\"; expected more than 0 kg/m3"),
    ("density = \"3700 kg/m3\"", "density = nan", "`density` is nan; expected a finite number"),
    ("density = \"3700 kg/m3\"", "density = 1e300", "`density` is 1e300; expected more than 0 kg/m3 and at most"),
    ("density = \"3700 kg/m3\"", "density = 1\ndensity = 2", "scene.toml:15:1: this is not TOML: duplicate key"),
    ("poisson_ratio = 0.22", "poisson_ratio = 0.7", "`poisson_ratio` is 0.7; expected more than -1 and less than 0.5"),
    ("[pairs.\"pellet-steel\"]", "[pairs.\"steel-steel\"]", "missing pair: `pellet` and `steel` can meet; add"),
    ("diameter = \"15 mm\"", "diameter = \"15 kg\"", "`diameter` is a length; `15 kg` is a mass; write for example \"15 mm\""),
    ("at = [[0, 0, 1.0075]]", "region = { kind = \"box\", min = [0, 0, 0], max = [1, 1, 1] }\ncount = 1_000_000_000", "expected at most 5e6"),
    ("at = [[0, 0, 1.0075]]", "region = { kind = \"box\", center = [0, 0, 1], size = [0.1, 0.1, 0.1] }\ncount = 100_000", "scene.toml:"),
    ("[output]", "[meters.load]\nkind = \"wall-force\"\nwall = \"flo0r\"\n[output]", "unknown wall `flo0r`; did you mean `floor`?"),
    ("[output]", "[inlets.feed]\npellets = \"ore\"\nrate = 1\nregion = { kind = \"box\", center = [0, 0, -1], size = [0.1, 0.1, 0.1] }\n[output]", "no free place for the largest pellet, of 0.015 m: wall `floor` takes it up; move the region or the wall"),
    ("[output]", "[domain]\nmin = [-1, -1, 0]\nmax = [1, 1, 1]\n[output]", "fill.pellet.at: reaches to z = 1.0075 m, outside of the domain, which goes from 0 m to 1 m along z"),
    ("[output]", "[domain]\nmin = [-1, -1, 0]\nmax = [1, 1, 2]\n[outlets.below]\nregion = { kind = \"half-space\", point = [0, 0, -1], normal = [0, 0, 1] }\n[output]", "outlets.below.region: the outlet lies outside of the domain"),
    ("[output]", "[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 2]\nperiodic = [\"z\"]\n[output]", "walls.floor.shape: the wall is not the same on both borders of the periodic axis z"),
    ("schema_version = 1\n", "", "`schema_version` is missing; write `schema_version = 1`"),
    ("schema_version = 1\n", "schema_version = 7\n", "`schema_version` is 7; expected 1"),
    ("schema_version = 1\n", "schema version\n", "scene.toml:7:8: this is not TOML"),
];

#[test]
fn mistakes_in_a_scene_are_bad_input_with_line_and_cure() {
    for (good, bad, expected) in CASES {
        let directory = spoiled(good, bad);
        check_fails(directory.path(), 2, expected);
    }
}

#[test]
fn an_empty_scene_and_other_bytes_are_bad_input() {
    let directory = TempDir::new().expect("a directory");
    let scene = directory.path().join("scene.toml");
    fs::write(&scene, "").expect("writable");
    check_fails(
        directory.path(),
        2,
        "the scene is empty; `pelletflow new hopper`",
    );
    fs::write(&scene, b"\xfe\xff\x00").expect("writable");
    check_fails(directory.path(), 2, "scene.toml:1: byte 0 is not UTF-8");
}

#[test]
fn a_missing_file_and_a_directory_are_bad_input() {
    let directory = TempDir::new().expect("a directory");
    check_fails(directory.path(), 2, "scene.toml: there is no such file");
    fs::create_dir(directory.path().join("scene.toml")).expect("writable");
    check_fails(directory.path(), 2, "scene.toml: this is a directory");
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_cannot_be_read_is_a_failure_to_read() {
    // Reading a process's memory from its start fails for everyone, permissions or not.
    let call = call(Path::new("/"), &["check", "/proc/self/mem"]);
    assert!(
        call.error.contains("/proc/self/mem: cannot be read: "),
        "{}",
        call.error
    );
    assert_eq!(call.code, 4);
}

#[test]
fn results_that_cannot_be_written_are_a_failure_to_write() {
    let directory = spoiled("[output]", "[output]");
    fs::write(directory.path().join("taken"), "").expect("writable");
    let call = call(directory.path(), &["run", "scene.toml", "-o", "taken/here"]);
    assert!(call.error.contains("taken/here"), "{}", call.error);
    assert_eq!(call.code, 4, "{}", call.error);
}

#[test]
fn every_mistake_is_listed_and_counted() {
    let directory = spoiled("density = \"3700 kg/m3\"", "density = -1\nshade = 2");
    let call = call(directory.path(), &["check", "scene.toml"]);
    assert!(
        call.error.contains("materials.pellet.density: "),
        "{}",
        call.error
    );
    assert!(
        call.error.contains("materials.pellet.shade: "),
        "{}",
        call.error
    );
    assert!(call.error.ends_with("2 mistakes\n"), "{}", call.error);
}

#[test]
fn a_wrong_override_is_bad_input_and_named_as_such() {
    let directory = spoiled("[output]", "[output]");
    for (set, expected) in [
        ("pellets.ore.diameter=15 kg", "--set pellets.ore.diameter: "),
        ("pellets.ore.diametre=1", "did you mean `diameter`?"),
        ("pellets.ore.diameter", "has no `=`; write KEY=VALUE"),
        ("=1", "is not a dotted key"),
    ] {
        let call = call(directory.path(), &["check", "scene.toml", "--set", set]);
        assert!(call.error.contains(expected), "{set}: {}", call.error);
        assert_eq!(call.code, 2, "{set}");
    }
}

#[test]
fn wrong_usage_is_bad_input() {
    let directory = spoiled("[output]", "[output]");
    for (arguments, expected) in [
        (&["rnu"][..], "unrecognized subcommand 'rnu'"),
        (&["run"], "<SCENE>"),
        (
            &["run", "scene.toml", "--threads", "0"],
            "leave --threads out for all cores",
        ),
        (
            &["run", "scene.toml", "--threads", "many"],
            "leave --threads out for all cores",
        ),
        (&["new", "hoper"], "hopper"),
        (&["completions", "basic"], "bash"),
        (&[], "Usage"),
    ] {
        let call = call(directory.path(), arguments);
        assert!(
            call.error.contains(expected),
            "{arguments:?}: {}",
            call.error
        );
        assert_eq!(call.code, 2, "{arguments:?}");
    }
}

#[test]
fn a_recording_that_is_none_is_bad_input() {
    let directory = spoiled("[output]", "[output]");
    for (file, expected) in [
        ("scene.toml", "is not an MCAP file"),
        ("missing.mcap", "does not exist"),
        (".", "is a directory"),
    ] {
        let call = call(directory.path(), &["inspect", file]);
        assert!(call.error.contains(expected), "{file}: {}", call.error);
        assert_eq!(call.code, 2, "{file}");
    }
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let directory = TempDir::new().expect("a directory");
    for arguments in [&["schema"][..], &["completions", "bash"], &["--help"]] {
        let mut child = program(directory.path())
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("the program ends");
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(!error.contains("panicked"), "{arguments:?}: {error}");
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {error}");
    }
}
