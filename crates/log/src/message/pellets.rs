//! `/pellets`: every pellet as a point with its radius, speed, force and number.

use super::cloud::{Field, cloud, place, points, shortened, stride};
use crate::frames::PelletRecord;
use crate::recording::DrawnPellet;
use foxglove::messages::PointCloud;
use foxglove::messages::packed_element_field::NumericType;

/// The values of a point, in order.
const FIELDS: [Field; 7] = [
    ("x", NumericType::Float32),
    ("y", NumericType::Float32),
    ("z", NumericType::Float32),
    ("radius", NumericType::Float32),
    ("speed", NumericType::Float32),
    ("force", NumericType::Float32),
    ("id", NumericType::Uint32),
];

/// All pellets at a time [s], in the order given.
pub(crate) fn message(time: f64, pellets: &[DrawnPellet]) -> PointCloud {
    let mut data = Vec::with_capacity(pellets.len() * stride(&FIELDS));
    for pellet in pellets {
        let [x, y, z] = place(pellet.position, pellet.radius);
        let [speed, force] = [pellet.speed, pellet.force].map(shortened);
        for value in [x, y, z, pellet.radius as f32, speed, force] {
            data.extend_from_slice(&value.to_le_bytes());
        }
        data.extend_from_slice(&pellet.id.to_le_bytes());
    }
    cloud(time, &FIELDS, data)
}

/// The pellets of a message; what is missing in it.
pub(crate) fn pellets(cloud: &PointCloud) -> Result<Vec<PelletRecord>, String> {
    let pellets = points(cloud, &FIELDS)?.map(|[x, y, z, radius, speed, force, id]| {
        let [x, y, z, radius, speed, force] =
            [x, y, z, radius, speed, force].map(f32::from_le_bytes);
        PelletRecord {
            position: [x, y, z],
            radius,
            speed,
            force,
            id: u32::from_le_bytes(id),
        }
    });
    Ok(pellets.collect())
}
