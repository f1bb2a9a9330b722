//! Hits read back from a recording.

use crate::error::ReadError;
use crate::message::{hits, seconds, series};
use crate::provenance::Provenance;
use crate::records::Records;
use mcap::records::Record;
use pelletflow_sim::{Hit, HitClass, HitClassKey, Simulation};
use prost::Message;
use std::collections::BTreeMap;
use std::path::Path;

/// Name of the metadata that goes with hits.
pub(crate) const METADATA: &str = "pelletflow.hits";
/// Its key of the threshold [N].
pub(crate) const THRESHOLD: &str = "threshold_n";
/// Its key that tells whether some material is softer than it really is.
pub(crate) const IS_SOFTENED: &str = "is_softened";
/// Its key of the names of the walls, as a JSON list.
pub(crate) const WALLS: &str = "walls";

/// What the metadata that goes with hits tells.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct HitFacts {
    /// Force from which on every hit is kept in full [N].
    threshold: f64,
    /// Whether some material is softer than it really is.
    pub(crate) is_softened: bool,
    /// Names of the walls, by index.
    pub(crate) walls: Vec<String>,
}

impl HitFacts {
    /// Reads them; what is wrong with them.
    pub(crate) fn read(metadata: &BTreeMap<String, String>) -> Result<Self, String> {
        let entry = |key: &str| metadata.get(key).map_or("", String::as_str);
        Ok(Self {
            threshold: entry(THRESHOLD)
                .parse()
                .map_err(|error| format!("its `{THRESHOLD}` is no force: {error}"))?,
            is_softened: entry(IS_SOFTENED) == "true",
            walls: names_of_walls(metadata)?,
        })
    }
}

/// Names of the walls, by index, in metadata that has them; what is wrong with it.
pub(crate) fn names_of_walls(metadata: &BTreeMap<String, String>) -> Result<Vec<String>, String> {
    serde_json::from_str(metadata.get(WALLS).map_or("", String::as_str))
        .map_err(|error| format!("its `{WALLS}` are no list of names: {error}"))
}

/// A wall as a partner of a pellet, by its index, in words.
pub(crate) fn wall_in_words(walls: &[String], wall: usize) -> String {
    walls
        .get(wall)
        .map_or_else(|| format!("wall {wall}"), |name| format!("wall `{name}`"))
}

/// All that a recording holds of hits.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RecordedHits {
    /// Hits kept in full, in the order in which they ended.
    pub hits: Vec<Hit>,
    /// The sketch of all hits, by partner and force.
    pub classes: BTreeMap<HitClassKey, HitClass>,
    /// Names of the walls, by index.
    pub walls: Vec<String>,
    /// Force from which on every hit is kept in full [N].
    pub threshold: f64,
    /// Whether some material was softer in the run than it really is.
    pub is_softened: bool,
    /// Pellets put in up to the last frame [-].
    pub pellets: u64,
    /// Moment of the last record [s].
    pub end: f64,
    /// Whether the file ends in the middle; what is told is then that before the cut.
    pub is_cut_off: bool,
}

impl RecordedHits {
    /// The hits of a run that were not taken from it, with those still open.
    pub(crate) fn of(simulation: &mut Simulation) -> Self {
        let open = simulation.hits_with_open();
        let mut hits = simulation.take_hits();
        hits.extend_from_slice(open.rows());
        let setup = simulation.model().setup();
        Self {
            hits,
            classes: open.classes().clone(),
            walls: setup.walls.iter().map(|wall| wall.name.clone()).collect(),
            threshold: setup
                .hits
                .map_or(f64::INFINITY, |request| request.threshold),
            is_softened: setup.is_softened(),
            pellets: simulation.mass_ledger().inserted.count,
            end: simulation.time(),
            is_cut_off: false,
        }
    }
}

/// Reads the hits of a recording; of a file that is cut off, those before the cut.
///
/// # Errors
/// The file cannot be read, is no recording, is damaged, or holds no hits because none were followed.
pub fn read_hits(path: impl AsRef<Path>) -> Result<RecordedHits, ReadError> {
    let path = path.as_ref();
    let damaged = |reason: String| ReadError::Damaged {
        path: path.into(),
        reason,
    };
    let mut records = Records::open(path)?;
    let mut read = RecordedHits::default();
    let mut topics: BTreeMap<u16, String> = BTreeMap::new();
    let mut has_hits = false;
    let mut provenance = Provenance::new(path);
    while let Some(record) = records.next()? {
        provenance.take(&record)?;
        match record {
            Record::Metadata(metadata) if metadata.name == METADATA => {
                has_hits = true;
                let facts = HitFacts::read(&metadata.metadata)
                    .map_err(|reason| damaged(format!("the metadata `{METADATA}`: {reason}")))?;
                read.threshold = facts.threshold;
                read.is_softened = facts.is_softened;
                read.walls = facts.walls;
            }
            Record::Channel(channel) => {
                topics.insert(channel.id, channel.topic);
            }
            Record::Message { header, data } => {
                read.end = read.end.max(seconds(header.log_time));
                let topic = topics.get(&header.channel_id).map_or("", String::as_str);
                let wrong = |reason: String| damaged(format!("a message of `{topic}`: {reason}"));
                match topic {
                    "/hits" => {
                        let block = hits::Hits::decode(data.as_ref())
                            .map_err(|error| wrong(error.to_string()))?;
                        read.hits.extend(hits::hits(&block).map_err(wrong)?);
                    }
                    "/hits/classes" => {
                        let block = hits::HitClasses::decode(data.as_ref())
                            .map_err(|error| wrong(error.to_string()))?;
                        read.classes = hits::classes(&block).map_err(wrong)?;
                    }
                    "/ledger/mass" => {
                        // It begins with how many were inserted.
                        let inserted = series::first_value(&data)
                            .ok_or_else(|| wrong("it has no first value".into()))?;
                        read.pellets = read.pellets.max(inserted as u64);
                    }
                    _ => {}
                }
            }
            _ => {}
        }
    }
    read.is_cut_off = records.is_cut_off();
    provenance.finish(read.is_cut_off)?;
    match (has_hits, read.is_cut_off) {
        (true, _) => Ok(read),
        (false, false) => Err(ReadError::NoHits { path: path.into() }),
        // What tells of hits comes after what tells of the run.
        (false, true) => Err(ReadError::CutTooSoon { path: path.into() }),
    }
}
