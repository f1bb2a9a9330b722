//! Checkpoints: a run put down so that it can be taken up again, to the last bit.
//!
//! A checkpoint holds the simulation between two steps and what the recording depends on. It is written by the thread
//! that writes the recording, after everything that the recording holds by then has reached the disk: so a recording is
//! never shorter than its checkpoint says.

mod bytes;
mod file;
mod keeper;
mod resumption;
mod slots;

pub use bytes::{SnapshotError, snapshot_from_bytes, snapshot_to_bytes};
pub(crate) use keeper::{Keeper, Save};
pub(crate) use resumption::refuse_unfinished;
pub use resumption::{Earlier, Resumption, admit, discard, earlier};
pub(crate) use slots::remove;

use crate::logbook::Logbook;
use crate::recording::{Mark, RecordingTimes};
use crate::run::RunRequest;
use pelletflow_sim::Snapshot;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;
use xxhash_rust::xxh3::xxh3_128;

/// Which run a checkpoint is of, and how far it was; readable by every version.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Identity {
    /// Version of pelletflow.
    pub(crate) version: String,
    pub(crate) scene: String,
    pub(crate) scene_hash: String,
    pub(crate) scene_text: String,
    /// Hash of each file that the scene names.
    pub(crate) files: BTreeMap<PathBuf, String>,
    pub(crate) step: u64,
    pub(crate) time_s: f64,
}

/// What a run needs to go on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Contents {
    pub(crate) snapshot: Snapshot,
    pub(crate) logbook: Logbook,
    pub(crate) spent: Spent,
    pub(crate) recording: Mark,
}

/// What a run took so far; no answer depends on it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Spent {
    /// Time by the wall clock [s].
    pub(crate) wall_time: f64,
    pub(crate) recording: RecordingTimes,
    /// Time of each part of the step [s].
    pub(crate) phases: Vec<f64>,
    /// Pellets times steps before the run began [-].
    pub(crate) particle_steps_before: u64,
    /// Contacts times steps before the run began [-].
    pub(crate) contact_steps_before: u64,
}

/// A checkpoint read back.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Checkpoint {
    pub(crate) identity: Identity,
    pub(crate) contents: Contents,
}

impl Identity {
    /// Of a run that has not begun.
    pub(crate) fn of(request: &RunRequest) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            scene: request.scene_name.into(),
            scene_hash: request.scene_hash.into(),
            scene_text: request.scene_text.into(),
            files: request
                .scene_files
                .iter()
                .map(|(path, bytes)| (path.clone(), format!("{:032x}", xxh3_128(bytes))))
                .collect(),
            step: 0,
            time_s: 0.0,
        }
    }

    /// Files that are not those of another run, by name.
    pub(crate) fn changed_files(&self, other: &Self) -> Vec<PathBuf> {
        let names = self.files.keys().chain(other.files.keys());
        let mut changed: Vec<PathBuf> = names
            .filter(|name| self.files.get(*name) != other.files.get(*name))
            .cloned()
            .collect();
        changed.sort();
        changed.dedup();
        changed
    }
}
