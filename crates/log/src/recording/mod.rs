//! The recording: one MCAP file, its channels, when they are written, and the thread that does.

mod carry;
mod channel;
mod due;
mod frame;
mod recorder;
mod writer;

pub(crate) use carry::{CarryError, Mark};
pub(crate) use due::Due;
pub(crate) use frame::{DrawnPellet, Frame};
pub(crate) use recorder::{Entry, Recorder, RecordingTimes, Stopped};

use crate::hits::{IS_SOFTENED, METADATA, THRESHOLD, WALLS};
use crate::live::Program;
use crate::message::equipment::Equipment;
use crate::message::event::{self, Gravity};
use crate::message::{contacts, hits, nanoseconds, pellets, series, spheres, transforms, worst};
use crate::provenance::RUN_METADATA;
use crate::tables::{CONTACTS, CONTACTS_METADATA};
use crate::worst_hits::in_words;
use channel::{Channel, Foxglove, channel_for};
use mcap::records::Metadata;
use mcap::{Attachment, Compression, McapResult, WriteOptions};
use pelletflow_sim::{Hit, HitClass, HitClassKey, MeterReading, Setup};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{Seek, Write};
use writer::MessageWriter;

/// Bytes of messages before they are compressed and written [B].
const CHUNK_BYTES: u64 = 4 * 1024 * 1024;
/// Level of zstd [-]; higher ones cost more time than they save bytes.
const COMPRESSION_LEVEL: u32 = 1;

/// Hits in one message at most [-].
const HITS_PER_MESSAGE: usize = 4096;

/// What a recording says of itself, in its first bytes.
pub(crate) struct Title<'a> {
    /// Name and text of the scene, attached.
    pub(crate) scene_text: &'a str,
    /// Layout of a viewer, attached.
    pub(crate) layout: &'a str,
    /// Facts of the run.
    pub(crate) facts: BTreeMap<String, String>,
}

/// What is drawn in a frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drawn {
    /// Spheres are drawn of at most so many pellets [-].
    pub(crate) spheres_up_to: usize,
    /// Speed that has the last color [m/s].
    pub(crate) full_speed: f64,
    /// Whether contacts are drawn.
    pub(crate) contacts: bool,
}

/// A recording being written.
pub(crate) struct Recording<W: Write + Seek> {
    writer: MessageWriter<W>,
    equipment: Equipment,
    wall_names: Vec<String>,
    has_moving_walls: bool,
    spheres_up_to: usize,
    full_speed: f64,
    has_spheres: bool,
    pellets_channel: Channel,
    spheres_channel: Channel,
    equipment_channel: Channel,
    transforms_channel: Channel,
    log_channel: Channel,
    mass_channel: Option<Channel>,
    energy_channel: Option<Channel>,
    meter_channels: BTreeMap<String, Channel>,
    hit_channels: Option<HitChannels>,
    contacts_channel: Option<Channel>,
}

/// Topics of hits, where they are followed.
struct HitChannels {
    hits: Channel,
    classes: Channel,
    worst: Channel,
    worst_in_words: Channel,
}

impl<W: Write + Seek> Recording<W> {
    /// Starts the file with its metadata and attachments, so that even a killed run has them.
    ///
    /// What is written is also shown, where there is someone to watch.
    pub(crate) fn start(
        writer: W,
        setup: &Setup,
        title: &Title,
        drawn: Drawn,
        live: Option<Program>,
    ) -> McapResult<Self> {
        let mut writer = WriteOptions::new()
            .compression(Some(Compression::Zstd))
            .compression_level(COMPRESSION_LEVEL)
            // Threads did not help, and they are the simulation's but for the one that writes.
            .compression_threads(0)
            .chunk_size(Some(CHUNK_BYTES))
            .library(format!("pelletflow {}", env!("CARGO_PKG_VERSION")))
            .create(writer)
            .map(|writer| MessageWriter::new(writer, live))?;
        writer.write_metadata(&Metadata {
            name: RUN_METADATA.into(),
            metadata: title.facts.clone(),
        })?;
        for (name, media_type, text) in [
            ("scene.toml", "application/toml", title.scene_text),
            ("layout.json", "application/json", title.layout),
        ] {
            writer.attach(&Attachment {
                log_time: 0,
                create_time: 0,
                name: name.into(),
                media_type: media_type.into(),
                data: Cow::Borrowed(text.as_bytes()),
            })?;
        }
        Ok(Self {
            pellets_channel: channel_for(&mut writer, "/pellets", Foxglove::PointCloud)?,
            spheres_channel: channel_for(&mut writer, "/pellets/spheres", Foxglove::SceneUpdate)?,
            equipment_channel: channel_for(&mut writer, "/equipment", Foxglove::SceneUpdate)?,
            transforms_channel: channel_for(&mut writer, "/tf", Foxglove::FrameTransforms)?,
            log_channel: channel_for(&mut writer, "/log", Foxglove::Log)?,
            mass_channel: None,
            energy_channel: None,
            meter_channels: BTreeMap::new(),
            hit_channels: hit_channels(&mut writer, setup)?,
            contacts_channel: contacts_channel(&mut writer, setup, drawn)?,
            equipment: Equipment::of(setup),
            wall_names: setup.walls.iter().map(|wall| wall.name.clone()).collect(),
            has_moving_walls: setup.walls.iter().any(|wall| wall.motion.is_moving()),
            spheres_up_to: drawn.spheres_up_to,
            full_speed: if drawn.full_speed > 0.0 {
                drawn.full_speed
            } else {
                1.0
            },
            has_spheres: false,
            writer,
        })
    }

