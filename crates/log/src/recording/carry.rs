//! A recording carried on: what its earlier part holds is written again, and more behind it.
//!
//! No file of this kind can be written on once it is cut off.

use super::channel::Channel;
use super::{HitChannels, Recording};
use crate::error::ReadError;
use crate::records::Records;
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
        let mut schemas = BTreeMap::new();
        let mut channels: BTreeMap<u16, (String, Channel)> = BTreeMap::new();
        while self.writer.messages() < mark.messages {
            let record = earlier.next().map_err(CarryError::Unreadable)?;
            match record {
                None => return Err(CarryError::Short(self.writer.messages())),
                Some(Record::Schema { header, data }) => {
                    let schema = Schema::new(header.name, header.encoding, data.into_owned());
                    schemas.insert(header.id, schema);
                }
                Some(Record::Channel(channel)) if !channels.contains_key(&channel.id) => {
                    let schema = schemas.get(&channel.schema_id).ok_or(CarryError::Other)?;
                    // A topic that is there already is given again.
                    let opened = Channel::open(&mut self.writer, &channel.topic, schema)?;
                    channels.insert(channel.id, (channel.topic, opened));
                }
                Some(Record::Message { header, data }) => {
                    let (_, channel) = channels
                        .get_mut(&header.channel_id)
                        .ok_or(CarryError::Other)?;
                    channel.write_bytes(&mut self.writer, header.log_time, &data)?;
                }
                Some(_) => {}
            }
        }
        self.has_spheres = mark.has_spheres;
        if self.mark() != *mark {
            return Err(CarryError::Other);
        }
        for (topic, channel) in channels.into_values() {
            self.adopt(&topic, channel);
        }
        Ok(())
    }

    /// Goes on with a topic where its earlier part ended.
    fn adopt(&mut self, topic: &str, channel: Channel) {
        if channel.is_empty() {
            return;
        }
        let hits = self.hit_channels.as_mut();
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
