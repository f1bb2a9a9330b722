//! One pass over a recording, in memory that does not grow with its length.

use super::curve::Curve;
use super::frames::{FrameStore, ReplayFrame};
use super::hits::HitFindings;
use crate::error::ReadError;
use crate::hits::{HitFacts, METADATA};
use crate::message::{hits, pellets, seconds, series};
use crate::provenance::{Provenance, RUN_METADATA};
use crate::records::Records;
use crate::walls::Walls;
use foxglove::messages::{FrameTransforms, Log, PointCloud, SceneUpdate};
use mcap::records::{MessageHeader, Record};
use prost::Message;
use std::collections::BTreeMap;
use std::path::Path;

/// Events kept at most [-].
const MOST_EVENTS: usize = 500;

/// All that a report shows.
pub(super) struct Gathered {
    /// Facts of the run.
    pub(super) facts: BTreeMap<String, String>,
    /// Text of the scene.
    pub(super) scene: Option<String>,
    pub(super) frames: FrameStore,
    pub(super) walls: Walls,
    /// Quantities over time, by topic and name.
    pub(super) curves: BTreeMap<String, Vec<(String, Curve)>>,
    pub(super) hits: HitFindings,
    /// Times [s] and words of what happened, the first of them.
    pub(super) events: Vec<(f64, String)>,
    /// How many there are [-].
    pub(super) event_count: u64,
    /// Moment of the last record [s].
    pub(super) end: f64,
    /// Whether the file ends in the middle.
    pub(super) is_cut_off: bool,
}

impl Gathered {
    /// Of nothing yet; so many pellets times frames will be kept [-].
    fn of_nothing(capacity: usize) -> Self {
        Self {
            facts: BTreeMap::new(),
            scene: None,
            frames: FrameStore::new(capacity),
            walls: Walls::default(),
            curves: BTreeMap::new(),
            hits: HitFindings::new(),
            events: Vec::new(),
            event_count: 0,
            end: 0.0,
            is_cut_off: false,
        }
    }

    /// Reads a recording; of its frames so many pellets times frames are kept [-].
    pub(super) fn read(path: &Path, capacity: usize) -> Result<Self, ReadError> {
        let mut records = Records::open(path)?;
        let mut provenance = Provenance::new(path);
        let mut channels = Channels::default();
        let mut gathered = Self::of_nothing(capacity);
        let damaged = |reason: String| ReadError::Damaged {
            path: path.into(),
            reason,
        };
        while let Some(record) = records.next()? {
            provenance.take(&record)?;
            match record {
                Record::Schema { header, data } => channels.take_schema(header.id, &data),
                Record::Channel(channel) => channels.take(channel),
                Record::Message { header, data } => {
                    let (topic, names) = channels.of(header.channel_id);
                    gathered
                        .take(topic, names, &header, &data)
                        .map_err(|reason| damaged(format!("a message of `{topic}`: {reason}")))?;
                }
                Record::Attachment { header, data, .. } if header.name == "scene.toml" => {
                    gathered.scene = Some(String::from_utf8_lossy(&data).into_owned());
                }
                Record::Metadata(metadata) if metadata.name == METADATA => {
                    let facts = HitFacts::read(&metadata.metadata).map_err(|reason| {
                        damaged(format!("the metadata `{METADATA}`: {reason}"))
                    })?;
                    gathered.hits.is_softened = facts.is_softened;
                    gathered.hits.walls = Some(facts.walls);
                }
                Record::Metadata(metadata) if metadata.name == RUN_METADATA => {
                    gathered.facts = metadata.metadata;
                }
                _ => {}
            }
        }
        gathered.is_cut_off = records.is_cut_off();
        provenance.finish(gathered.is_cut_off)?;
        Ok(gathered)
    }

    /// How many lines of what happened were left out, in words.
    pub(super) fn omission(&self) -> Option<String> {
        let [shown, of] = [self.events.len() as u64, self.event_count].map(crate::figures::count);
        (shown != of).then(|| format!("{shown} of {of} lines of what happened, the first"))
    }

