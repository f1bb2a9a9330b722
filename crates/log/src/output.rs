//! The directory of a run.

use crate::error::RunError;
use crate::summary::Summary;
use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

/// A directory that files are written to.
pub(crate) struct Output {
    directory: PathBuf,
}

impl Output {
    /// Makes the directory, and takes away the summary of an earlier run:
    /// beside a new recording it would be taken for the new run's.
    pub(crate) fn create(directory: &Path) -> Result<Self, RunError> {
        fs::create_dir_all(directory).map_err(|source| RunError::output(directory, source))?;
        let output = Self {
            directory: directory.into(),
        };
        let summary = output.path("summary.json");
        match fs::remove_file(&summary) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                Err(RunError::output(&summary, error))
            }
            _ => Ok(output),
        }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.directory.join(name)
    }

    pub(crate) fn write(&self, name: &str, text: &str) -> Result<(), RunError> {
        let path = self.path(name);
        fs::write(&path, text).map_err(|source| RunError::output(&path, source))
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
            .and_then(|()| fs::write(&path, bytes))
            .map_err(|source| RunError::output(&path, source))
    }

    pub(crate) fn file(&self, name: &str) -> Result<BufWriter<File>, RunError> {
        let path = self.path(name);
        let file = File::create(&path).map_err(|source| RunError::output(&path, source))?;
        Ok(BufWriter::new(file))
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
