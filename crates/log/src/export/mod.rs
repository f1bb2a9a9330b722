//! A recording as files of other programs: VTK for `ParaView`, CSV for spreadsheets, Parquet for data frames.
//!
//! Pellets and contacts are read frame by frame and written at once, so that memory does not grow with the recording.

mod csv;
mod parquet;
mod scene;
mod vtk;

use crate::error::ReadError;
use crate::hits::names_of_walls;
use crate::message::seconds;
use crate::provenance;
use crate::records::Records;
use crate::tables::{
    Bodies, CONTACTS, CONTACTS_METADATA, Contacts, PELLETS, Table, TableKind, Tables, read_tables,
};
use mcap::records::Record;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Rows of pellets or contacts that are held before they are written [-].
const ROWS_AT_ONCE: usize = 500_000;

/// What a recording is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExportFormat {
    /// Text with commas, a file for each table.
    Csv,
    /// Columns with types, a file for each table.
    Parquet,
    /// Points and surfaces for each frame, listed over time.
    Vtk,
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exported {
    /// The files to open, from the directory: of VTK the lists over time, otherwise all.
    pub files: Vec<PathBuf>,
    /// Frames written [-].
    pub frames: usize,
    /// Whether the recording ends in the middle; what was written is then that before the cut.
    pub is_cut_off: bool,
}

