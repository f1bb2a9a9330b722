//! What can go wrong while a run is recorded and while a recording is read.

use crate::summary::Summary;
use pelletflow_sim::{RestoreError, StepError};
use std::io;
use std::path::{Path, PathBuf};

/// A run that did not end well.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The physics failed; recording and summary are written up to the last good step.
    #[error("{error}")]
    Physics {
        /// What failed.
        error: StepError,
        /// The run up to there.
        summary: Box<Summary>,
    },
    /// A file could not be written.
    #[error("cannot write {}: {source}; free some space there or choose another directory", path.display())]
    Output {
        /// Which file or directory.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// What is in the directory stands in the way.
    #[error(transparent)]
    Folder(Box<FolderError>),
}

impl From<FolderError> for RunError {
    fn from(error: FolderError) -> Self {
        Self::Folder(Box::new(error))
    }
}

/// A directory that a run cannot begin or go on in.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FolderError {
    /// Another run writes there.
    #[error(
        "{} is in use: another run writes there{}; wait until that has ended, or choose another directory",
        directory.display(),
        process.map_or_else(String::new, |process| format!(" (process {process})"))
    )]
    Locked {
        /// The directory.
        directory: PathBuf,
        /// Number of its process, where it is known.
        process: Option<u32>,
    },
    /// A new run would overwrite one that can go on.
    #[error(
        "{} holds an unfinished run{}; go on with it (`--resume`), drop it (`--restart`) or choose another directory",
        directory.display(),
        time.map_or_else(String::new, |time| format!(", at t = {time:.6} s"))
    )]
    Unfinished {
        /// The directory.
        directory: PathBuf,
        /// Simulated time of its checkpoint, where it can be read [s].
        time: Option<f64>,
    },
    /// The run there is of another scene.
    #[error(
        "{} holds a run of another scene; resume with the scene as it was run, {}, or drop that run (`--restart`)",
        directory.display(),
        directory.join("scene.toml").display()
    )]
    OtherScene {
        /// The directory.
        directory: PathBuf,
        /// The scene of the run there.
        scene_text: String,
        /// Files that the two scenes name and that differ.
        changed_files: Vec<PathBuf>,
    },
    /// Another version wrote the checkpoint; it might give other bits.
    #[error(
        "{} holds a run of pelletflow {version}, and this is {}; resume with that version, or drop the run (`--restart`)",
        directory.display(),
        env!("CARGO_PKG_VERSION")
    )]
    OtherVersion {
        /// The directory.
        directory: PathBuf,
        /// The version that wrote it.
        version: String,
    },
    /// No checkpoint there is whole.
    #[error("{} is damaged: {reason}, and there is no other; drop the run (`--restart`)", path.display())]
    Damaged {
        /// The newest checkpoint.
        path: PathBuf,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// The recording is shorter than when the checkpoint was written.
    #[error("{} holds {found} of the {needed} messages that were in it at the checkpoint; bring it back, or drop the run (`--restart`)", path.display())]
    ShortRecording {
        /// The recording.
        path: PathBuf,
        /// Messages in it [-].
        found: u64,
        /// Messages that were in it [-].
        needed: u64,
    },
    /// The recording is another one.
    #[error("{} is not the recording that belongs to the checkpoint beside it; bring that back, or drop the run (`--restart`)", path.display())]
    OtherRecording {
        /// The recording.
        path: PathBuf,
    },
    /// The recording cannot be read.
    #[error("{source}; bring the recording back, or drop the run (`--restart`)")]
    UnreadableRecording {
        /// Why.
        source: ReadError,
    },
    /// The checkpoint does not fit the scene.
    #[error("the checkpoint in {} cannot be taken up: {source}", directory.display())]
    Misfit {
        /// The directory.
        directory: PathBuf,
        /// Why.
        source: RestoreError,
    },
    /// The file system refused.
    #[error("cannot read {}: {source}", path.display())]
    Unreadable {
        /// The path.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

impl RunError {
    pub(crate) fn output(path: &Path, source: io::Error) -> Self {
        Self::Output {
            path: path.into(),
            source,
        }
    }
}

/// A recording that cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// There is no such file.
    #[error("{} does not exist; a run writes its recording to `DIR/run.mcap`", path.display())]
    Missing {
        /// The path asked for.
        path: PathBuf,
    },
    /// It is a directory.
    #[error("{} is a directory; name the recording in it, such as {}", path.display(), path.join("run.mcap").display())]
    Directory {
        /// The path asked for.
        path: PathBuf,
    },
    /// It is a file of another kind.
    #[error("{} is not an MCAP file: it does not begin as one; expected a recording such as `run.mcap`", path.display())]
    NotMcap {
        /// The path asked for.
        path: PathBuf,
    },
    /// It is an MCAP file with an impossible content.
    #[error("{} is damaged: {reason}; make the recording again", path.display())]
    Damaged {
        /// The path asked for.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// Another program wrote it.
    #[error("{} is an MCAP file without `pelletflow.run`: it was written by `{library}` and not by a pelletflow run", path.display())]
    Foreign {
        /// The path asked for.
        path: PathBuf,
        /// The program that wrote it, as it says.
        library: String,
    },
    /// A later version of this program wrote it, in a way that this one does not know.
    #[error("{} is a recording of format {format}, written by pelletflow {version}; expected format {} or less; read it with that version", path.display(), crate::provenance::FORMAT)]
    LaterFormat {
        /// The path asked for.
        path: PathBuf,
        /// Its format.
        format: String,
        /// The program that wrote it.
        version: String,
    },
    /// It ends before it tells of its run.
    #[error("{} is cut off before it tells of its run: nothing in it can be read; make the recording again", path.display())]
    CutTooSoon {
        /// The path asked for.
        path: PathBuf,
    },
    /// It has no such attachment.
    #[error("{} holds no attachment `{name}`; it was not written by a pelletflow run", path.display())]
    NoAttachment {
        /// The path asked for.
        path: PathBuf,
        /// The attachment asked for.
        name: String,
    },
    /// No hits were followed in that run.
    #[error("{} holds no hits: the run did not follow them; run the scene again without `hits = false` in its [output], by this version", path.display())]
    NoHits {
        /// The path asked for.
        path: PathBuf,
    },
    /// The file system refused.
    #[error("cannot read {}: {source}", path.display())]
    Io {
        /// The path asked for.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}
