//! A recording as files of VTK: pellets, contacts and walls of each frame, and the hits.

use super::vtk::{Array, Collection, PolyData};
use super::{ExportError, Exported, Output};
use crate::error::ReadError;
use crate::frames::PelletRecord;
use crate::hits::names_of_walls;
use crate::message::{pellets, seconds};
use crate::records::Records;
use crate::tables::{CONTACTS, CONTACTS_METADATA, Contacts, Table, TableKind, Values, read_tables};
use crate::walls::{WallPlace, WallSurface, Walls};
use foxglove::messages::{FrameTransforms, PointCloud, SceneUpdate};
use mcap::records::Record;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use prost::Message;
use std::collections::BTreeMap;
use std::path::Path;

/// Writes `pellets.pvd`, `walls.pvd` and `hits.vtp`, where contacts were recorded `contacts.pvd`, and the files that they
/// name.
pub(super) fn write(recording: &Path, output: &mut Output) -> Result<Exported, ExportError> {
    let mut exporter = Exporter::default();
    let mut records = Records::open(recording)?;
    let mut topics = BTreeMap::new();
    while let Some(record) = records.next()? {
        match record {
            Record::Metadata(metadata) if metadata.name == CONTACTS_METADATA => {
                exporter.walls_of_contacts =
                    names_of_walls(&metadata.metadata).map_err(|reason| ReadError::Damaged {
                        path: recording.into(),
                        reason: format!("the contacts: {reason}"),
                    })?;
            }
            Record::Channel(channel) => {
                topics.insert(channel.id, channel.topic);
            }
            Record::Message { header, data } => {
                let topic = topics.get(&header.channel_id).map_or("", String::as_str);
                let damaged = |reason: String| ReadError::Damaged {
                    path: recording.into(),
                    reason: format!("a message of `{topic}`: {reason}"),
                };
                let time = seconds(header.log_time);
                exporter.take(topic, time, &data, output, damaged)?;
            }
            _ => {}
        }
    }
    output.write("pellets.pvd", |file| exporter.pellets.write(file))?;
    output.write("walls.pvd", |file| exporter.walls_over_time.write(file))?;
    if !exporter.contacts.is_empty() {
        output.write("contacts.pvd", |file| exporter.contacts.write(file))?;
    }
    let hits = read_tables(recording, &[TableKind::Hits])?;
    if let Some(table) = hits.get(TableKind::Hits.name()) {
        output.write("hits.vtp", |file| points_of(table).write(file))?;
    }
    Ok(Exported {
        files: std::mem::take(&mut output.files),
        frames: exporter.frames,
        is_cut_off: records.is_cut_off(),
    })
}

/// What has been written so far.
#[derive(Default)]
struct Exporter {
    walls: Walls,
    /// The last file of each wall, and where the wall was in it.
    drawn: BTreeMap<usize, (String, [f32; 7])>,
    frames: usize,
    pellets: Collection,
    walls_over_time: Collection,
    walls_of_contacts: Vec<String>,
    contacts: Collection,
}

impl Exporter {
    fn take(
        &mut self,
        topic: &str,
        time: f64,
        data: &[u8],
        output: &mut Output,
        damaged: impl Fn(String) -> ReadError,
    ) -> Result<(), ExportError> {
        let undecoded = |error: prost::DecodeError| damaged(error.to_string());
        match topic {
            "/equipment" => {
                let update = SceneUpdate::decode(data).map_err(undecoded)?;
                self.walls.take_update(update);
            }
            "/tf" => {
                let transforms = FrameTransforms::decode(data).map_err(undecoded)?;
                self.walls.take_transforms(transforms);
            }
            CONTACTS => {
                let mut contacts = Contacts::default();
                contacts.take(time, data).map_err(&damaged)?;
                let table = contacts.table(&self.walls_of_contacts).map_err(damaged)?;
                let name = format!("contacts/contacts_{:06}.vtp", self.contacts.len());
                output.write_part(&name, |file| points_of(&table).write(file))?;
                self.contacts.push(time, 0, &name);
            }
            "/pellets" => {
                let cloud = PointCloud::decode(data).map_err(undecoded)?;
                let pellets = pellets::pellets(&cloud).map_err(damaged)?;
                self.frame(time, &pellets, output)?;
            }
            _ => {}
        }
        Ok(())
    }

