//! A run from its first step to its last, recorded.

use crate::checkpoint::{self, Identity, Keeper, Spent, refuse_unfinished};
use crate::counts_before::CountsBefore;
use crate::course::{Course, Outcome, Stop};
use crate::error::RunError;
use crate::live::Live;
use crate::logbook::Logbook;
use crate::opening::{self, EarlierPart, RECORDING, as_io};
use crate::output::Output;
use crate::patches;
use crate::recording::{Mark, Recorder};
use crate::summary::{Ended, RunFacts, Summary};
use crate::thinning;
use pelletflow_sim::{RunPlan, Simulation, StepError};
use std::io;
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
    /// Whether every contact is recorded in every frame.
    pub contacts: bool,
    /// Where the run can be watched while it goes on; nowhere if it is not given.
    pub live: Option<&'a Live>,
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
/// Where the plan keeps some frames only, the recording of a run that is over is then written again without the others.
///
/// The recording is written by a thread of its own, which holds three frames at most: where they are not written
/// fast enough, the run waits.
///
/// Checkpoints are written as the plan says, and when the observer breaks; [`earlier`](crate::earlier()) finds them again.
/// They are removed when the run is over.
///
/// # Errors
/// Another run writes to the directory or can go on there, the physics failed, or a file could not be written.
pub fn run(
    simulation: &mut Simulation,
    request: &RunRequest,
    observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    let output = Output::open(request.directory)?;
    refuse_unfinished(&output)?;
    checkpoint::remove(output.directory())?;
    Beginning::new(simulation, request.plan).run(&output, simulation, request, observer)
}

/// Where a run begins or goes on.
pub(crate) struct Beginning {
    before: CountsBefore,
    spent: Spent,
    logbook: Logbook,
    earlier: Option<EarlierPart>,
}

/// What failed.
#[derive(Debug, thiserror::Error)]
#[error(transparent)]
enum Failure {
    Physics(StepError),
    Output(RunError),
}

impl Beginning {
    fn new(simulation: &Simulation, plan: &RunPlan) -> Self {
        Self {
            before: CountsBefore::of(simulation),
            spent: Spent::default(),
            logbook: Logbook::new(simulation, plan),
            earlier: None,
        }
    }

    /// Of a run taken up where its recording has a mark; `damaged` is a newer checkpoint that cannot be.
    pub(crate) fn going_on(
        simulation: &Simulation,
        logbook: Logbook,
        spent: Spent,
        mark: Mark,
        damaged: Option<PathBuf>,
    ) -> Self {
        Self {
            before: CountsBefore::going_on(simulation, &spent),
            spent,
            logbook,
            earlier: Some(EarlierPart { mark, damaged }),
        }
    }

    /// Drives the run to its end.
    pub(crate) fn run(
        self,
        output: &Output,
        simulation: &mut Simulation,
        request: &RunRequest,
        observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<Summary, RunError> {
        let began = Instant::now();
        simulation.show_contacts(request.contacts);
        let (recording, file) = match &self.earlier {
            None => opening::begin(output, simulation, request)?,
            Some(earlier) => opening::go_on(output, simulation, request, earlier)?,
        };
        let path = output.path(RECORDING);
        let keeper = Keeper::new(
            output.directory().into(),
            Identity::of(request),
            Arc::new(file),
            request.plan.checkpoint_interval,
            (self.before.clone(), self.spent.clone()),
        );
        let Outcome {
            ended,
            worst_moments,
            mut recording_times,
        } = thread::scope(|scope| {
            let recorder = Recorder::start(scope, recording)?;
            let course = Course::new(recorder, keeper, self.logbook);
            Ok(course.run(simulation, request.plan, observer))
        })
        .map_err(|error| RunError::output(&path, without_thread(&error)))?;

        let began_to_thin = Instant::now();
        // One that can go on, or that failed, keeps all that there is.
        let thinned = match ended {
            Ok(ended) if ended != Ended::Interrupted => {
                thinning::thin(output, simulation, request, &worst_moments)
            }
            _ => Ok(false),
        };
        recording_times.waiting += began_to_thin.elapsed();

        let (ended, failure) = match ended {
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
                wall_time: self.spent.wall_time + began.elapsed().as_secs_f64(),
                recording_times: self.spent.recording.and(recording_times),
                before: self.before,
                ended,
                failure: failure.as_ref().map(ToString::to_string),
            },
        );
        let written =
            patches::write(output, simulation).and_then(|()| output.write_summary(&summary));
        match failure {
            Some(Failure::Output(error)) => Err(error),
            Some(Failure::Physics(error)) => {
                // It would fail again; what cannot be removed then does no harm.
                let _ = checkpoint::remove(output.directory());
                Err(RunError::Physics {
                    error,
                    summary: Box::new(summary),
                })
            }
            None => {
                written?;
                if ended != Ended::Interrupted {
                    checkpoint::remove(output.directory())?;
                }
                // Not before: a checkpoint needs the recording as it was.
                if thinned? {
                    thinning::take_place(output)?;
                }
                Ok(summary)
            }
        }
    }
}

/// Says what it was that the system refused.
fn without_thread(error: &io::Error) -> io::Error {
    let message = format!("the thread that writes it cannot be started: {error}");
    io::Error::new(error.kind(), message)
}
