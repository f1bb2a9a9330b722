//! A recording written again: to go on behind its earlier part, or to leave frames out.
//!
//! No file of this kind can be written on once it is cut off, and nothing can be taken out of it.

use super::channel::Channel;
use super::writer::MessageWriter;
use super::{HitChannels, Recording};
use crate::error::ReadError;
use crate::message::spheres;
use crate::records::Records;
use crate::tables::CONTACTS;
use foxglove::Schema;
use mcap::McapError;
use mcap::records::Record;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{Seek, Write};

/// How far a recording is, and what it holds up to there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Mark {
    /// Messages [-].
    pub(crate) messages: u64,
    /// Sum of their times and bytes.
    sum: u128,
    /// Whether the last frame drew spheres.
    has_spheres: bool,
}

/// An earlier part that cannot be carried on.
#[derive(Debug)]
pub(crate) enum CarryError {
    /// It cannot be read.
    Unreadable(ReadError),
    /// It ends before the mark [-].
    Short(u64),
    /// It is another recording.
    Other,
    /// The new file cannot be written.
    Unwritable(McapError),
}

impl From<McapError> for CarryError {
    fn from(error: McapError) -> Self {
        Self::Unwritable(error)
    }
}

impl<W: Write + Seek> Recording<W> {
    /// How far the recording is.
    pub(crate) fn mark(&self) -> Mark {
        Mark {
            messages: self.writer.messages(),
            sum: self.writer.sum(),
            has_spheres: self.has_spheres,
        }
    }

    /// Writes the messages of an earlier part again, up to a mark, into a recording that has none.
    pub(crate) fn carry(&mut self, earlier: &mut Records, mark: &Mark) -> Result<(), CarryError> {
        let mut topics = Topics::default();
        while self.writer.messages() < mark.messages {
            let record = earlier.next().map_err(CarryError::Unreadable)?;
            let record = record.ok_or(CarryError::Short(self.writer.messages()))?;
            topics.write_again(&mut self.writer, record, |_| true)?;
        }
        self.has_spheres = mark.has_spheres;
        if self.mark() != *mark {
            return Err(CarryError::Other);
        }
        for (topic, channel) in topics.channels.into_values() {
            self.adopt(&topic, channel);
        }
        Ok(())
    }

    /// Writes all messages of another recording again but for frames whose moment [ns] is not kept, into a recording that
    /// has none; the first frame is kept in any case.
    pub(crate) fn thin(
        &mut self,
        whole: &mut Records,
        is_kept: impl Fn(u64) -> bool,
    ) -> Result<(), CarryError> {
        let mut topics = Topics::default();
        let mut first = None;
        while let Some(record) = whole.next().map_err(CarryError::Unreadable)? {
            topics.write_again(&mut self.writer, record, |message| {
                let mut is_of_first = || *first.get_or_insert(message.time) == message.time;
                !message.is_of_frame() || is_of_first() || is_kept(message.time)
            })?;
        }
        Ok(())
    }

    /// Goes on with a topic where its earlier part ended.
    fn adopt(&mut self, topic: &str, channel: Channel) {
        if channel.is_empty() {
            return;
        }
        let hits = self.hit_channels.as_mut();
        let contacts = self.contacts_channel.as_mut();
        let place = match topic {
            "/pellets" => &mut self.pellets_channel,
            "/pellets/spheres" => &mut self.spheres_channel,
            "/equipment" => &mut self.equipment_channel,
            "/tf" => &mut self.transforms_channel,
            "/log" => &mut self.log_channel,
            "/ledger/mass" => self.mass_channel.insert(channel),
            "/ledger/energy" => self.energy_channel.insert(channel),
            _ => {
                if let Some(meter) = topic.strip_prefix("/meters/") {
                    self.meter_channels.insert(meter.into(), channel);
                } else if let Some(place) = contacts.filter(|_| topic == CONTACTS) {
                    *place = channel;
                } else if let Some(place) = hits.and_then(|hits| hits.of(topic)) {
                    *place = channel;
                }
                return;
            }
        };
        *place = channel;
    }
}

impl HitChannels {
    fn of(&mut self, topic: &str) -> Option<&mut Channel> {
        match topic {
            "/hits" => Some(&mut self.hits),
            "/hits/classes" => Some(&mut self.classes),
            "/hits/worst" => Some(&mut self.worst),
            "/hits/worst/log" => Some(&mut self.worst_in_words),
            _ => None,
        }
    }
}

/// Topics whose messages are written again.
#[derive(Default)]
struct Topics {
    schemas: BTreeMap<u16, Schema>,
    channels: BTreeMap<u16, (String, Channel)>,
}

/// A message that may be written again.
struct Message<'a> {
    topic: &'a str,
    time: u64,
    bytes: &'a [u8],
}

impl Message<'_> {
    /// Whether it is a part of a frame, and nobody misses it where the rest of that is left out.
    fn is_of_frame(&self) -> bool {
        match self.topic {
            "/pellets" | CONTACTS | "/tf" => true,
            // Spheres that are taken away would else stay forever.
            "/pellets/spheres" => !spheres::is_removal(self.bytes),
            _ => false,
        }
    }
}

impl Topics {
    /// Takes a record; of a message, writes it again if it is kept.
    fn write_again<W: Write + Seek>(
        &mut self,
        writer: &mut MessageWriter<W>,
        record: Record,
        mut is_kept: impl FnMut(&Message) -> bool,
    ) -> Result<(), CarryError> {
        match record {
            Record::Schema { header, data } => {
                let schema = Schema::new(header.name, header.encoding, data.into_owned());
                self.schemas.insert(header.id, schema);
            }
            Record::Channel(channel) if !self.channels.contains_key(&channel.id) => {
                let schema = self.schemas.get(&channel.schema_id);
                let schema = schema.ok_or(CarryError::Other)?;
                // A topic that is there already is given again.
                let opened = Channel::open(writer, &channel.topic, schema)?;
                self.channels.insert(channel.id, (channel.topic, opened));
            }
            Record::Message { header, data } => {
                let channel = self.channels.get_mut(&header.channel_id);
                let (topic, channel) = channel.ok_or(CarryError::Other)?;
                let message = Message {
                    topic,
                    time: header.log_time,
                    bytes: &data,
                };
                if is_kept(&message) {
                    channel.write_bytes(writer, header.log_time, &data)?;
                }
            }
            _ => {}
        }
        Ok(())
    }
}