/// An export that did not come about.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The recording cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A file could not be written.
    #[error("cannot write {}: {source}; free some space there or choose another directory", path.display())]
    Output {
        /// Which file or directory.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

/// Writes a recording into a directory, which is made where it does not exist.
///
/// # Errors
/// The recording cannot be read, is none of ours, or is damaged; or a file cannot be written.
pub fn export(
    recording: impl AsRef<Path>,
    format: ExportFormat,
    directory: impl AsRef<Path>,
) -> Result<Exported, ExportError> {
    let recording = recording.as_ref();
    provenance::check(recording)?;
    let mut output = Output::create(directory.as_ref())?;
    match format {
        ExportFormat::Csv => tables(recording, &mut output, csv::Sheet::create),
        ExportFormat::Parquet => tables(recording, &mut output, parquet::Sheet::create),
        ExportFormat::Vtk => scene::write(recording, &mut output),
    }
}

/// A file that takes a table in parts.
trait Sheet {
    /// Ending of its name.
    const ENDING: &'static str;

    /// Writes more rows.
    fn append(&mut self, table: &Table) -> io::Result<()>;

    /// Writes what is still held, and the end.
    fn finish(self) -> io::Result<()>;
}

/// Writes all tables of a recording, pellets and contacts in parts.
fn tables<S: Sheet>(
    recording: &Path,
    output: &mut Output,
    create: impl Fn(BufWriter<File>, &Table, &Tables) -> io::Result<S>,
) -> Result<Exported, ExportError> {
    let kinds: Vec<TableKind> = TableKind::ALL
        .into_iter()
        .filter(|kind| !matches!(kind, TableKind::Bodies | TableKind::Contacts))
        .collect();
    let tables = read_tables(recording, &kinds)?;
    for table in &tables.tables {
        let name = format!("{}.{}", table.name, S::ENDING);
        output.write(&name, |file| {
            let mut sheet = create(file, table, &tables)?;
            sheet.append(table)?;
            sheet.finish()
        })?;
    }
    let begin = |output: &mut Output, empty: &Table| {
        Parts::begin(output, empty, |file, table| create(file, table, &tables))
    };
    let frames = frames(recording, output, begin)?;
    Ok(Exported {
        files: std::mem::take(&mut output.files),
        frames,
        is_cut_off: tables.is_cut_off,
    })
}

/// Writes the pellets and contacts of all frames; how many frames of pellets there are.
fn frames<S: Sheet>(
    recording: &Path,
    output: &mut Output,
    begin: impl Fn(&mut Output, &Table) -> Result<Parts<S>, ExportError>,
) -> Result<usize, ExportError> {
    let damaged = |topic: &str, reason: String| ReadError::Damaged {
        path: recording.into(),
        reason: format!("a message of `{topic}`: {reason}"),
    };
    let of_contacts = |reason: String| damaged(CONTACTS, reason);
    let (mut bodies, mut contacts) = (Bodies::default(), Contacts::default());
    let mut bodies_parts = begin(output, &Bodies::default().table())?;
    let (mut contacts_parts, mut walls) = (None, Vec::new());
    let mut topics = BTreeMap::new();
    let mut frames = 0;
    let mut records = Records::open(recording)?;
    while let Some(record) = records.next()? {
        match record {
            Record::Metadata(metadata) if metadata.name == CONTACTS_METADATA => {
                walls = names_of_walls(&metadata.metadata).map_err(of_contacts)?;
            }
            Record::Channel(channel) => {
                if channel.topic == CONTACTS && contacts_parts.is_none() {
                    let empty = Contacts::default().table(&walls).map_err(of_contacts)?;
                    contacts_parts = Some(begin(output, &empty)?);
                }
                topics.insert(channel.id, channel.topic);
            }
            Record::Message { header, data } => {
                let time = seconds(header.log_time);
                match topics.get(&header.channel_id).map(String::as_str) {
                    Some(PELLETS) => {
                        let taken = bodies.take(time, &data);
                        taken.map_err(|reason| damaged(PELLETS, reason))?;
                        frames += 1;
                    }
                    Some(CONTACTS) => contacts.take(time, &data).map_err(of_contacts)?,
                    _ => {}
                }
            }
            _ => {}
        }
        if bodies.rows() >= ROWS_AT_ONCE {
            bodies_parts.append(&std::mem::take(&mut bodies).table())?;
        }
        if let Some(parts) = &mut contacts_parts
            && contacts.rows() >= ROWS_AT_ONCE
        {
            let full = std::mem::take(&mut contacts);
            parts.append(&full.table(&walls).map_err(of_contacts)?)?;
        }
    }
    bodies_parts.append(&bodies.table())?;
    bodies_parts.finish()?;
    if let Some(mut parts) = contacts_parts {
        parts.append(&contacts.table(&walls).map_err(of_contacts)?)?;
        parts.finish()?;
    }
    Ok(frames)
}

/// A table that is written in parts, so that memory does not grow with it.
struct Parts<S> {
    sheet: S,
    path: PathBuf,
}

impl<S: Sheet> Parts<S> {
    /// Begins the file of a table of which no row is known yet.
    fn begin(
        output: &mut Output,
        empty: &Table,
        create: impl FnOnce(BufWriter<File>, &Table) -> io::Result<S>,
    ) -> Result<Self, ExportError> {
        let name = format!("{}.{}", empty.name, S::ENDING);
        let path = output.path(&name);
        match create(output.file(&name)?, empty) {
            Ok(sheet) => Ok(Self { sheet, path }),
            Err(source) => Err(ExportError::Output { path, source }),
        }
    }

    fn append(&mut self, table: &Table) -> Result<(), ExportError> {
        let path = &self.path;
        self.sheet
            .append(table)
            .map_err(|source| ExportError::Output {
                path: path.clone(),
                source,
            })
    }

    fn finish(self) -> Result<(), ExportError> {
        let Self { sheet, path } = self;
        sheet
            .finish()
            .map_err(|source| ExportError::Output { path, source })
    }
}

/// The directory of an export.
struct Output {
    directory: PathBuf,
    files: Vec<PathBuf>,
}

impl Output {
    fn create(directory: &Path) -> Result<Self, ExportError> {
        let output = Self {
            directory: directory.into(),
            files: Vec::new(),
        };
        make(directory)?;
        Ok(output)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.directory.join(name)
    }

    /// Begins a file that is to be opened by a user, and the folders in its name.
    fn file(&mut self, name: &str) -> Result<BufWriter<File>, ExportError> {
        let file = self.part(name)?;
        self.files.push(self.path(name));
        Ok(file)
    }

    /// Begins a file that another one names.
    fn part(&mut self, name: &str) -> Result<BufWriter<File>, ExportError> {
        let path = self.path(name);
        make(path.parent().unwrap_or(&self.directory))?;
        let file = File::create(&path).map_err(|source| ExportError::Output { path, source })?;
        Ok(BufWriter::new(file))
    }

    /// Writes a whole file that is to be opened by a user.
    fn write(
        &mut self,
        name: &str,
        content: impl FnOnce(BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), ExportError> {
        let file = self.file(name)?;
        self.put(name, file, content)
    }

    /// Writes a whole file that another one names.
    fn write_part(
        &mut self,
        name: &str,
        content: impl FnOnce(BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), ExportError> {
        let file = self.part(name)?;
        self.put(name, file, content)
    }

    fn put(
        &self,
        name: &str,
        file: BufWriter<File>,
        content: impl FnOnce(BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), ExportError> {
        content(file).map_err(|source| ExportError::Output {
            path: self.path(name),
            source,
        })
    }
}

/// Makes a folder where it does not exist.
fn make(folder: &Path) -> Result<(), ExportError> {
    fs::create_dir_all(folder).map_err(|source| ExportError::Output {
        path: folder.into(),
        source,
    })
}

/// Writes what a buffer still holds, and tells if that fails.
fn flushed(mut file: BufWriter<File>) -> io::Result<()> {
    file.flush()
}
