//! One topic of a recording.

use super::writer::MessageWriter;
use foxglove::messages::{FrameTransforms, Log, PointCloud, SceneUpdate};
use foxglove::{Encode, Schema};
use mcap::McapResult;
use mcap::records::MessageHeader;
use prost::Message;
use std::io::{Seek, Write};

/// A topic and how many messages it has.
#[derive(Debug, Clone, Copy)]
pub(super) struct Channel {
    id: u16,
    count: u32,
}

/// Message types that viewers know.
#[derive(Debug, Clone, Copy)]
pub(super) enum Foxglove {
    PointCloud,
    SceneUpdate,
    FrameTransforms,
    Log,
}

/// Opens a topic of a message type that viewers know.
pub(super) fn channel_for<W: Write + Seek>(
    writer: &mut MessageWriter<W>,
    topic: &str,
    kind: Foxglove,
) -> McapResult<Channel> {
    let schema = match kind {
        Foxglove::PointCloud => PointCloud::get_schema(),
        Foxglove::SceneUpdate => SceneUpdate::get_schema(),
        Foxglove::FrameTransforms => FrameTransforms::get_schema(),
        Foxglove::Log => Log::get_schema(),
    };
    let schema = schema.expect("every published message type carries its schema");
    Channel::open(writer, topic, &schema)
}

impl Channel {
    pub(super) fn open<W: Write + Seek>(
        writer: &mut MessageWriter<W>,
        topic: &str,
        schema: &Schema,
    ) -> McapResult<Self> {
        Ok(Self {
            id: writer.open(topic, schema)?,
            count: 0,
        })
    }

    pub(super) fn is_empty(self) -> bool {
        self.count == 0
    }

    /// Writes a message at a log time [ns].
    pub(super) fn write<W: Write + Seek>(
        &mut self,
        writer: &mut MessageWriter<W>,
        time: u64,
        message: &impl Message,
    ) -> McapResult<()> {
        self.write_bytes(writer, time, &message.encode_to_vec())
    }

    /// Writes the bytes of a message at a log time [ns].
    pub(super) fn write_bytes<W: Write + Seek>(
        &mut self,
        writer: &mut MessageWriter<W>,
        time: u64,
        bytes: &[u8],
    ) -> McapResult<()> {
        let header = MessageHeader {
            channel_id: self.id,
            sequence: self.count,
            log_time: time,
            publish_time: time,
        };
        self.count += 1;
        writer.write_message(&header, bytes)
    }
}
