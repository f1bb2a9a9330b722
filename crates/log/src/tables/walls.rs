//! The equipment: where each wall is over time, and of what triangles and edges it is drawn.

use super::{Column, Table, TableKind, Values};
use crate::walls::{WallPlace, WallSurface, Walls};
use foxglove::messages::{FrameTransforms, SceneUpdate};
use prost::Message;

/// The walls, and a row for every moment at which one of them came, went or was put elsewhere.
#[derive(Default)]
pub(super) struct Equipment {
    walls: Walls,
    time: Vec<f64>,
    wall: Vec<u32>,
    place: Vec<WallPlace>,
    /// The last row of each wall.
    last: Vec<Option<usize>>,
}

impl Equipment {
    /// Takes a message of `/equipment`.
    pub(super) fn take_update(&mut self, time: f64, data: &[u8]) -> Result<(), String> {
        let update = SceneUpdate::decode(data).map_err(|error| error.to_string())?;
        let told = self.walls.take_update(update);
        self.note(time, &told);
        Ok(())
    }

    /// Takes a message of `/tf`.
    pub(super) fn take_transforms(&mut self, time: f64, data: &[u8]) -> Result<(), String> {
        let transforms = FrameTransforms::decode(data).map_err(|error| error.to_string())?;
        let told = self.walls.take_transforms(transforms);
        self.note(time, &told);
        Ok(())
    }

    /// Notes what has changed of some walls at a time [s]; of several changes at one time the last.
    fn note(&mut self, time: f64, told: &[usize]) {
        self.last.resize(self.walls.surfaces().len(), None);
        for &wall in told {
            let place = self.walls.place(wall);
            let before = self.last[wall].map_or(WallPlace::UNKNOWN, |row| self.place[row]);
            if place == before || !(place.is_present || before.is_present) {
                continue;
            }
            if let Some(row) = self.last[wall].filter(|&row| self.time[row] >= time) {
                self.place[row] = place;
            } else {
                self.last[wall] = Some(self.time.len());
                self.time.push(time);
                self.wall.push(wall as u32);
                self.place.push(place);
            }
        }
    }

    /// The tables of the kinds asked for.
    pub(super) fn tables(self, kinds: &[TableKind]) -> Vec<(TableKind, Table)> {
        let surfaces = self.walls.surfaces();
        let triangles = |surface: &WallSurface| {
            let corners = surface.triangles.iter();
            corners
                .map(|&index| surface.corners[index as usize])
                .collect()
        };
        let table = |kind: TableKind| match kind {
            TableKind::Walls => Some(self.places()),
            TableKind::WallTriangles => Some(pieces::<3>(kind, surfaces, triangles)),
            TableKind::WallEdges => {
                Some(pieces::<2>(kind, surfaces, |surface| surface.edges.clone()))
            }
            _ => None,
        };
        let asked = kinds.iter();
        asked
            .filter_map(|&kind| Some((kind, table(kind)?)))
            .collect()
    }

    fn places(&self) -> Table {
        let surfaces = self.walls.surfaces();
        let material = Values::Label {
            labels: surfaces
                .iter()
                .map(|surface| surface.material.clone())
                .collect(),
            indices: self.wall.clone(),
        };
        let is_active = self.wall.iter();
        let is_active: Vec<bool> = is_active
            .map(|&wall| surfaces[wall as usize].is_active)
            .collect();
        let is_present: Vec<bool> = self.place.iter().map(|place| place.is_present).collect();
        let mut columns = vec![
            Column::new("time_s", self.time.clone()),
            Column::new("wall", names(surfaces, self.wall.clone())),
            Column::new("material", material),
            Column::new("is_active", is_active),
            Column::new("is_present", is_present),
        ];
        let pose = ["x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"];
        columns.extend(pose.into_iter().enumerate().map(|(index, name)| {
            let values: Vec<f32> = self.place.iter().map(|place| place.pose[index]).collect();
            Column::new(name, values)
        }));
        Table {
            name: TableKind::Walls.name().into(),
            columns,
        }
    }
}

/// A row for each piece of `N` corners, a triangle or an edge, in the frame of its wall.
fn pieces<const N: usize>(
    kind: TableKind,
    surfaces: &[WallSurface],
    corners_of: impl Fn(&WallSurface) -> Vec<[f32; 3]>,
) -> Table {
    let mut walls = Vec::new();
    let mut coordinates = vec![Vec::new(); 3 * N];
    for (wall, surface) in surfaces.iter().enumerate() {
        for piece in corners_of(surface).as_chunks::<N>().0 {
            walls.push(wall as u32);
            for (values, value) in coordinates.iter_mut().zip(piece.iter().flatten()) {
                values.push(*value);
            }
        }
    }
    let mut columns = vec![Column::new("wall", names(surfaces, walls))];
    columns.extend(coordinates.into_iter().enumerate().map(|(index, values)| {
        let axis = ["x", "y", "z"][index % 3];
        Column::new(format!("{axis}{}_m", index / 3 + 1), values)
    }));
    Table {
        name: kind.name().into(),
        columns,
    }
}

fn names(surfaces: &[WallSurface], indices: Vec<u32>) -> Values {
    Values::Label {
        labels: surfaces
            .iter()
            .map(|surface| surface.name.clone())
            .collect(),
        indices,
    }
}
