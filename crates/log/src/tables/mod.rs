//! A recording as tables: named columns of one type each, with units, for data frames and files of other programs.
//!
//! One pass reads all that is asked for.
//! Contacts are recorded only where that was asked for, because there may be more than twice as many as pellets in every
//! frame; what a contact did from touch to release is a row of the hits.

mod bodies;
mod contacts;
mod events;
mod hits;
mod series;
mod table;
mod unit;
mod walls;

pub(crate) use bodies::{Bodies, PELLETS};
pub(crate) use contacts::{CONTACTS, CONTACTS_METADATA, Contacts};
pub use hits::hits_table;
pub use table::{Column, Table, Values};
pub(crate) use unit::{unit_of, words_of};

use crate::error::ReadError;
use crate::hits::{HitFacts, METADATA, names_of_walls};
use crate::message::seconds;
use crate::provenance::{Provenance, RUN_METADATA};
use crate::records::Records;
use events::Events;
use hits::{Classes, Hits};
use mcap::records::{MessageHeader, Record};
use series::Series;
use std::collections::BTreeMap;
use std::path::{Component, Path};
use walls::Equipment;

/// Where walls move.
const TRANSFORMS: &str = "/tf";

/// Kinds of tables that a recording can be read as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TableKind {
    /// Every pellet in every frame.
    Bodies,
    /// Every contact in every frame, where that was asked for.
    Contacts,
    /// Hits kept in full.
    Hits,
    /// The last sketch of all hits, by partner and force.
    HitClasses,
    /// What each meter reads, a table for each.
    Meters,
    /// Pellets and mass inserted, inside, discharged and lost.
    MassLedger,
    /// Energies.
    EnergyLedger,
    /// What happened, in words.
    Events,
    /// Where each wall is, whenever that changes.
    Walls,
    /// Triangles of each wall, in its own frame.
    WallTriangles,
    /// Sharp edges of each wall, in its own frame.
    WallEdges,
}

impl TableKind {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Bodies,
        Self::Contacts,
        Self::Hits,
        Self::HitClasses,
        Self::Meters,
        Self::MassLedger,
        Self::EnergyLedger,
        Self::Events,
        Self::Walls,
        Self::WallTriangles,
        Self::WallEdges,
    ];

    /// Name of its table; those of meters are called `meters/NAME`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bodies => "bodies",
            Self::Contacts => "contacts",
            Self::Hits => "hits",
            Self::HitClasses => "hit_classes",
            Self::Meters => "meters",
            Self::MassLedger => "mass_ledger",
            Self::EnergyLedger => "energy_ledger",
            Self::Events => "events",
            Self::Walls => "walls",
            Self::WallTriangles => "wall_triangles",
            Self::WallEdges => "wall_edges",
        }
    }

    /// Whether it is one of those of the walls, which have their topics in common.
    fn is_of_equipment(self) -> bool {
        matches!(self, Self::Walls | Self::WallTriangles | Self::WallEdges)
    }
}

/// What a recording holds, as tables.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tables {
    /// Facts of the run: version, scene, seed and so on.
    pub facts: BTreeMap<String, String>,
    /// The tables asked for that the recording has, in the order of [`TableKind::ALL`]; meters by name.
    pub tables: Vec<Table>,
    /// Whether the file ends in the middle; the tables then hold what is before the cut.
    pub is_cut_off: bool,
}

impl Tables {
    /// The table of a name, if it was asked for and the recording has it.
    pub fn get(&self, name: &str) -> Option<&Table> {
        self.tables.iter().find(|table| table.name == name)
    }
}

/// Reads a recording as the tables asked for, in one pass; of a file that is cut off, what is before the cut.
///
/// Tables of hits are left out where the run did not follow them; a meter or ledger that was never written, too.
///
/// # Errors
/// The file cannot be read, is no recording or is damaged.
pub fn read_tables(path: impl AsRef<Path>, kinds: &[TableKind]) -> Result<Tables, ReadError> {
    let path = path.as_ref();
    let damaged = |reason: String| ReadError::Damaged {
        path: path.into(),
        reason,
    };
    let mut records = Records::open(path)?;
    let mut reader = Reader::new(kinds);
    let mut provenance = Provenance::new(path);
    while let Some(record) = records.next()? {
        provenance.take(&record)?;
        match record {
            Record::Schema { header, data } => {
                reader.schemas.insert(header.id, data.into_owned());
            }
            Record::Channel(channel) => reader
                .open(channel.id, channel.schema_id, &channel.topic)
                .map_err(|reason| damaged(format!("the channel `{}`: {reason}", channel.topic)))?,
            Record::Metadata(metadata) => reader
                .describe(&metadata.name, metadata.metadata)
                .map_err(|reason| damaged(format!("the metadata `{}`: {reason}", metadata.name)))?,
            Record::Message { header, data } => {
                reader.take(&header, &data).map_err(|(topic, reason)| {
                    damaged(format!("a message of `{topic}`: {reason}"))
                })?;
            }
            _ => {}
        }
    }
    provenance.finish(records.is_cut_off())?;
    reader.tables(records.is_cut_off()).map_err(damaged)
}

/// What becomes of the messages of one channel.
enum Sink {
    Bodies(Bodies),
    Contacts(Contacts),
    Hits(Box<Hits>),
    Classes(Classes),
    Series(Series),
    Events(Events),
    /// Walls that come and go.
    Equipment,
    /// Walls that move.
    Transforms,
}

