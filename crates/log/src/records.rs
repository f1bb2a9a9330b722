//! The records of a recording, one after another, as far as the file is whole.

use crate::error::ReadError;
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{McapError, parse_record, records::Record};
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

/// Longest record, and longest chunk once it is open, that is believed of a file that is shorter [B]: a frame of three
/// million pellets, their contacts among them, has no more than that.
const LONGEST: usize = 512 << 20;
/// Bytes read at once at most [B].
const BLOCK: usize = 1 << 20;

/// Reads a file record by record; chunks are checked and opened, and one that is cut off is left out.
pub(crate) struct Records {
    path: PathBuf,
    source: BufReader<File>,
    reader: LinearReader,
    is_first: bool,
    is_cut_off: bool,
}

impl Records {
    pub(crate) fn open(path: &Path) -> Result<Self, ReadError> {
        let io = |source: std::io::Error| ReadError::Io {
            path: path.into(),
            source,
        };
        if path.is_dir() {
            return Err(ReadError::Directory { path: path.into() });
        }
        let file = File::open(path).map_err(|source| match source.kind() {
            std::io::ErrorKind::NotFound => ReadError::Missing { path: path.into() },
            _ => io(source),
        })?;
        let length = file.metadata().map_err(io)?.len();
        let longest = usize::try_from(length).unwrap_or(usize::MAX).max(LONGEST);
        let options = LinearReaderOptions::default()
            .with_record_length_limit(longest)
            // Nothing of a chunk is believed before all of it has been checked.
            .with_prevalidate_chunk_crcs(true)
            .with_validate_data_section_crc(true)
            .with_validate_summary_section_crc(true);
        Ok(Self {
            path: path.into(),
            source: BufReader::new(file),
            reader: LinearReader::new_with_options(options),
            is_first: true,
            is_cut_off: false,
        })
    }

    /// Whether the file ended in the middle; known when the last record has been read.
    pub(crate) fn is_cut_off(&self) -> bool {
        self.is_cut_off
    }

    /// The next record; nothing at the end, or where the file is cut off.
    pub(crate) fn next(&mut self) -> Result<Option<Record<'static>>, ReadError> {
        loop {
            let Some(event) = self.reader.next_event() else {
                return Ok(None);
            };
            match event {
                Ok(LinearReadEvent::ReadRequest(need)) => {
                    // A record may say that it is longer than the file: memory grows with what is there.
                    let read = self
                        .source
                        .read(self.reader.insert(need.min(BLOCK)))
                        .map_err(|source| ReadError::Io {
                            path: self.path.clone(),
                            source,
                        })?;
                    self.reader.notify_read(read);
                }
                Ok(LinearReadEvent::Record { opcode, data }) => {
                    self.is_first = false;
                    let record = parse_record(opcode, data).map(Record::into_owned);
                    return record.map(Some).map_err(|error| self.damaged(&error));
                }
                Err(McapError::BadMagic) if self.is_first => {
                    return Err(ReadError::NotMcap {
                        path: self.path.clone(),
                    });
                }
                Err(McapError::UnexpectedEof | McapError::UnexpectedEoc) if !self.is_first => {
                    self.is_cut_off = true;
                    return Ok(None);
                }
                Err(McapError::UnexpectedEof) => {
                    return Err(ReadError::NotMcap {
                        path: self.path.clone(),
                    });
                }
                Err(error) => return Err(self.damaged(&error)),
            }
        }
    }

    fn damaged(&self, error: &McapError) -> ReadError {
        ReadError::Damaged {
            path: self.path.clone(),
            reason: error.to_string(),
        }
    }
}
