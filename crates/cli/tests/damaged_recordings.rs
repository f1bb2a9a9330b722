//! Every command that reads a recording says what is wrong with one that is damaged, foreign or of a later version,
//! and reads one that is cut off as far as it is whole.

mod common;

use common::{Call, call};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The commands, each with its arguments after the recording.
const READERS: [(&str, &[&str]); 6] = [
    ("inspect", &[]),
    ("report", &["-o", "report.html"]),
    ("score", &["--strength", "20N"]),
    ("export", &["--format", "csv", "-o", "csv"]),
    ("export", &["--format", "parquet", "-o", "parquet"]),
    ("export", &["--format", "vtk", "-o", "vtk"]),
];

/// A recording of a short run.
fn recording() -> (TempDir, Vec<u8>) {
    let directory = TempDir::new().expect("a directory");
    good(directory.path(), &["new", "hopper"]);
    let text = fs::read_to_string(directory.path().join("hopper.toml")).expect("a template");
    let scene = text.split("[expect]").next().expect("the scene itself");
    fs::write(directory.path().join("hopper.toml"), scene).expect("writable");
    let mut run = vec!["run", "hopper.toml", "-o", "out", "-q"];
    for setting in ["time.end=0.2", "fill.bed.count=100"] {
        run.extend(["--set", setting]);
    }
    good(directory.path(), &run);
    let bytes = fs::read(directory.path().join("out/run.mcap")).expect("a recording");
    (directory, bytes)
}

fn good(directory: &Path, arguments: &[&str]) -> Call {
    let call = call(directory, arguments);
    assert_eq!(call.code, 0, "{arguments:?}: {}", call.error);
    call
}

fn read(directory: &Path, bytes: &[u8], (command, arguments): (&str, &[&str])) -> Call {
    fs::write(directory.join("it.mcap"), bytes).expect("writable");
    let all = [&[command, "it.mcap"], arguments].concat();
    let call = call(directory, &all);
    assert!(!call.error.contains("panicked"), "{all:?}: {}", call.error);
    call
}

/// Replaces a text in the bytes by one of the same length.
fn replaced(bytes: &[u8], text: &str, by: &str) -> Vec<u8> {
    assert_eq!(text.len(), by.len());
    let text = text.as_bytes();
    let at = bytes.windows(text.len()).position(|part| part == text);
    let at = at.expect("the text is in the file");
    let mut bytes = bytes.to_vec();
    bytes[at..at + text.len()].copy_from_slice(by.as_bytes());
    // The checksum of the data, after the opcode and the length of its record; 0 stands for none.
    let end = [0x0f, 4, 0, 0, 0, 0, 0, 0, 0];
    let at = bytes.windows(end.len()).rposition(|part| part == end);
    let at = at.expect("the data have an end") + end.len();
    bytes[at..at + 4].fill(0);
    bytes
}

#[test]
fn what_is_no_recording_of_this_version_is_bad_input_for_every_reader() {
    let (directory, whole) = recording();
    // The metadata holds the key and the value, each after its length of four bytes.
    let later = replaced(&whole, "format\u{1}\0\0\u{0}1", "format\u{1}\0\0\u{0}9");
    let foreign = replaced(&whole, "pelletflow.run", "somebodys.walk");
    let mut flipped = whole.clone();
    let middle = flipped.len() / 2;
    flipped[middle] ^= 0x10;
    let cases: [(&str, &[u8], &str); 5] = [
        (
            "a text",
            b"schema_version = 1, and more of a text file",
            "is not an MCAP file",
        ),
        ("nothing", b"", "is not an MCAP file"),
        ("a flipped bit", &flipped, "is damaged"),
        ("a later version", &later, "is a recording of format 9"),
        (
            "another program",
            &foreign,
            "is an MCAP file without `pelletflow.run`",
        ),
    ];
    for (what, bytes, expected) in cases {
        for reader in READERS {
            // Inspecting tells what a file holds, whoever wrote it.
            if reader.0 == "inspect" && ["a later version", "another program"].contains(&what) {
                assert_eq!(read(directory.path(), bytes, reader).code, 0, "{what}");
                continue;
            }
            let call = read(directory.path(), bytes, reader);
            assert!(
                call.error.contains(expected),
                "{reader:?} of {what}: {}",
                call.error
            );
            assert_eq!(call.code, 2, "{reader:?} of {what}");
        }
    }
}

#[test]
fn a_recording_cut_at_any_byte_is_read_as_far_as_it_is_whole_or_refused() {
    let (directory, whole) = recording();
    let mut readable = 0;
    // Some cuts in the head, the first chunk, the last one, the index and the end mark.
    let cuts = [
        9,
        40,
        200,
        700,
        whole.len() / 3,
        whole.len() / 2,
        whole.len() - 1500,
        whole.len() - 9,
    ];
    for cut in cuts {
        for reader in READERS {
            let call = read(directory.path(), &whole[..cut], reader);
            if call.code == 0 {
                readable += 1;
                let page = fs::read_to_string(directory.path().join("report.html"));
                let told = if reader.0 == "report" {
                    page.expect("a page")
                } else {
                    call.output
                };
                assert!(told.contains("cut off"), "{reader:?} at {cut}: {told}");
            } else {
                assert_eq!(call.code, 2, "{reader:?} at {cut}: {}", call.error);
                let is_said = ["cut off", "is not an MCAP file"]
                    .iter()
                    .any(|text| call.error.contains(text));
                assert!(is_said, "{reader:?} at {cut}: {}", call.error);
            }
        }
    }
    assert!(readable >= 4 * READERS.len(), "{readable} were readable");
}