    fn take(
        &mut self,
        topic: &str,
        names: &[String],
        header: &MessageHeader,
        data: &[u8],
    ) -> Result<(), String> {
        let time = seconds(header.log_time);
        self.end = self.end.max(time);
        match topic {
            "/pellets" => {
                let cloud: PointCloud = decoded(data)?;
                self.frames.push(ReplayFrame {
                    time,
                    pellets: pellets::pellets(&cloud)?,
                    walls: self.walls.places(),
                });
            }
            "/equipment" => {
                self.walls.take_update(decoded::<SceneUpdate>(data)?);
            }
            "/tf" => {
                self.walls
                    .take_transforms(decoded::<FrameTransforms>(data)?);
            }
            "/log" => {
                let log: Log = decoded(data)?;
                self.event_count += 1;
                if self.events.len() < MOST_EVENTS {
                    self.events.push((time, log.message));
                }
            }
            "/hits" => {
                for hit in hits::hits(&decoded(data)?)? {
                    self.hits.worst.enter(&hit);
                }
            }
            "/hits/classes" => self.hits.classes = hits::classes(&decoded(data)?)?,
            _ if topic.starts_with("/meters/") || topic.starts_with("/ledger/") => {
                let values = series::decode(data).ok_or("it is no row of numbers")?;
                if values.len() != names.len() {
                    return Err("it has another number of values than its schema".into());
                }
                let curves = self.curves.entry(topic.to_owned()).or_insert_with(|| {
                    let named = |name: &String| (name.clone(), Curve::default());
                    names.iter().map(named).collect()
                });
                for ((_, curve), value) in curves.iter_mut().zip(values) {
                    curve.push(time, value);
                }
            }
            _ => {}
        }
        Ok(())
    }
}

fn decoded<M: Message + Default>(data: &[u8]) -> Result<M, String> {
    M::decode(data).map_err(|error| error.to_string())
}

/// Topics and what the values on them are called.
#[derive(Default)]
struct Channels {
    /// Names of the values of each schema.
    names: BTreeMap<u16, Vec<String>>,
    /// Topic and schema of each channel.
    topics: BTreeMap<u16, (String, u16)>,
}

impl Channels {
    fn take_schema(&mut self, id: u16, data: &[u8]) {
        self.names
            .insert(id, series::names(data).unwrap_or_default());
    }

    fn take(&mut self, channel: mcap::records::Channel) {
        self.topics
            .insert(channel.id, (channel.topic, channel.schema_id));
    }

    fn of(&self, channel: u16) -> (&str, &[String]) {
        self.topics
            .get(&channel)
            .map_or(("", &[]), |(topic, schema)| {
                let names = self.names.get(schema).map_or(&[][..], Vec::as_slice);
                (topic.as_str(), names)
            })
    }
}

#[cfg(test)]
mod tests {
    use super::{Gathered, MOST_EVENTS};
    use crate::message::event::{Gravity, message};
    use mcap::records::MessageHeader;
    use prost::Message;

    #[test]
    fn lines_that_find_no_room_are_told() {
        let mut gathered = Gathered::of_nothing(0);
        let line = message(0.0, Gravity::Information, "gate").encode_to_vec();
        let header = MessageHeader {
            channel_id: 0,
            sequence: 0,
            log_time: 0,
            publish_time: 0,
        };
        for _ in 0..MOST_EVENTS {
            let taken = gathered.take("/log", &[], &header, &line);
            taken.expect("it is a line of the log");
        }
        assert_eq!(gathered.omission(), None);
        let taken = gathered.take("/log", &[], &header, &line);
        taken.expect("it is a line of the log");
        let told = "500 of 501 lines of what happened, the first";
        assert_eq!(gathered.omission().as_deref(), Some(told));
    }
}