    fn frame(
        &mut self,
        time: f64,
        pellets: &[PelletRecord],
        output: &mut Output,
    ) -> Result<(), ExportError> {
        let name = format!("pellets/pellets_{:06}.vtp", self.frames);
        output.write_part(&name, |file| cloud(pellets).write(file))?;
        self.pellets.push(time, 0, &name);
        let walls = self.walls.surfaces().iter().zip(self.walls.places());
        for (part, (surface, place)) in walls.enumerate() {
            if !place.is_present || surface.triangles.is_empty() {
                continue;
            }
            let drawn = self
                .drawn
                .get(&part)
                .filter(|(_, pose)| *pose == place.pose);
            let name = if let Some((name, _)) = drawn {
                name.clone()
            } else {
                let name = format!("walls/{part}_{:06}.vtp", self.frames);
                output.write_part(&name, |file| placed(surface, &place).write(file))?;
                self.drawn.insert(part, (name.clone(), place.pose));
                name
            };
            self.walls_over_time.push(time, part, &name);
        }
        self.frames += 1;
        Ok(())
    }
}

/// Pellets as points.
fn cloud(pellets: &[PelletRecord]) -> PolyData {
    let values =
        |value: fn(&PelletRecord) -> f32| Array::Float32(pellets.iter().map(value).collect());
    PolyData {
        points: pellets.iter().map(|pellet| pellet.position).collect(),
        triangles: Vec::new(),
        values: vec![
            (
                "id".into(),
                Array::UInt32(pellets.iter().map(|pellet| pellet.id).collect()),
            ),
            ("radius_m".into(), values(|pellet| pellet.radius)),
            ("speed_m_per_s".into(), values(|pellet| pellet.speed)),
            ("force_n".into(), values(|pellet| pellet.force)),
        ],
    }
}

/// A wall where it is.
fn placed(surface: &WallSurface, place: &WallPlace) -> PolyData {
    let [px, py, pz, x, y, z, w] = place.pose;
    let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    let shift = Vector3::new(px, py, pz);
    let corners = surface.corners.iter();
    PolyData {
        points: corners
            .map(|&corner| (turn * Vector3::from(corner) + shift).into())
            .collect(),
        triangles: surface.triangles.clone(),
        values: Vec::new(),
    }
}

/// Hits or contacts as points, with every number that is known of all of them, and with walls by index: -1 where the
/// partner is a pellet.
fn points_of(table: &Table) -> PolyData {
    let axes =
        ["x_m", "y_m", "z_m"].map(
            |axis| match table.column(axis).map(|column| &column.values) {
                Some(Values::Float32(values)) => values.as_slice(),
                _ => &[],
            },
        );
    let [x, y, z] = axes;
    let points = x.iter().zip(y).zip(z).map(|((&x, &y), &z)| [x, y, z]);
    let mut values = Vec::new();
    for column in &table.columns {
        let array = match &column.values {
            Values::Label { indices, .. } if column.name == "wall" => {
                let wall = |(row, &index): (usize, &u32)| {
                    if column.is_known(row) {
                        index.cast_signed()
                    } else {
                        -1
                    }
                };
                Array::Int32(indices.iter().enumerate().map(wall).collect())
            }
            _ if column.is_known.is_some() || ["x_m", "y_m", "z_m"].contains(&&*column.name) => {
                continue;
            }
            Values::Float32(values) => Array::Float32(values.clone()),
            Values::Float64(values) => Array::Float64(values.clone()),
            Values::UInt32(values) => Array::UInt32(values.clone()),
            _ => continue,
        };
        values.push((column.name.clone(), array));
    }
    PolyData {
        points: points.collect(),
        triangles: Vec::new(),
        values,
    }
}