    /// Writes where everything is; pellets in the order given.
    pub(crate) fn frame(&mut self, frame: &Frame) -> McapResult<()> {
        let time = nanoseconds(frame.time);
        self.writer.show_time(time);
        // Every viewer waits for the frames before it draws what is in them.
        if self.has_moving_walls || self.transforms_channel.is_empty() {
            let walls = self.wall_names.iter().map(String::as_str);
            let poses = frame.poses.iter().copied();
            let message = transforms::message(frame.time, walls.zip(poses));
            self.transforms_channel
                .write(&mut self.writer, time, &message)?;
        }
        let message = pellets::message(frame.time, &frame.pellets);
        self.pellets_channel
            .write(&mut self.writer, time, &message)?;
        if let Some(channel) = &mut self.contacts_channel
            && frame.has_contacts
        {
            let message = contacts::message(frame.time, &frame.contacts);
            channel.write(&mut self.writer, time, &message)?;
        }
        let may_have_spheres = frame.pellets.len() <= self.spheres_up_to;
        if may_have_spheres {
            let message = spheres::message(frame.time, &frame.pellets, self.full_speed);
            self.spheres_channel
                .write(&mut self.writer, time, &message)?;
        } else if self.has_spheres {
            let message = spheres::removal(frame.time);
            self.spheres_channel
                .write(&mut self.writer, time, &message)?;
        }
        self.has_spheres = may_have_spheres;
        write_row(
            &mut self.writer,
            &mut self.mass_channel,
            ("/ledger/mass", "mass-ledger"),
            time,
            &series::mass(&frame.mass),
        )?;
        write_row(
            &mut self.writer,
            &mut self.energy_channel,
            ("/ledger/energy", "energy-ledger"),
            time,
            &series::energy(&frame.energy),
        )
    }

    /// Writes which walls are there from a time on [s].
    pub(crate) fn walls(&mut self, time: f64, is_present: &[bool]) -> McapResult<()> {
        let message = self.equipment.message(time, is_present);
        self.equipment_channel
            .write(&mut self.writer, nanoseconds(time), &message)
    }

    /// Writes what the meters read at a time [s].
    pub(crate) fn meters(&mut self, time: f64, readings: &[MeterReading]) -> McapResult<()> {
        self.writer.show_time(nanoseconds(time));
        for reading in readings {
            let mut channel = self.meter_channels.get(&reading.name).copied();
            let topic = format!("/meters/{}", reading.name);
            write_row(
                &mut self.writer,
                &mut channel,
                (&topic, reading.kind),
                nanoseconds(time),
                series::meter(reading),
            )?;
            if let Some(channel) = channel {
                self.meter_channels.insert(reading.name.clone(), channel);
            }
        }
        Ok(())
    }

    /// Writes hits that have ended, at a time [s].
    pub(crate) fn hits(&mut self, time: f64, hits: &[Hit]) -> McapResult<()> {
        let Some(channels) = &mut self.hit_channels else {
            return Ok(());
        };
        for block in hits.chunks(HITS_PER_MESSAGE) {
            let message = hits::message(block);
            channels
                .hits
                .write(&mut self.writer, nanoseconds(time), &message)?;
        }
        Ok(())
    }

