//! Pellets read back, frame by frame.

use crate::error::ReadError;
use crate::message::{pellets, seconds};
use crate::records::Records;
use foxglove::messages::PointCloud;
use mcap::records::Record;
use prost::Message;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// One pellet as recorded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PelletRecord {
    /// Permanent number [-].
    pub id: u32,
    /// Center, in the world [m].
    pub position: [f32; 3],
    /// Radius [m].
    pub radius: f32,
    /// Speed [m/s].
    pub speed: f32,
    /// Greatest normal force of its contacts in the last step [N].
    pub force: f32,
}

/// All pellets at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameRecord {
    /// Simulated time [s].
    pub time: f64,
    /// Pellets, sorted by their number.
    pub pellets: Vec<PelletRecord>,
}

/// The frames of a recording, one after another.
pub struct Frames {
    path: PathBuf,
    records: Records,
    channels: BTreeSet<u16>,
    is_done: bool,
}

/// Opens a recording to read its frames; of a file that is cut off, those before the cut.
///
/// # Errors
/// The file cannot be opened. One that is no recording shows itself at the first frame.
pub fn read_frames(path: impl AsRef<Path>) -> Result<Frames, ReadError> {
    let path = path.as_ref();
    Ok(Frames {
        path: path.into(),
        records: Records::open(path)?,
        channels: BTreeSet::new(),
        is_done: false,
    })
}

/// The text of an attachment, such as `scene.toml`.
///
/// # Errors
/// The file cannot be read, or holds no such attachment.
pub fn read_attachment(path: impl AsRef<Path>, name: &str) -> Result<String, ReadError> {
    let path = path.as_ref();
    let mut records = Records::open(path)?;
    while let Some(record) = records.next()? {
        if let Record::Attachment { header, data, .. } = record
            && header.name == name
        {
            return Ok(String::from_utf8_lossy(&data).into_owned());
        }
    }
    Err(ReadError::NoAttachment {
        path: path.into(),
        name: name.into(),
    })
}

impl Frames {
    fn advance(&mut self) -> Result<Option<FrameRecord>, ReadError> {
        while let Some(record) = self.records.next()? {
            match record {
                Record::Channel(channel) if channel.topic == "/pellets" => {
                    self.channels.insert(channel.id);
                }
                Record::Message { header, data } if self.channels.contains(&header.channel_id) => {
                    let pellets = PointCloud::decode(data.as_ref())
                        .map_err(|error| error.to_string())
                        .and_then(|cloud| pellets::pellets(&cloud))
                        .map_err(|reason| ReadError::Damaged {
                            path: self.path.clone(),
                            reason: format!("a frame of `/pellets` cannot be decoded: {reason}"),
                        })?;
                    return Ok(Some(FrameRecord {
                        time: seconds(header.log_time),
                        pellets,
                    }));
                }
                _ => {}
            }
        }
        Ok(None)
    }
}

impl Iterator for Frames {
    type Item = Result<FrameRecord, ReadError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_done {
            return None;
        }
        let frame = self.advance();
        self.is_done = !matches!(frame, Ok(Some(_)));
        frame.transpose()
    }
}
