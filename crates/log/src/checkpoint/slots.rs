//! The two newest checkpoints of a folder.

use super::file::{self, Flaw};
use super::{Checkpoint, Contents, Identity};
use crate::error::{FolderError, RunError};
use crate::output::sync_directory;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

const NEWEST: &str = "checkpoint.pf";
const PREVIOUS: &str = "checkpoint.previous.pf";
const UNFINISHED: &str = "checkpoint.pf.part";

/// What the checkpoints of a folder came to.
#[derive(Debug)]
pub(super) struct Read {
    pub(super) checkpoint: Checkpoint,
    /// The newest one, where it is damaged and this is the one before.
    pub(super) damaged: Option<PathBuf>,
}

/// Writes the newest checkpoint at once; the one before is kept, and is what counts until the disk has this one.
pub(super) fn save(directory: &Path, identity: &Identity, contents: &Contents) -> io::Result<()> {
    let [newest, previous, unfinished] = paths(directory);
    let saved = file::write(&unfinished, identity, contents)
        .and_then(|()| match fs::rename(&newest, &previous) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        })
        .and_then(|()| fs::rename(&unfinished, &newest));
    if saved.is_err() {
        // It may be what fills the disk.
        let _ = fs::remove_file(&unfinished);
    }
    saved?;
    sync_directory(directory);
    Ok(())
}

/// The newest checkpoint that is whole; nothing where there is none at all.
pub(super) fn read(directory: &Path) -> Result<Option<Read>, RunError> {
    let [newest, previous, _] = paths(directory);
    let mut damaged: Option<(PathBuf, &'static str)> = None;
    for path in [newest, previous] {
        let bytes = match fs::read(&path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(source) => return Err(FolderError::Unreadable { path, source }.into()),
        };
        match file::decode(&bytes) {
            Ok(checkpoint) => {
                let damaged = damaged.map(|(path, _)| path);
                return Ok(Some(Read {
                    checkpoint,
                    damaged,
                }));
            }
            Err(Flaw::OtherVersion(version)) => {
                return Err(FolderError::OtherVersion {
                    directory: directory.into(),
                    version,
                }
                .into());
            }
            Err(Flaw::Damaged(reason)) => damaged = damaged.or(Some((path, reason))),
        }
    }
    match damaged {
        None => Ok(None),
        Some((path, reason)) => Err(FolderError::Damaged { path, reason }.into()),
    }
}

/// Whether a folder holds any checkpoint, whole or not.
pub(super) fn are_there(directory: &Path) -> bool {
    let [newest, previous, _] = paths(directory);
    newest.exists() || previous.exists()
}

/// Takes all checkpoints of a folder away, the newest last.
pub(crate) fn remove(directory: &Path) -> Result<(), RunError> {
    let [newest, previous, unfinished] = paths(directory);
    for path in [unfinished, previous, newest] {
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                return Err(RunError::output(&path, error));
            }
            _ => {}
        }
    }
    Ok(())
}

fn paths(directory: &Path) -> [PathBuf; 3] {
    [NEWEST, PREVIOUS, UNFINISHED].map(|name| directory.join(name))
}
