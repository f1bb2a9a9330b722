//! Bad inputs, each with what the program says of it and its exit code: one table, by area.
//!
//! A message names the place, the value, the bound and the cure; nothing is printed as a result, and nothing panics.

#[path = "../common/mod.rs"]
mod common;

mod arguments;
mod cards;
mod hits;
mod run_of_a_scene;
mod values_of_a_scene;
mod walls_of_a_scene;

use common::{call, program};
use std::fs;
use std::path::Path;
use std::process::Stdio;
use tempfile::TempDir;

/// A scene without mistakes.
const GOOD: &str = include_str!("good.toml");

/// A text of the good scene, what stands in its place, and the message after the name of the file.
type Spoiled = (&'static str, &'static str, &'static str);
/// Arguments, the exit code and a part of the message.
type Refused = (&'static str, i32, &'static str);

const SCENES: [&[Spoiled]; 3] = [
    values_of_a_scene::ROWS,
    walls_of_a_scene::ROWS,
    run_of_a_scene::ROWS,
];
const CALLS: [&[Refused]; 3] = [arguments::ROWS, hits::ROWS, cards::ROWS];

#[test]
fn every_mistake_in_a_scene_is_told_with_its_line_its_key_and_its_cure() {
    let directory = TempDir::new().expect("a directory");
    write(directory.path(), "good.toml", GOOD);
    assert_eq!(call(directory.path(), &["check", "good.toml"]).code, 0);
    let mut wrong = Vec::new();
    for (good, bad, message) in SCENES.into_iter().flatten() {
        assert!(GOOD.contains(good), "{good}");
        write(directory.path(), "scene.toml", &GOOD.replacen(good, bad, 1));
        let row = ("check scene.toml", 2, *message);
        wrong.extend(misread(directory.path(), &row).map(|told| format!("{bad}\n{told}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn every_wrong_argument_and_file_is_told_with_its_bound_and_its_cure() {
    let directory = TempDir::new().expect("a directory");
    write(directory.path(), "scene.toml", GOOD);
    for (name, text) in cards::FILES {
        write(directory.path(), name, text);
    }
    fs::write(directory.path().join("bytes.toml"), b"\xfe\xff\x00").expect("writable");
    let rows = CALLS.into_iter().flatten();
    let wrong: Vec<String> = rows
        .filter_map(|row| misread(directory.path(), row))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn the_table_has_two_hundred_rows_and_more_and_none_twice() {
    let scenes = SCENES.into_iter().flatten();
    let mut rows: Vec<[&str; 2]> = scenes.map(|(good, bad, _)| [*good, *bad]).collect();
    rows.extend(CALLS.into_iter().flatten().map(|(call, ..)| [*call, ""]));
    let count = rows.len();
    rows.sort_unstable();
    rows.dedup();
    assert_eq!(rows.len(), count);
    assert!(count >= 200, "{count}");
}

/// What is not as a row says; nothing where all is.
fn misread(directory: &Path, (arguments, code, message): &Refused) -> Option<String> {
    let words: Vec<&str> = arguments.split_whitespace().collect();
    let told = call(directory, &words);
    let is_right = told.code == *code
        && told.error.contains(message)
        && told.output.is_empty()
        && !told.error.contains("panicked");
    (!is_right).then(|| {
        format!(
            "`{arguments}` ended with {} in place of {code}, and\n{}{}in place of\n{message}",
            told.code, told.error, told.output
        )
    })
}

fn write(directory: &Path, name: &str, text: &str) {
    fs::write(directory.join(name), text).expect("a temporary directory can be written to");
}

#[test]
fn a_run_refuses_what_a_check_refuses() {
    let directory = TempDir::new().expect("a directory");
    write(
        directory.path(),
        "scene.toml",
        &GOOD.replace("count = 10", "count = 0"),
    );
    let [check, run] = ["check", "run"].map(|name| call(directory.path(), &[name, "scene.toml"]));
    assert_eq!((run.code, &run.error), (2, &check.error));
    assert!(!directory.path().join("out").exists());
}

#[test]
fn every_mistake_is_listed_and_counted() {
    let directory = TempDir::new().expect("a directory");
    let bad = GOOD.replace("density = 7850", "density = -1\nshade = 2");
    write(directory.path(), "scene.toml", &bad);
    let error = call(directory.path(), &["check", "scene.toml"]).error;
    for expected in ["materials.steel.density: ", "materials.steel.shade: "] {
        assert!(error.contains(expected), "{error}");
    }
    assert!(error.ends_with("2 mistakes\n"), "{error}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_cannot_be_read_is_a_failure_to_read() {
    // Reading a process's memory from its start fails for everyone, permissions or not.
    let call = call(Path::new("/"), &["check", "/proc/self/mem"]);
    let expected = "/proc/self/mem: cannot be read: ";
    assert!(call.error.contains(expected), "{}", call.error);
    assert_eq!(call.code, 4);
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
