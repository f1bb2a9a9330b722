//! However a run ends, its recording is whole and its summary is written.

mod common;

use common::{plan, record, run_into, setup};
use pelletflow_log::{Ended, Inspection, RunError, Summary, inspect};
use pelletflow_sim::{RunPlan, StopCondition};
use serde_json::Value;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

fn summary_of(directory: &Path) -> Summary {
    let text = fs::read_to_string(directory.join("summary.json")).expect("a summary is written");
    serde_json::from_str(&text).expect("a summary is JSON")
}

/// Time of the last frame [s].
fn last_frame(inspection: &Inspection) -> f64 {
    let pellets = inspection
        .channels
        .iter()
        .find(|channel| channel.topic == "/pellets");
    pellets
        .and_then(|channel| channel.last_s)
        .expect("frames are recorded")
}

fn keys(value: &Value) -> Vec<&str> {
    let table = value.as_object().expect("it is a table");
    table.keys().map(String::as_str).collect()
}

#[test]
fn the_summary_has_every_key() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    record(directory.path(), 0.01);
    let text = fs::read_to_string(directory.path().join("summary.json")).expect("it is written");
    let summary: Value = serde_json::from_str(&text).expect("it is JSON");
    for key in ["schema_version", "version", "scene_hash", "seed", "threads"] {
        assert!(!summary[key].is_null(), "{key}");
    }
    let expected = [
        (
            "time",
            "simulated_s wall_s steps step_s step_reason steps_per_contact",
        ),
        ("bodies", "inserted inside discharged lost"),
        ("mass", "inserted inside discharged lost residual_kg"),
        (
            "contacts",
            "max_force_n max_overlap_ratio mean_coordination finished fewest_steps_per_contact",
        ),
        (
            "energy",
            "kinetic_j potential_j elastic_j dissipated_j residual_j",
        ),
        (
            "performance",
            "particle_steps_per_s contact_steps_per_s peak_memory_bytes phases",
        ),
        ("meters", "outflow cone-load"),
        ("outlets", "below"),
    ];
    for (table, wanted) in expected {
        let found = keys(&summary[table]);
        for key in wanted.split(' ') {
            assert!(found.contains(&key), "{table}.{key}");
        }
    }
    assert!(summary["skipped"].is_array());
    assert!(summary["state_hash"].is_string());
    assert_eq!(summary["ended"], "end-time");
    assert!(summary["failure"].is_null());
    assert!(summary["meters"]["outflow"]["mass_flow_kg_per_s"].is_number());
}

#[test]
fn the_summary_on_disk_is_the_one_returned() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let returned = record(directory.path(), 0.02);
    assert_eq!(summary_of(directory.path()), returned);
    assert_eq!(returned.bodies.inserted, 60);
    assert!(returned.performance.particle_steps_per_s > 0.0);
    assert!(!directory.path().join("summary.json.part").exists());
}

#[test]
fn an_observer_that_breaks_interrupts_the_run_and_leaves_it_whole() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let summary = run_into(
        directory.path(),
        setup(60),
        &plan(1.0e6),
        1000,
        &mut |progress| {
            assert_eq!(progress.end_time, 1.0e6);
            ControlFlow::Break(())
        },
    )
    .expect("an interrupted run is no failure");
    assert_eq!(summary.ended, Ended::Interrupted);
    let inspection = inspect(directory.path().join("run.mcap")).expect("the recording opens");
    assert!(!inspection.is_cut_off);
    assert_eq!(
        last_frame(&inspection),
        (summary.time.simulated_s * 1.0e9).round() * 1.0e-9
    );
}

#[test]
fn a_run_ends_when_the_last_pellet_has_left() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let mut setup = setup(5);
    setup.walls.retain(|wall| wall.name == "cone");
    let plan = RunPlan {
        stop: vec![StopCondition::Empty { after: 0.0 }],
        ..plan(5.0)
    };
    let go_on = &mut |_: &_| ControlFlow::Continue(());
    let summary =
        run_into(directory.path(), setup, &plan, 1000, go_on).expect("the hopper runs empty");
    assert_eq!(summary.ended, Ended::Empty);
    assert_eq!(summary.bodies.discharged, 5);
    assert_eq!(summary.outlets["below"].count, 5);
    assert!(summary.time.simulated_s < 2.0);
}

#[test]
fn a_run_ends_when_the_bed_has_settled() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let mut setup = setup(30);
    for wall in &mut setup.walls {
        wall.schedule = pelletflow_sim::Schedule::always();
    }
    let plan = RunPlan {
        stop: vec![StopCondition::Settled {
            after: 0.1,
            speed: 0.01,
        }],
        ..plan(5.0)
    };
    let go_on = &mut |_: &_| ControlFlow::Continue(());
    let summary =
        run_into(directory.path(), setup, &plan, 1000, go_on).expect("the hopper settles");
    assert_eq!(summary.ended, Ended::Settled);
    assert_eq!(summary.bodies.inside, 30);
}

#[test]
fn a_failure_of_the_physics_keeps_the_last_good_frame_and_is_told_everywhere() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let mut setup = setup(20);
    // Without walls and outlet, pellets fall out of the domain and are lost.
    setup.walls.clear();
    setup.meters.clear();
    setup.outlets.clear();
    let go_on = &mut |_: &_| ControlFlow::Continue(());
    let error = run_into(directory.path(), setup, &plan(5.0), 1000, go_on)
        .expect_err("a lost pellet is a failure");
    let RunError::Physics { error, summary } = error else {
        panic!("expected a failure of the physics, not {error}");
    };
    assert_eq!(summary.ended, Ended::Failed);
    assert_eq!(summary.failure.as_deref(), Some(error.to_string().as_str()));
    assert_eq!(summary_of(directory.path()), *summary);
    let inspection = inspect(directory.path().join("run.mcap")).expect("the recording opens");
    assert!(!inspection.is_cut_off);
    // Log times are whole nanoseconds.
    assert!((last_frame(&inspection) - summary.time.simulated_s).abs() < 1.0e-9);
}

#[test]
fn a_directory_that_cannot_be_made_is_named() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let file = directory.path().join("taken");
    fs::write(&file, "").expect("a file can be written");
    let go_on = &mut |_: &_| ControlFlow::Continue(());
    let error = run_into(&file.join("run"), setup(5), &plan(0.01), 0, go_on)
        .expect_err("a file is no directory");
    assert!(matches!(error, RunError::Output { .. }));
    assert!(error.to_string().contains("taken"), "{error}");
}

#[test]
fn equal_runs_record_equal_messages() {
    let (first, second) = (
        tempfile::tempdir().expect("a temporary directory can be made"),
        tempfile::tempdir().expect("a temporary directory can be made"),
    );
    let hashes = [&first, &second].map(|directory| record(directory.path(), 0.03).state_hash);
    assert_eq!(hashes[0], hashes[1]);
    let [a, b] = [&first, &second]
        .map(|directory| inspect(directory.path().join("run.mcap")).expect("the recording opens"));
    assert_eq!(a.channels, b.channels);
}
