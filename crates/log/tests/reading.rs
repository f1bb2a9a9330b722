//! Recordings read back: whole, cut off, and not recordings at all.

mod common;

use common::record;
use pelletflow_log::{ReadError, inspect, read_attachment, read_frames};
use std::fs;

#[test]
fn an_inspection_tells_what_a_recording_holds() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let summary = record(directory.path(), 0.05);
    let inspection = inspect(directory.path().join("run.mcap")).expect("the recording opens");
    assert_eq!(inspection.frames, 6);
    assert_eq!(inspection.compression.as_deref(), Some("zstd"));
    assert!(
        inspection
            .compression_ratio
            .is_some_and(|ratio| ratio > 1.0)
    );
    assert!(!inspection.is_cut_off);
    let run = &inspection.metadata["pelletflow.run"];
    assert_eq!(run["scene_hash"], summary.scene_hash);
    assert_eq!(run["step_reason"], summary.time.step_reason);
    let pellets = inspection
        .channels
        .iter()
        .find(|channel| channel.topic == "/pellets")
        .expect("frames are recorded");
    assert_eq!(pellets.schema, "foxglove.PointCloud");
    assert_eq!(pellets.encoding, "protobuf");
    assert_eq!(pellets.first_s, Some(0.0));
    let names: Vec<_> = inspection
        .attachments
        .iter()
        .map(|attachment| attachment.name.as_str())
        .collect();
    assert_eq!(names, ["scene.toml", "layout.json"]);
    // Half a step, and log times are whole nanoseconds.
    assert!((inspection.duration_s - 0.05).abs() <= summary.time.step_s / 2.0 + 1.0e-9);
}

#[test]
fn a_recording_cut_off_anywhere_opens_up_to_its_last_whole_chunk() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.05);
    let whole = fs::read(directory.path().join("run.mcap")).expect("a run leaves a recording");
    let cut = directory.path().join("cut.mcap");
    let mut most_frames = 0;
    for share in 1..10 {
        fs::write(&cut, &whole[..whole.len() * share / 10]).expect("a file can be written");
        let inspection = inspect(&cut).expect("a cut recording opens");
        assert!(inspection.is_cut_off, "{share}0 %");
        let frames: Result<Vec<_>, _> = read_frames(&cut).expect("it opens").collect();
        let frames = frames.expect("frames before the cut can be read");
        assert_eq!(frames.len() as u64, inspection.frames);
        assert!(
            frames.len() as u64 >= most_frames,
            "more file, not fewer frames"
        );
        most_frames = inspection.frames;
    }
    assert!(most_frames >= 1, "the beginning is a chunk of its own");
}

#[test]
fn a_flipped_bit_is_found() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.05);
    let path = directory.path().join("run.mcap");
    let mut bytes = fs::read(&path).expect("a run leaves a recording");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 0x10;
    fs::write(&path, &bytes).expect("a file can be written");
    assert!(matches!(inspect(&path), Err(ReadError::Damaged { .. })));
}

#[test]
fn what_is_no_recording_is_refused_by_its_own_error() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let missing = directory.path().join("nowhere.mcap");
    assert!(matches!(inspect(&missing), Err(ReadError::Missing { .. })));
    assert!(matches!(
        inspect(directory.path()),
        Err(ReadError::Directory { .. })
    ));
    let other = directory.path().join("other.mcap");
    for content in ["", "x", "schema_version = 1, and more of a text file"] {
        fs::write(&other, content).expect("a file can be written");
        assert!(
            matches!(inspect(&other), Err(ReadError::NotMcap { .. })),
            "{content:?}"
        );
    }
}

#[test]
fn a_missing_attachment_is_named() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.01);
    let error = read_attachment(directory.path().join("run.mcap"), "cards.toml")
        .expect_err("there are no cards");
    assert!(error.to_string().contains("cards.toml"));
}
