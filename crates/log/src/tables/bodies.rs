//! Pellets of every frame.

use super::{Column, Table, TableKind};
use crate::message::pellets;
use foxglove::messages::PointCloud;
use prost::Message;

/// Topic of pellets.
pub(crate) const PELLETS: &str = "/pellets";

/// A row for every pellet in every frame.
#[derive(Default)]
pub(crate) struct Bodies {
    time: Vec<f64>,
    id: Vec<u32>,
    position: [Vec<f32>; 3],
    radius: Vec<f32>,
    speed: Vec<f32>,
    force: Vec<f32>,
}

impl Bodies {
    /// Adds the pellets of a frame at a time [s], a message of [`PELLETS`].
    pub(crate) fn take(&mut self, time: f64, data: &[u8]) -> Result<(), String> {
        let cloud = PointCloud::decode(data).map_err(|error| error.to_string())?;
        for pellet in pellets::pellets(&cloud)? {
            self.time.push(time);
            self.id.push(pellet.id);
            for (column, coordinate) in self.position.iter_mut().zip(pellet.position) {
                column.push(coordinate);
            }
            self.radius.push(pellet.radius);
            self.speed.push(pellet.speed);
            self.force.push(pellet.force);
        }
        Ok(())
    }

    /// Rows so far [-].
    pub(crate) fn rows(&self) -> usize {
        self.time.len()
    }

    pub(crate) fn table(self) -> Table {
        let [x, y, z] = self.position;
        Table {
            name: TableKind::Bodies.name().into(),
            columns: vec![
                Column::new("time_s", self.time),
                Column::new("id", self.id),
                Column::new("x_m", x),
                Column::new("y_m", y),
                Column::new("z_m", z),
                Column::new("radius_m", self.radius),
                Column::new("speed_m_per_s", self.speed),
                Column::new("force_n", self.force),
            ],
        }
    }
}
