//! However a run ends, its recording is whole and its summary is written.

mod common;

use common::{plan, record, run_into, setup};
use pelletflow_log::{Ended, Inspection, Profile, RunError, Summary, inspect, read_frames};
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
fn an_interrupted_run_has_recorded_every_frame_that_was_due() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let interval = 0.001;
    let often = RunPlan {
        frame_interval: interval,
        ..plan(1.0e6)
    };
    let summary = run_into(directory.path(), setup(60), &often, 1000, &mut |progress| {
        if progress.time < 0.03 {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    })
    .expect("an interrupted run is no failure");
    assert_eq!(summary.ended, Ended::Interrupted);
    let recording = directory.path().join("run.mcap");
    let times: Vec<f64> = read_frames(&recording)
        .expect("the recording opens")
        .map(|frame| frame.expect("every frame can be read").time)
        .collect();
    let due = (summary.time.simulated_s / interval + 0.5).floor() as usize;
    // The first, those due, and the last, which may be due as well.
    assert!(
        times.len() == due + 1 || times.len() == due + 2,
        "{} frames in {} s",
        times.len(),
        summary.time.simulated_s
    );
    assert!(times.is_sorted());
    // Log times are whole nanoseconds.
    let last = times.last().expect("there are frames");
    assert!((last - summary.time.simulated_s).abs() < 1.0e-9);
}

#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_is_full_before_the_first_step_is_told_and_no_step_is_taken() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    std::os::unix::fs::symlink("/dev/full", directory.path().join("run.mcap"))
        .expect("a link can be made");
    let go_on = &mut |_: &_| panic!("the run goes on");
    let error = run_into(directory.path(), setup(60), &plan(1.0e6), 1000, go_on)
        .expect_err("nothing can be written to a full disk");
    let RunError::Output { path, source } = error else {
        panic!("expected a failure of the output, not {error}");
    };
    assert_eq!(path, directory.path().join("run.mcap"));
    assert_eq!(source.kind(), std::io::ErrorKind::StorageFull);
}

#[test]
fn the_phases_add_up_to_the_run_and_the_writer_works_meanwhile() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let summary = record(directory.path(), 0.05);
    let mut phases = summary.performance.phases.clone();
    let writer = phases.remove("writer").expect("the writer has worked");
    assert!(writer > 0.0 && writer <= summary.time.wall_s, "{writer}");
    assert!(phases.values().all(|&seconds| seconds >= 0.0), "{phases:?}");
    assert!(phases["recording"] > 0.0 && phases["waiting"] > 0.0);
    let sum: f64 = phases.values().sum();
    // Rounding of ten numbers.
    assert!((sum / summary.time.wall_s - 1.0).abs() < 1.0e-12, "{sum}");

    let profile = Profile::of(&summary);
    assert_eq!(profile.phases.len(), phases.len());
    let shares: f64 = profile.phases.iter().map(|phase| phase.share).sum();
    assert!((shares - 1.0).abs() < 1.0e-12, "{shares}");
    let (rest, named) = profile.phases.split_last().expect("there are phases");
    assert_eq!(rest.name, "other");
    assert!(named.is_sorted_by(|a, b| a.seconds >= b.seconds));
    let pellet_steps = 60.0 * summary.time.steps as f64;
    let per_step = profile
        .run
        .seconds_per_pellet_step
        .expect("pellets took steps");
    assert!((per_step * pellet_steps / summary.time.wall_s - 1.0).abs() < 1.0e-12);
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
