//! An unfinished run found again, and taken up.

use super::slots::{self, Read};
use super::{Checkpoint, Identity};
use crate::error::{FolderError, RunError};
use crate::output::Output;
use crate::run::{Beginning, Progress, RunRequest};
use crate::summary::{Ended, Summary};
use pelletflow_sim::{Model, RestoreError, Simulation};
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// What a directory holds of an earlier run of the same scene.
#[derive(Debug)]
pub enum Earlier {
    /// Nothing to go on from: no run, or one without a checkpoint.
    Nothing,
    /// A run that is over.
    Finished(Box<Summary>),
    /// A run that can go on.
    Unfinished(Box<Resumption>),
}

/// An unfinished run whose directory nobody else writes to.
#[derive(Debug)]
pub struct Resumption {
    output: Output,
    checkpoint: Checkpoint,
    damaged: Option<PathBuf>,
}

/// Looks for an earlier run of the scene that is asked for, in the directory that is asked for.
///
/// # Errors
/// Another run writes there, the run there is of another scene or version, or its checkpoints cannot be read.
pub fn earlier(request: &RunRequest) -> Result<Earlier, RunError> {
    if !request.directory.exists() {
        return Ok(Earlier::Nothing);
    }
    let output = Output::open(request.directory)?;
    if let Some(summary) = finished(&output) {
        let text = fs::read_to_string(output.path("scene.toml")).unwrap_or_default();
        let then = Identity {
            scene_hash: summary.scene_hash.clone(),
            scene_text: text,
            ..Identity::of(request)
        };
        check_scene(request, &then)?;
        return Ok(Earlier::Finished(Box::new(summary)));
    }
    let Some(Read {
        checkpoint,
        damaged,
    }) = slots::read(request.directory)?
    else {
        return Ok(Earlier::Nothing);
    };
    check_scene(request, &checkpoint.identity)?;
    Ok(Earlier::Unfinished(Box::new(Resumption {
        output,
        checkpoint,
        damaged,
    })))
}

/// Refuses at once what [`run()`](crate::run()) would refuse: a directory that cannot be written to, that another run writes
/// to, or that holds an unfinished run. Where there is none, nothing is made.
///
/// # Errors
/// Why no run can begin there.
pub fn admit(directory: &Path) -> Result<(), RunError> {
    if directory.exists() {
        refuse_unfinished(&Output::open(directory)?)?;
    }
    Ok(())
}

/// Drops the unfinished run of a directory, so that another can begin there.
///
/// # Errors
/// Another run writes there, or a checkpoint cannot be removed.
pub fn discard(directory: &Path) -> Result<(), RunError> {
    if !directory.exists() {
        return Ok(());
    }
    let _output = Output::open(directory)?;
    slots::remove(directory)
}

/// Refuses a directory in which a new run would overwrite an unfinished one.
pub(crate) fn refuse_unfinished(output: &Output) -> Result<(), RunError> {
    let directory = output.directory();
    if !slots::are_there(directory) || finished(output).is_some() {
        return Ok(());
    }
    let time = match slots::read(directory) {
        Ok(Some(read)) => Some(read.checkpoint.identity.time_s),
        _ => None,
    };
    Err(FolderError::Unfinished {
        directory: directory.into(),
        time,
    }
    .into())
}

/// The summary of a run that is over for good.
fn finished(output: &Output) -> Option<Summary> {
    let text = fs::read_to_string(output.path("summary.json")).ok()?;
    let summary: Summary = serde_json::from_str(&text).ok()?;
    let is_over = matches!(
        summary.ended,
        Ended::EndTime | Ended::Empty | Ended::Settled
    );
    is_over.then_some(summary)
}

fn check_scene(request: &RunRequest, then: &Identity) -> Result<(), RunError> {
    if then.scene_hash == request.scene_hash {
        return Ok(());
    }
    Err(FolderError::OtherScene {
        directory: request.directory.into(),
        scene_text: then.scene_text.clone(),
        changed_files: then.changed_files(&Identity::of(request)),
    }
    .into())
}

impl Resumption {
    /// Simulated time at which the run goes on [s].
    pub fn time(&self) -> f64 {
        self.checkpoint.identity.time_s
    }

    /// Steps taken until then [-].
    pub fn step(&self) -> u64 {
        self.checkpoint.identity.step
    }

    /// The newest checkpoint, where it is damaged and the run goes on from the one before.
    pub fn damaged(&self) -> Option<&Path> {
        self.damaged.as_deref()
    }

    /// Takes the run up and drives it to its end, as [`run()`](crate::run()) does; `threads` of 0 means one per core [-].
    ///
    /// What comes of it is what an unbroken run gives, to the last bit; only times by the wall clock differ.
    /// The recording is copied up to where it goes on, so that it takes twice its room for the time of that.
    ///
    /// # Errors
    /// The checkpoint does not fit the model, the recording beside it is not that of the checkpoint, the physics failed,
    /// or a file could not be written.
    pub fn run(
        self,
        model: Model,
        threads: usize,
        request: &RunRequest,
        observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<Summary, RunError> {
        let Self {
            output,
            checkpoint,
            damaged,
        } = self;
        let contents = checkpoint.contents;
        let misfit = |source| FolderError::Misfit {
            directory: request.directory.into(),
            source,
        };
        let mut simulation =
            Simulation::restore(model, threads, contents.snapshot).map_err(misfit)?;
        contents
            .logbook
            .check(&simulation)
            .map_err(|reason| misfit(RestoreError::Misfit(reason)))?;
        let beginning = Beginning::going_on(
            &simulation,
            contents.logbook,
            contents.spent,
            contents.recording,
            damaged,
        );
        beginning.run(&output, &mut simulation, request, observer)
    }
}
