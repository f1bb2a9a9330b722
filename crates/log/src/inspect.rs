//! What a recording holds.

use crate::error::ReadError;
use crate::message::seconds;
use crate::records::Records;
use mcap::records::{ChunkIndex, MessageHeader, Record};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// What a recording holds, read from its first byte to its last whole record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Inspection {
    /// Size of the file [B].
    pub file_bytes: u64,
    /// Program that wrote it.
    pub library: String,
    /// Channels, in order of topic.
    pub channels: Vec<ChannelInspection>,
    /// Metadata, by name.
    pub metadata: BTreeMap<String, BTreeMap<String, String>>,
    /// Attachments.
    pub attachments: Vec<AttachmentInspection>,
    /// Frames of pellets [-].
    pub frames: u64,
    /// Messages of all channels [-].
    pub messages: u64,
    /// Simulated time from the first message to the last [s].
    pub duration_s: f64,
    /// How chunks are compressed, such as `zstd`; unknown where the file is cut off before its index.
    pub compression: Option<String>,
    /// Bytes before compression over bytes after it [-]; unknown where the compression is.
    pub compression_ratio: Option<f64>,
    /// Whether the file ends in the middle; what is told is then that before the cut.
    pub is_cut_off: bool,
}

/// One channel of a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChannelInspection {
    /// Topic.
    pub topic: String,
    /// Name of its message type.
    pub schema: String,
    /// How its messages are encoded.
    pub encoding: String,
    /// Messages [-].
    pub messages: u64,
    /// Bytes of its messages before compression [B].
    pub bytes: u64,
    /// Simulated time of its first message [s].
    pub first_s: Option<f64>,
    /// Simulated time of its last message [s].
    pub last_s: Option<f64>,
}

/// One attachment of a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AttachmentInspection {
    /// File name.
    pub name: String,
    /// Kind of content.
    pub media_type: String,
    /// Size [B].
    pub bytes: u64,
}

/// Reads a whole recording and tells what it holds; every checksum is checked on the way.
///
/// # Errors
/// The file is missing, is no MCAP file, or is damaged. One that is cut off is none of these.
pub fn inspect(path: impl AsRef<Path>) -> Result<Inspection, ReadError> {
    let path = path.as_ref();
    let mut records = Records::open(path)?;
    let mut findings = Findings::default();
    while let Some(record) = records.next()? {
        findings.take(record);
    }
    let file_bytes = fs::metadata(path)
        .map_err(|source| ReadError::Io {
            path: path.into(),
            source,
        })?
        .len();
    Ok(findings.inspection(file_bytes, records.is_cut_off()))
}

#[derive(Default)]
struct Findings {
    library: String,
    schemas: BTreeMap<u16, String>,
    channels: BTreeMap<u16, ChannelInspection>,
    metadata: BTreeMap<String, BTreeMap<String, String>>,
    attachments: Vec<AttachmentInspection>,
    chunks: Vec<ChunkIndex>,
}

impl Findings {
    fn take(&mut self, record: Record) {
        match record {
            Record::Header(header) => self.library = header.library,
            Record::Schema { header, .. } => {
                self.schemas.insert(header.id, header.name);
            }
            // The index at the end of the file repeats every channel.
            Record::Channel(channel) => {
                let schema = self.schemas.get(&channel.schema_id).cloned();
                self.channels
                    .entry(channel.id)
                    .or_insert_with(|| ChannelInspection {
                        topic: channel.topic,
                        schema: schema.unwrap_or_default(),
                        encoding: channel.message_encoding,
                        messages: 0,
                        bytes: 0,
                        first_s: None,
                        last_s: None,
                    });
            }
            Record::Message { header, data } => self.count(&header, data.len()),
            Record::Attachment { header, data, .. } => {
                self.attachments.push(AttachmentInspection {
                    name: header.name,
                    media_type: header.media_type,
                    bytes: data.len() as u64,
                });
            }
            Record::Metadata(metadata) => {
                self.metadata.insert(metadata.name, metadata.metadata);
            }
            Record::ChunkIndex(index) => self.chunks.push(index),
            _ => {}
        }
    }

    fn count(&mut self, header: &MessageHeader, bytes: usize) {
        if let Some(channel) = self.channels.get_mut(&header.channel_id) {
            let time = seconds(header.log_time);
            channel.messages += 1;
            channel.bytes += bytes as u64;
            channel.first_s = Some(channel.first_s.map_or(time, |first| first.min(time)));
            channel.last_s = Some(channel.last_s.map_or(time, |last| last.max(time)));
        }
    }

    fn inspection(self, file_bytes: u64, is_cut_off: bool) -> Inspection {
        let mut channels: Vec<_> = self.channels.into_values().collect();
        channels.sort_by(|a, b| a.topic.cmp(&b.topic));
        let first = channels.iter().filter_map(|channel| channel.first_s);
        let last = channels.iter().filter_map(|channel| channel.last_s);
        let (first, last) = (
            first.fold(f64::INFINITY, f64::min),
            last.fold(f64::NEG_INFINITY, f64::max),
        );
        let names: BTreeSet<&str> = self
            .chunks
            .iter()
            .map(|chunk| match chunk.compression.as_str() {
                "" => "none",
                name => name,
            })
            .collect();
        let raw: u64 = self
            .chunks
            .iter()
            .map(|chunk| chunk.uncompressed_size)
            .sum();
        let packed: u64 = self.chunks.iter().map(|chunk| chunk.compressed_size).sum();
        Inspection {
            file_bytes,
            library: self.library,
            frames: channels
                .iter()
                .filter(|channel| channel.topic == "/pellets")
                .map(|channel| channel.messages)
                .sum(),
            messages: channels.iter().map(|channel| channel.messages).sum(),
            duration_s: (last - first).max(0.0),
            compression: (!names.is_empty())
                .then(|| names.into_iter().collect::<Vec<_>>().join(", ")),
            compression_ratio: (packed > 0).then(|| raw as f64 / packed as f64),
            metadata: self.metadata,
            attachments: self.attachments,
            channels,
            is_cut_off,
        }
    }
}
