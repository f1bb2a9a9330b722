//! The directory of a run.

use crate::error::{FolderError, RunError};
use crate::summary::Summary;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;

/// File that is locked while a run writes to its directory; it stays, for whoever removes a lock breaks that of another.
const LOCK: &str = "run.lock";

/// A directory that files are written to, by one run at a time.
#[derive(Debug)]
pub(crate) struct Output {
    directory: PathBuf,
    /// Locked until it is closed, however the process ends; none where the file system knows no locks.
    _lock: Option<File>,
}

impl Output {
    /// Makes the directory where it does not exist, and keeps other runs out.
    pub(crate) fn open(directory: &Path) -> Result<Self, RunError> {
        fs::create_dir_all(directory).map_err(|source| RunError::output(directory, source))?;
        Ok(Self {
            directory: directory.into(),
            _lock: lock(directory)?,
        })
    }

    /// Takes away what an earlier run may have left: beside a new recording it would be taken for the new run's.
    pub(crate) fn clear(&self, name: &str) -> Result<(), RunError> {
        let path = self.path(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                Err(RunError::output(&path, error))
            }
            _ => Ok(()),
        }
    }

    pub(crate) fn directory(&self) -> &Path {
        &self.directory
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.directory.join(name)
    }

    pub(crate) fn write(&self, name: &str, text: &str) -> Result<(), RunError> {
        let path = self.path(name);
        write_where_new(&path, text.as_bytes()).map_err(|source| RunError::output(&path, source))
    }

    /// Writes a file of a folder within, which is made where it does not exist.
    pub(crate) fn write_in(&self, folder: &str, name: &str, text: &str) -> Result<(), RunError> {
        let folder = self.path(folder);
        fs::create_dir_all(&folder).map_err(|source| RunError::output(&folder, source))?;
        let path = folder.join(name);
        fs::write(&path, text).map_err(|source| RunError::output(&path, source))
    }

    /// Writes a file that `scene.toml` names, in the folder where that seeks it.
    pub(crate) fn write_beside(&self, path: &Path, bytes: &[u8]) -> Result<(), RunError> {
        let path = self.directory.join(path);
        let folder = path.parent().unwrap_or(&self.directory);
        fs::create_dir_all(folder)
            .and_then(|()| write_where_new(&path, bytes))
            .map_err(|source| RunError::output(&path, source))
    }

    pub(crate) fn file(&self, name: &str) -> Result<File, RunError> {
        let path = self.path(name);
        File::create(&path).map_err(|source| RunError::output(&path, source))
    }

    /// Writes `summary.json` at once: a reader sees the whole of it or none.
    pub(crate) fn write_summary(&self, summary: &Summary) -> Result<(), RunError> {
        let path = self.path("summary.json");
        let unfinished = self.path("summary.json.part");
        let text = serde_json::to_string_pretty(summary)
            .map_err(|error| RunError::output(&path, error.into()))?;
        fs::write(&unfinished, text + "\n")
            .and_then(|()| fs::rename(&unfinished, &path))
            .map_err(|source| RunError::output(&path, source))
    }
}

/// Locks a directory against other runs.
fn lock(directory: &Path) -> Result<Option<File>, RunError> {
    let path = directory.join(LOCK);
    let mut file = OpenOptions::new()
        .write(true)
        .create(true)
        .truncate(false)
        .open(&path)
        .map_err(|source| RunError::output(&path, source))?;
    match file.try_lock() {
        Ok(()) => {
            // For whoever finds it locked; whether it is written does not matter.
            let _ = file
                .set_len(0)
                .and_then(|()| writeln!(file, "{}", process::id()));
            Ok(Some(file))
        }
        Err(TryLockError::WouldBlock) => Err(FolderError::Locked {
            directory: directory.into(),
            process: fs::read_to_string(&path)
                .ok()
                .and_then(|text| text.trim().parse().ok()),
        }
        .into()),
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => Ok(None),
        Err(TryLockError::Error(source)) => Err(RunError::output(&path, source)),
    }
}

/// Writes a file unless it holds that already: a process killed in the middle must not leave half of what was whole.
fn write_where_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
    match fs::read(path) {
        Ok(held) if held == bytes => Ok(()),
        _ => fs::write(path, bytes),
    }
}

/// Waits until the disk has the names of a directory, where the system can.
pub(crate) fn sync_directory(directory: &Path) {
    // What is in the files is on the disk; a system that opens no directories keeps names by itself.
    if let Ok(directory) = File::open(directory) {
        let _ = directory.sync_all();
    }
}