struct Reader<'a> {
    kinds: &'a [TableKind],
    schemas: BTreeMap<u16, Vec<u8>>,
    /// The channels asked for, by number, with their topics.
    sinks: BTreeMap<u16, (String, Sink)>,
    equipment: Equipment,
    facts: BTreeMap<String, String>,
    /// Names of the walls that hits tell of, and contacts.
    walls: Vec<String>,
    walls_of_contacts: Vec<String>,
}

impl<'a> Reader<'a> {
    fn new(kinds: &'a [TableKind]) -> Self {
        Self {
            kinds,
            schemas: BTreeMap::new(),
            sinks: BTreeMap::new(),
            equipment: Equipment::default(),
            facts: BTreeMap::new(),
            walls: Vec::new(),
            walls_of_contacts: Vec::new(),
        }
    }

    /// Prepares for the messages of a channel; the index at the end of the file repeats every channel.
    fn open(&mut self, id: u16, schema: u16, topic: &str) -> Result<(), String> {
        let Some((kind, name)) = table_of(topic) else {
            return Ok(());
        };
        // Files are named after tables: a recording of others has no say in which folder they lie.
        let parts = Path::new(name).components();
        if kind == TableKind::Meters
            && !parts.eq([
                Component::Normal("meters".as_ref()),
                Component::Normal(name["meters/".len()..].as_ref()),
            ])
        {
            return Err("its name is none of a meter".into());
        }
        let is_asked = self.kinds.iter().any(|&asked| match kind {
            TableKind::Walls => asked.is_of_equipment(),
            _ => asked == kind,
        });
        if !is_asked || self.sinks.contains_key(&id) {
            return Ok(());
        }
        let sink = match kind {
            TableKind::Bodies => Sink::Bodies(Bodies::default()),
            TableKind::Contacts => Sink::Contacts(Contacts::default()),
            TableKind::Hits => Sink::Hits(Box::default()),
            TableKind::HitClasses => Sink::Classes(Classes::default()),
            TableKind::Events => Sink::Events(Events::default()),
            TableKind::Walls | TableKind::WallTriangles | TableKind::WallEdges => {
                if topic == TRANSFORMS {
                    Sink::Transforms
                } else {
                    Sink::Equipment
                }
            }
            TableKind::Meters | TableKind::MassLedger | TableKind::EnergyLedger => {
                let schema = self.schemas.get(&schema).ok_or("it has no schema")?;
                Sink::Series(Series::new(name, schema)?)
            }
        };
        self.sinks.insert(id, (topic.to_owned(), sink));
        Ok(())
    }

    fn describe(&mut self, name: &str, facts: BTreeMap<String, String>) -> Result<(), String> {
        if name == RUN_METADATA {
            self.facts = facts;
        } else if name == METADATA {
            self.walls = HitFacts::read(&facts)?.walls;
        } else if name == CONTACTS_METADATA {
            self.walls_of_contacts = names_of_walls(&facts)?;
        }
        Ok(())
    }

    /// Takes a message; the topic and what is wrong with it.
    fn take(&mut self, header: &MessageHeader, data: &[u8]) -> Result<(), (String, String)> {
        let Some((topic, sink)) = self.sinks.get_mut(&header.channel_id) else {
            return Ok(());
        };
        let time = seconds(header.log_time);
        match sink {
            Sink::Bodies(bodies) => bodies.take(time, data),
            Sink::Contacts(contacts) => contacts.take(time, data),
            Sink::Hits(hits) => hits.take(data),
            Sink::Classes(classes) => classes.take(data),
            Sink::Series(series) => series.take(time, data),
            Sink::Events(events) => events.take(time, data),
            Sink::Equipment => self.equipment.take_update(time, data),
            Sink::Transforms => self.equipment.take_transforms(time, data),
        }
        .map_err(|reason| (topic.clone(), reason))
    }

    fn tables(self, is_cut_off: bool) -> Result<Tables, String> {
        let mut tables = Vec::with_capacity(self.sinks.len());
        let equipment = self.equipment.tables(self.kinds).into_iter();
        tables.extend(equipment.map(|(kind, table)| (Some(kind), table)));
        for (topic, sink) in self.sinks.into_values() {
            let rank = table_of(&topic).map(|(kind, _)| kind);
            let table = match sink {
                Sink::Bodies(bodies) => bodies.table(),
                Sink::Contacts(contacts) => contacts.table(&self.walls_of_contacts)?,
                Sink::Hits(hits) => hits.table(&self.walls)?,
                Sink::Classes(classes) => classes.table(&self.walls)?,
                Sink::Series(series) => series.table(),
                Sink::Events(events) => events.table(),
                Sink::Equipment | Sink::Transforms => continue,
            };
            tables.push((rank, table));
        }
        tables.sort_by(|(one, first), (other, second)| {
            (one, &first.name).cmp(&(other, &second.name))
        });
        Ok(Tables {
            facts: self.facts,
            tables: tables.into_iter().map(|(_, table)| table).collect(),
            is_cut_off,
        })
    }
}

/// The kind of table that a topic becomes, of the equipment the first, and its name.
fn table_of(topic: &str) -> Option<(TableKind, &str)> {
    let kind = match topic {
        PELLETS => TableKind::Bodies,
        CONTACTS => TableKind::Contacts,
        "/hits" => TableKind::Hits,
        "/hits/classes" => TableKind::HitClasses,
        "/ledger/mass" => TableKind::MassLedger,
        "/ledger/energy" => TableKind::EnergyLedger,
        "/log" => TableKind::Events,
        "/equipment" | TRANSFORMS => TableKind::Walls,
        _ => {
            let name = topic.strip_prefix('/')?;
            let is_meter = name.starts_with("meters/");
            return is_meter.then_some((TableKind::Meters, name));
        }
    };
    Some((kind, kind.name()))
}
