//! Contacts of every frame, where they are recorded.

use super::hits::wall_names;
use super::{Column, Table, TableKind};
use crate::message::contacts::{ContactRecord, contacts};
use foxglove::messages::PointCloud;
use prost::Message;

/// Topic of contacts.
pub(crate) const CONTACTS: &str = "/contacts";
/// Name of the metadata that goes with contacts; it has the names of the walls.
pub(crate) const CONTACTS_METADATA: &str = "pelletflow.contacts";

/// A row for every contact in every frame.
#[derive(Default)]
pub(crate) struct Contacts {
    time: Vec<f64>,
    rows: Vec<ContactRecord>,
}

impl Contacts {
    /// Adds the contacts of a frame at a time [s], a message of [`CONTACTS`].
    pub(crate) fn take(&mut self, time: f64, data: &[u8]) -> Result<(), String> {
        let cloud = PointCloud::decode(data).map_err(|error| error.to_string())?;
        self.rows.extend(contacts(&cloud)?);
        self.time.resize(self.rows.len(), time);
        Ok(())
    }

    /// Rows so far [-].
    pub(crate) fn rows(&self) -> usize {
        self.rows.len()
    }

    /// The table; `walls` are the names of the walls. What is wrong with its rows.
    pub(crate) fn table(self, walls: &[String]) -> Result<Table, String> {
        let rows = &self.rows;
        let walls_by_row: Vec<i32> = rows.iter().map(|row| row.wall).collect();
        let is_pellet = walls_by_row.iter().map(|wall| *wall < 0).collect();
        let [pellets, partners] = [
            |row: &ContactRecord| row.pellet,
            |row: &ContactRecord| row.partner,
        ]
        .map(|number| rows.iter().map(number).collect::<Vec<u32>>());
        let column = |name: &str, value: fn(&ContactRecord) -> f32| {
            Column::new(name, rows.iter().map(value).collect::<Vec<f32>>())
        };
        Ok(Table {
            name: TableKind::Contacts.name().into(),
            columns: vec![
                Column::new("time_s", self.time),
                Column::new("pellet", pellets),
                Column::new("partner", partners).known_where(is_pellet),
                wall_names(&walls_by_row, walls)?,
                column("x_m", |row| row.place[0]),
                column("y_m", |row| row.place[1]),
                column("z_m", |row| row.place[2]),
                column("normal_force_n", |row| row.normal_force),
                column("force_x_n", |row| row.force[0]),
                column("force_y_n", |row| row.force[1]),
                column("force_z_n", |row| row.force[2]),
                column("overlap_m", |row| row.overlap),
            ],
        })
    }
}
