//! A run from its first step to its last, recorded.

use crate::course::{Course, Stop};
use crate::error::RunError;
use crate::layout::layout;
use crate::output::Output;
use crate::patches;
use crate::recording::{Recording, Title};
use crate::summary::{Ended, RunFacts, Summary};
use mcap::McapError;
use pelletflow_sim::{RunPlan, Simulation};
use std::collections::BTreeMap;
use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
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
/// # Errors
/// The physics failed, or a file could not be written.
pub fn run(
    simulation: &mut Simulation,
    request: &RunRequest,
    observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    let began = Instant::now();
    let full_speed = simulation.model().time_step().expected_speed;
    let layout = layout(
        &simulation.model().setup().domain.bounds,
        &simulation.meter_readings(),
        request.spheres_up_to,
        full_speed,
    );
    let output = Output::create(request.directory)?;
    output.write("scene.toml", request.scene_text)?;
    for (path, bytes) in request.scene_files {
        output.write_beside(path, bytes)?;
    }
    output.write("layout.json", &layout)?;
    patches::write(&output, simulation)?;
    let recording = output.path("run.mcap");
    let in_recording = |error: McapError| RunError::output(&recording, as_io(error));

    let file = output.file("run.mcap")?;
    let title = Title {
        scene_text: request.scene_text,
        layout: &layout,
        facts: facts(simulation, request),
    };
    let setup = simulation.model().setup();
    let recording_of_run = Recording::start(file, setup, &title, request.spheres_up_to, full_speed);
    let particle_steps_before = simulation.particle_steps();
    let contact_steps_before = simulation.contact_statistics().contact_steps;
    let mut course = Course::new(recording_of_run.map_err(in_recording)?);
    let outcome = course.drive(simulation, request.plan, observer);
    let (ended, failure) = match &outcome {
        Ok(ended) => (*ended, None),
        Err(Stop::Physics(error)) => (Ended::Failed, Some(error.to_string())),
        Err(Stop::Output(error)) => (Ended::Failed, Some(error.to_string())),
    };
    let closed = course.close(simulation, ended, failure.as_deref());
    let summary = Summary::new(
        simulation,
        &RunFacts {
            scene: request.scene_name,
            scene_hash: request.scene_hash,
            wall_time: began.elapsed().as_secs_f64(),
            particle_steps_before,
            contact_steps_before,
            ended,
            failure,
        },
    );
    let written = patches::write(&output, simulation).and_then(|()| output.write_summary(&summary));
    match outcome {
        Err(Stop::Physics(error)) => Err(RunError::Physics {
            error,
            summary: Box::new(summary),
        }),
        Err(Stop::Output(error)) => Err(in_recording(error)),
        Ok(_) => {
            closed.map_err(in_recording)?;
            written?;
            Ok(summary)
        }
    }
}

fn facts(simulation: &Simulation, request: &RunRequest) -> BTreeMap<String, String> {
    let model = simulation.model();
    [
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
