//! `pelletflow score` and `inspect --worst` tell what a recording holds of hits, and refuse what holds none.

mod common;

use common::{Call, call};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A recording of the hopper's first tenth of a second, in which its bed lands on the gate.
fn recording(settings: &[&str]) -> TempDir {
    let directory = TempDir::new().expect("a directory");
    good(directory.path(), &["new", "hopper"]);
    let text = fs::read_to_string(directory.path().join("hopper.toml")).expect("a template");
    let scene = text.split("[expect]").next().expect("the scene itself");
    fs::write(directory.path().join("hopper.toml"), scene).expect("writable");
    let mut arguments = vec!["run", "hopper.toml", "-o", "out", "-q"];
    for setting in ["time.end=0.25", "fill.bed.count=150"]
        .iter()
        .chain(settings)
    {
        arguments.extend(["--set", setting]);
    }
    good(directory.path(), &arguments);
    directory
}

fn good(directory: &Path, arguments: &[&str]) -> Call {
    let call = call(directory, arguments);
    assert_eq!(call.code, 0, "{arguments:?}: {}", call.error);
    call
}

fn score(directory: &Path, strength: &str) -> Value {
    let arguments = ["score", "out/run.mcap", "--strength", strength, "--json"];
    serde_json::from_str(&good(directory, &arguments).output).expect("JSON")
}

fn share(value: &Value) -> f64 {
    value["share"].as_f64().expect("a share")
}

#[test]
fn every_grouping_adds_up_to_the_same_share_and_a_weaker_pellet_breaks_more() {
    let directory = recording(&[]);
    let directory = directory.path();
    let worst = ["inspect", "out/run.mcap", "--worst", "3", "--json"];
    let worst: Value = serde_json::from_str(&good(directory, &worst).output).expect("JSON");
    let hardest = worst[0]["peak_force_n"].as_f64().expect("a force");
    assert!(hardest > 10.0, "{worst}");
    assert!(hardest >= worst[2]["peak_force_n"].as_f64().expect("a force"));
    let mut last = 1.1;
    for load in [
        0.05 * hardest,
        0.5 * hardest,
        0.99 * hardest,
        1.01 * hardest,
    ] {
        let score = score(directory, &format!("{load} N"));
        let total = share(&score["broken"]);
        assert!(total < last, "{load}: {total}");
        for grouping in ["by_cause", "by_wall", "by_size"] {
            let groups = score[grouping].as_array().expect("groups");
            let sum: f64 = groups.iter().map(share).sum();
            assert!(
                (sum - total).abs() < 1.0e-12,
                "{grouping}: {sum} of {total}"
            );
        }
        last = total;
    }
    assert_eq!(last, 0.0, "no pellet feels more than the hardest hit");
}

#[test]
fn the_summary_counts_the_hits_that_the_recording_sketches() {
    let directory = recording(&[]);
    let summary = fs::read_to_string(directory.path().join("out/summary.json")).expect("a summary");
    let summary: Value = serde_json::from_str(&summary).expect("JSON");
    let score = score(directory.path(), "1 kN");
    assert_eq!(score["hits"], summary["hits"]["count"]);
    assert_eq!(score["hits_recorded"], summary["hits"]["recorded"]);
    assert_eq!(score["pellets"], 150);
    let lost = summary["hits"]["lost_energy_j"]
        .as_f64()
        .expect("an energy");
    let dissipated = summary["energy"]["dissipated_j"]
        .as_f64()
        .expect("an energy");
    // They differ by what springs against sliding still hold.
    assert!(
        (lost / dissipated - 1.0).abs() < 0.01,
        "{lost} {dissipated}"
    );
}

#[test]
fn a_softened_run_is_scored_at_true_stiffness_and_says_so() {
    let directory = recording(&["materials.pellet.true_youngs_modulus=\"5 GPa\""]);
    let score = score(directory.path(), "150 N");
    assert!(share(&score["broken_at_true_stiffness"]) > share(&score["broken"]));
    let warnings = score["warnings"].to_string();
    assert!(warnings.contains("softened"), "{warnings}");
}

#[test]
fn a_recording_that_is_cut_off_is_scored_as_far_as_it_is_whole() {
    let directory = recording(&[]);
    let path = directory.path().join("out/run.mcap");
    let bytes = fs::read(&path).expect("a recording");
    fs::write(&path, &bytes[..bytes.len() - 2000]).expect("writable");
    let score = score(directory.path(), "10 N");
    assert_eq!(score["is_cut_off"], true);
    assert!(score["warnings"].to_string().contains("cut off"));
}

#[test]
fn a_recording_without_hits_is_refused_with_the_cure() {
    let directory = recording(&["output.hits=false"]);
    let arguments = ["score", "out/run.mcap", "--strength", "2 kN"];
    let call = call(directory.path(), &arguments);
    assert!(call.error.contains("holds no hits"), "{}", call.error);
    assert_eq!(call.code, 2);
}
