//! Whether a recording is one of ours, and of a version that this program reads.

use crate::error::ReadError;
use crate::records::Records;
use mcap::records::Record;
use std::path::{Path, PathBuf};

/// Name of the metadata that every recording of a run has.
pub(crate) const RUN_METADATA: &str = "pelletflow.run";
/// Its key of the version of the channels.
pub(crate) const FORMAT_KEY: &str = "format";
/// The version of the channels that this program writes and reads [-].
pub(crate) const FORMAT: u32 = 1;

/// Reads a recording as far as it tells of its run.
pub(crate) fn check(path: &Path) -> Result<(), ReadError> {
    let mut records = Records::open(path)?;
    let mut provenance = Provenance::new(path);
    while let Some(record) = records.next()? {
        provenance.take(&record)?;
        if provenance.is_of_a_run {
            return Ok(());
        }
    }
    provenance.finish(records.is_cut_off())
}

/// What a recording has said of itself so far.
pub(crate) struct Provenance {
    path: PathBuf,
    library: String,
    is_of_a_run: bool,
}

impl Provenance {
    pub(crate) fn new(path: &Path) -> Self {
        Self {
            path: path.into(),
            library: String::new(),
            is_of_a_run: false,
        }
    }

    /// Looks at the next record; one of a later version says so before any of its messages is misread.
    pub(crate) fn take(&mut self, record: &Record) -> Result<(), ReadError> {
        match record {
            Record::Header(header) => self.library.clone_from(&header.library),
            Record::Metadata(metadata) if metadata.name == RUN_METADATA => {
                self.is_of_a_run = true;
                let entry = |key: &str| metadata.metadata.get(key).cloned();
                // The first recordings did not tell it.
                let format = entry(FORMAT_KEY).unwrap_or_else(|| "1".into());
                if format.parse::<u32>().is_ok_and(|format| format <= FORMAT) {
                    return Ok(());
                }
                return Err(ReadError::LaterFormat {
                    path: self.path.clone(),
                    format,
                    version: entry("version").unwrap_or_else(|| "of an unknown version".into()),
                });
            }
            _ => {}
        }
        Ok(())
    }

    /// Called after the last record: a file that has not told of its run is foreign, or cut off too soon.
    pub(crate) fn finish(self, is_cut_off: bool) -> Result<(), ReadError> {
        let Self { path, library, .. } = self;
        match (self.is_of_a_run, is_cut_off) {
            (true, _) => Ok(()),
            (false, true) => Err(ReadError::CutTooSoon { path }),
            (false, false) => Err(ReadError::Foreign { path, library }),
        }
    }
}
