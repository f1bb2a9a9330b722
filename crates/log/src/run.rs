//! A run from its first step to its last, recorded.

use crate::course::{Course, Stop};
use crate::error::RunError;
use crate::layout::layout;
use crate::output::Output;
use crate::patches;
use crate::provenance::{FORMAT, FORMAT_KEY};
use crate::recording::{Recorder, Recording, Title};
use crate::summary::{CountsBefore, Ended, RunFacts, Summary};
use mcap::McapError;
use pelletflow_sim::{RunPlan, Simulation, StepError};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufWriter};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Instant;

/// What to run, how long, and where to put it.
#[derive(Debug, Clone, Copy)]
pub struct RunRequest<'a> {
    /// Directory of the output; made where it does not exist.
    pub directory: &'a Path,
    /// Name of the scene.
    pub scene_name: &'a str,
    /// Title of the scene, in words.
    pub scene_title: &'a str,
    /// The scene file as it is run.
    pub scene_text: &'a str,
    /// Hash of the scene.
    pub scene_hash: &'a str,
    /// Files that the scene names: where each lies, seen from the folder of the scene, and what it holds.
    pub scene_files: &'a [(PathBuf, Arc<[u8]>)],
    /// How long the run goes on and how often it is looked at.
    pub plan: &'a RunPlan,
    /// Spheres of true size are recorded of at most this many pellets [-].
    pub spheres_up_to: usize,
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Simulated time [s].
    pub time: f64,
    /// Simulated time at which the run ends at the latest [s].
    pub end_time: f64,
    /// Steps taken [-].
    pub step: u64,
    /// Pellets inside [-].
    pub pellets: usize,
    /// Greatest normal force so far [N].
    pub max_force: f64,
    /// Pellets lost so far [-].
    pub lost: u64,
    /// Pellets discharged so far [-].
    pub discharged: u64,
}

/// Drives a simulation to its end, and writes `scene.toml` with the files it names, `layout.json`, `run.mcap` and
/// `summary.json`, and `meters/NAME.csv` for every meter that keeps patches of a wall.
///
/// The observer is called about every 20 ms; the run stops when it breaks.
/// However the run ends, the recording is finished and a summary is written.
///
/// The recording is written by a thread of its own, which holds three frames at most: where they are not written
/// fast enough, the run waits.
///
/// # Errors
/// The physics failed, or a file could not be written.
pub fn run(
    simulation: &mut Simulation,
    request: &RunRequest,
    observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    let began = Instant::now();
    let before = CountsBefore::of(simulation);
    let output = Output::create(request.directory)?;
    let recording = start(&output, simulation, request)?;
    let path = output.path("run.mcap");
    let (outcome, recording_times) = thread::scope(|scope| {
        let recorder = Recorder::start(scope, recording)?;
        Ok(Course::new(recorder).run(simulation, request.plan, observer))
    })
    .map_err(|error| RunError::output(&path, error))?;

    let (ended, failure) = match outcome {
        Ok(ended) => (ended, None),
        Err(Stop::Physics(error)) => (Ended::Failed, Some(Failure::Physics(error))),
        Err(Stop::Output(error)) => {
            let error = RunError::output(&path, as_io(error));
            (Ended::Failed, Some(Failure::Output(error)))
        }
    };
    let summary = Summary::new(
        simulation,
        &RunFacts {
            scene: request.scene_name,
            scene_hash: request.scene_hash,
            wall_time: began.elapsed().as_secs_f64(),
            recording_times,
            before,
            ended,
            failure: failure.as_ref().map(ToString::to_string),
        },
    );
    let written = patches::write(&output, simulation).and_then(|()| output.write_summary(&summary));
    match failure {
        Some(Failure::Physics(error)) => Err(RunError::Physics {
            error,
            summary: Box::new(summary),
        }),
        Some(Failure::Output(error)) => Err(error),
        None => written.map(|()| summary),
    }
}

/// What failed.
#[derive(Debug, thiserror::Error)]
#[error(transparent)]
enum Failure {
    Physics(StepError),
    Output(RunError),
}

/// Writes what is known before the first step, and begins the recording.
fn start(
    output: &Output,
    simulation: &Simulation,
    request: &RunRequest,
) -> Result<Recording<BufWriter<File>>, RunError> {
    let setup = simulation.model().setup();
    let full_speed = simulation.model().time_step().expected_speed;
    let layout = layout(
        &setup.domain.bounds,
        &simulation.meter_readings(),
        request.spheres_up_to,
        full_speed,
    );
    output.write("scene.toml", request.scene_text)?;
    for (path, bytes) in request.scene_files {
        output.write_beside(path, bytes)?;
    }
    output.write("layout.json", &layout)?;
    patches::write(output, simulation)?;
    let title = Title {
        scene_text: request.scene_text,
        layout: &layout,
        facts: facts(simulation, request),
    };
    let file = output.file("run.mcap")?;
    Recording::start(file, setup, &title, request.spheres_up_to, full_speed)
        .map_err(|error| RunError::output(&output.path("run.mcap"), as_io(error)))
}

fn facts(simulation: &Simulation, request: &RunRequest) -> BTreeMap<String, String> {
    let model = simulation.model();
    [
        (FORMAT_KEY, FORMAT.to_string()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("scene", request.scene_name.to_owned()),
        ("title", request.scene_title.to_owned()),
        ("scene_hash", request.scene_hash.to_owned()),
        ("seed", model.setup().seed.to_string()),
        ("threads", simulation.threads().to_string()),
        ("step_s", model.time_step().seconds.to_string()),
        ("step_reason", model.time_step().reason.clone()),
    ]
    .map(|(key, value)| (key.to_owned(), value))
    .into()
}

fn as_io(error: McapError) -> io::Error {
    match error {
        McapError::Io(error) => error,
        other => io::Error::other(other),
    }
}