    /// Writes the sketch of all hits up to a time [s].
    pub(crate) fn hit_classes(
        &mut self,
        time: f64,
        classes: &BTreeMap<HitClassKey, HitClass>,
    ) -> McapResult<()> {
        let Some(channels) = &mut self.hit_channels else {
            return Ok(());
        };
        let message = hits::classes_message(classes);
        channels
            .classes
            .write(&mut self.writer, nanoseconds(time), &message)
    }

    /// Marks the hardest hits up to a time [s], the hardest first, and tells those of them in words that are new.
    pub(crate) fn worst_hits(
        &mut self,
        time: f64,
        entered: &[Hit],
        worst: &[Hit],
    ) -> McapResult<()> {
        let Some(channels) = &mut self.hit_channels else {
            return Ok(());
        };
        let log_time = nanoseconds(time);
        let marks = worst::message(time, worst);
        channels.worst.write(&mut self.writer, log_time, &marks)?;
        for (hit, rank) in worst.iter().zip(1..) {
            if entered.contains(hit) {
                let text = format!(
                    "hit {rank} of the hardest so far, at {:.4} s: {}",
                    hit.peak_time,
                    in_words(hit, &self.wall_names)
                );
                let words = event::message(hit.peak_time, Gravity::Warning, &text);
                channels
                    .worst_in_words
                    .write(&mut self.writer, log_time, &words)?;
            }
        }
        Ok(())
    }

    /// Writes what happened at a time [s].
    pub(crate) fn event(&mut self, time: f64, gravity: Gravity, text: &str) -> McapResult<()> {
        let message = event::message(time, gravity, text);
        self.log_channel
            .write(&mut self.writer, nanoseconds(time), &message)
    }

    /// Ends the chunk, so that a file cut off from now on is whole up to here.
    pub(crate) fn flush(&mut self) -> McapResult<()> {
        self.writer.flush()
    }

    /// Writes the index and the end mark.
    pub(crate) fn finish(mut self) -> McapResult<W> {
        self.writer.finish()?;
        Ok(self.writer.into_inner())
    }
}

/// Opens the topic of contacts and says what goes with them, if they are drawn.
fn contacts_channel<W: Write + Seek>(
    writer: &mut MessageWriter<W>,
    setup: &Setup,
    drawn: Drawn,
) -> McapResult<Option<Channel>> {
    if !drawn.contacts {
        return Ok(None);
    }
    writer.write_metadata(&Metadata {
        name: CONTACTS_METADATA.into(),
        metadata: BTreeMap::from([(WALLS.into(), names_of_walls(setup))]),
    })?;
    channel_for(writer, CONTACTS, Foxglove::PointCloud).map(Some)
}

/// Names of the walls by index, as a JSON list.
fn names_of_walls(setup: &Setup) -> String {
    let names: Vec<&str> = setup.walls.iter().map(|wall| wall.name.as_str()).collect();
    serde_json::json!(names).to_string()
}

/// Opens the topics of hits and says what goes with them, if the run follows them.
fn hit_channels<W: Write + Seek>(
    writer: &mut MessageWriter<W>,
    setup: &Setup,
) -> McapResult<Option<HitChannels>> {
    let Some(request) = &setup.hits else {
        return Ok(None);
    };
    writer.write_metadata(&Metadata {
        name: METADATA.into(),
        metadata: BTreeMap::from([
            (THRESHOLD.into(), request.threshold.to_string()),
            (IS_SOFTENED.into(), setup.is_softened().to_string()),
            (WALLS.into(), names_of_walls(setup)),
        ]),
    })?;
    Ok(Some(HitChannels {
        hits: Channel::open(writer, "/hits", &hits::Hits::schema())?,
        classes: Channel::open(writer, "/hits/classes", &hits::HitClasses::schema())?,
        worst: channel_for(writer, "/hits/worst", Foxglove::SceneUpdate)?,
        worst_in_words: channel_for(writer, "/hits/worst/log", Foxglove::Log)?,
    }))
}

/// Writes a message of our own, whose channel is made when the first one shows its fields.
fn write_row<W: Write + Seek>(
    writer: &mut MessageWriter<W>,
    channel: &mut Option<Channel>,
    (topic, kind): (&str, &str),
    time: u64,
    row: &series::Row,
) -> McapResult<()> {
    let channel = match channel {
        Some(channel) => channel,
        None => channel.insert(Channel::open(writer, topic, &series::schema(kind, row))?),
    };
    channel.write_bytes(writer, time, &series::encode(row))
}
