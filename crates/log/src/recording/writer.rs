//! The writer of a recording, which knows what it has written.

use crate::live::Program;
use foxglove::{RawChannel, Schema};
use mcap::records::MessageHeader;
use mcap::{McapResult, Writer};
use std::collections::BTreeMap;
use std::io::{Seek, Write};
use std::ops::{Deref, DerefMut};
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// A writer that counts and sums the messages, and shows them to whoever watches.
pub(super) struct MessageWriter<W: Write + Seek> {
    inner: Writer<W>,
    messages: u64,
    sum: Box<Xxh3>,
    live: Option<LiveTopics>,
}

/// What viewers are shown, and its topics by their number in the file.
struct LiveTopics {
    program: Program,
    channels: BTreeMap<u16, Arc<RawChannel>>,
}

impl<W: Write + Seek> MessageWriter<W> {
    pub(super) fn new(inner: Writer<W>, live: Option<Program>) -> Self {
        Self {
            inner,
            messages: 0,
            sum: Box::default(),
            live: live.map(|program| LiveTopics {
                program,
                channels: BTreeMap::new(),
            }),
        }
    }

    /// Opens a topic of protobuf; its number. One that is there already is given again.
    pub(super) fn open(&mut self, topic: &str, schema: &Schema) -> McapResult<u16> {
        let number = self
            .inner
            .add_schema(&schema.name, &schema.encoding, &schema.data)?;
        let id = self
            .inner
            .add_channel(number, topic, "protobuf", &BTreeMap::new())?;
        if let Some(live) = &mut self.live {
            let program = &live.program;
            let opened = || program.open(topic, schema);
            live.channels.entry(id).or_insert_with(opened);
        }
        Ok(id)
    }

    /// Writes a message.
    pub(super) fn write_message(&mut self, header: &MessageHeader, bytes: &[u8]) -> McapResult<()> {
        self.messages += 1;
        self.sum.update(&header.log_time.to_le_bytes());
        self.sum.update(bytes);
        self.inner.write_to_known_channel(header, bytes)?;
        if let Some(live) = &self.live
            && let Some(channel) = live.channels.get(&header.channel_id)
        {
            live.program.tell(channel, header.log_time, bytes);
        }
        Ok(())
    }

    /// Sets the clock of whoever watches [ns].
    pub(super) fn show_time(&self, time: u64) {
        if let Some(live) = &self.live {
            live.program.set_time(time);
        }
    }

    /// Messages so far [-].
    pub(super) fn messages(&self) -> u64 {
        self.messages
    }

    /// Sum of their times and bytes.
    pub(super) fn sum(&self) -> u128 {
        self.sum.digest128()
    }

    pub(super) fn into_inner(self) -> W {
        self.inner.into_inner()
    }
}

impl<W: Write + Seek> Deref for MessageWriter<W> {
    type Target = Writer<W>;

    fn deref(&self) -> &Writer<W> {
        &self.inner
    }
}

impl<W: Write + Seek> DerefMut for MessageWriter<W> {
    fn deref_mut(&mut self) -> &mut Writer<W> {
        &mut self.inner
    }
}
