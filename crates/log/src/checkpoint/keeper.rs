//! When checkpoints are written, and what goes into them.

use super::{Contents, Identity, Spent, slots};
use crate::counts_before::CountsBefore;
use crate::logbook::Logbook;
use crate::recording::{Mark, RecordingTimes};
use pelletflow_sim::{Simulation, Snapshot};
use std::fs::File;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Keeps the checkpoints of a run.
///
/// Its clock never goes back: a clock on the wall that is set changes nothing.
#[derive(Debug)]
pub(crate) struct Keeper {
    directory: PathBuf,
    identity: Identity,
    recording: Arc<File>,
    /// Time between two; none where only an interruption asks for one.
    interval: Option<Duration>,
    last: Instant,
    began: Instant,
    before: CountsBefore,
    spent_before: Spent,
}

/// A checkpoint about to be written.
#[derive(Debug)]
pub(crate) struct Save {
    directory: PathBuf,
    identity: Identity,
    recording: Arc<File>,
    snapshot: Snapshot,
    logbook: Logbook,
    spent: Spent,
}

impl Keeper {
    /// Of a run that begins or goes on now, and is recorded in a file; `interval` is by the wall clock [s].
    pub(crate) fn new(
        directory: PathBuf,
        identity: Identity,
        recording: Arc<File>,
        interval: f64,
        (before, spent_before): (CountsBefore, Spent),
    ) -> Self {
        let now = Instant::now();
        Self {
            directory,
            identity,
            recording,
            interval: Duration::try_from_secs_f64(interval).ok(),
            last: now,
            began: now,
            before,
            spent_before,
        }
    }

    /// Whether one is due; it is then not due again until the interval has passed.
    ///
    /// None is while the last one waits for the disk: each holds a whole run in memory. Only that of an interruption does not
    /// wait.
    pub(crate) fn is_due(&mut self) -> bool {
        // What waits to be written has the recording too.
        let is_waiting = Arc::strong_count(&self.recording) > 1;
        let is_due = !is_waiting
            && self
                .interval
                .is_some_and(|interval| self.last.elapsed() >= interval);
        if is_due {
            self.last = Instant::now();
        }
        is_due
    }

    /// A run as it is now, to be written.
    pub(crate) fn save(
        &self,
        simulation: &Simulation,
        logbook: &Logbook,
        recording: RecordingTimes,
    ) -> Save {
        Save {
            directory: self.directory.clone(),
            identity: Identity {
                step: simulation.step_count(),
                time_s: simulation.time(),
                ..self.identity.clone()
            },
            recording: Arc::clone(&self.recording),
            snapshot: simulation.snapshot(),
            logbook: logbook.clone(),
            spent: self.spent(simulation, recording),
        }
    }

    /// What the run took so far, that before it was interrupted included.
    pub(crate) fn spent(&self, simulation: &Simulation, recording: RecordingTimes) -> Spent {
        Spent {
            wall_time: self.spent_before.wall_time + self.began.elapsed().as_secs_f64(),
            recording: self.spent_before.recording.and(recording),
            ..self.before.spent(simulation)
        }
    }
}

impl Save {
    /// Writes the checkpoint once the disk has the recording, of which all up to a mark has been handed to it; `writing`
    /// is how long that took since the run began or went on.
    pub(crate) fn write(mut self, mark: Mark, writing: Duration) -> io::Result<()> {
        self.recording.sync_all()?;
        self.spent.recording.writing += writing;
        let contents = Contents {
            snapshot: self.snapshot,
            logbook: self.logbook,
            spent: self.spent,
            recording: mark,
        };
        slots::save(&self.directory, &self.identity, &contents).map_err(|error| {
            io::Error::new(error.kind(), format!("the checkpoint beside it: {error}"))
        })
    }
}
