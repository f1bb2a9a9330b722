//! `/pellets`: every pellet as a point with its radius, speed, force and number.

use super::{WORLD, in_place, timestamp};
use crate::frames::PelletRecord;
use crate::recording::DrawnPellet;
use foxglove::messages::packed_element_field::NumericType;
use foxglove::messages::{PackedElementField, PointCloud};

/// The fields of a point, in order; each has four bytes.
const FIELDS: [(&str, NumericType); 7] = [
    ("x", NumericType::Float32),
    ("y", NumericType::Float32),
    ("z", NumericType::Float32),
    ("radius", NumericType::Float32),
    ("speed", NumericType::Float32),
    ("force", NumericType::Float32),
    ("id", NumericType::Uint32),
];
const FIELD_BYTES: usize = 4;
const POINT_BYTES: usize = FIELD_BYTES * FIELDS.len();

/// Share of a pellet's radius that its place is told to [-], as a power of two.
const PLACE_BITS: i32 = 10;
/// Binary digits of a speed and a force [-]: one part in eight thousand.
const VALUE_BITS: u32 = 13;

/// All pellets at a time [s], in the order given.
///
/// Digits that nobody can see are zero: they are half of what a file would hold.
pub(crate) fn message(time: f64, pellets: &[DrawnPellet]) -> PointCloud {
    let mut data = Vec::with_capacity(pellets.len() * POINT_BYTES);
    for pellet in pellets {
        let step = place_step(pellet.radius);
        let [x, y, z] = [0, 1, 2].map(|axis| rounded(pellet.position[axis], step));
        let [speed, force] = [pellet.speed, pellet.force].map(|value| shortened(value as f32));
        for value in [x, y, z, pellet.radius as f32, speed, force] {
            data.extend_from_slice(&value.to_le_bytes());
        }
        data.extend_from_slice(&pellet.id.to_le_bytes());
    }
    PointCloud {
        timestamp: Some(timestamp(time)),
        frame_id: WORLD.into(),
        pose: Some(in_place()),
        point_stride: POINT_BYTES as u32,
        fields: FIELDS
            .iter()
            .enumerate()
            .map(|(index, (name, kind))| PackedElementField {
                name: (*name).into(),
                offset: (index * FIELD_BYTES) as u32,
                r#type: *kind as i32,
            })
            .collect(),
        data: data.into(),
    }
}

/// What the place of a pellet of a radius [m] is told in multiples of [m]: less than a thousandth of the radius.
fn place_step(radius: f64) -> f64 {
    (radius.log2().floor() - f64::from(PLACE_BITS)).exp2()
}

/// A coordinate [m] as the nearest multiple of a step [m].
fn rounded(coordinate: f64, step: f64) -> f32 {
    ((coordinate / step).round() * step) as f32
}

/// A number in fewer binary digits, rounded.
fn shortened(value: f32) -> f32 {
    let dropped = f32::MANTISSA_DIGITS - VALUE_BITS;
    let bits = value.to_bits().wrapping_add(1 << (dropped - 1));
    f32::from_bits(bits >> dropped << dropped)
}

/// The pellets of a message; what is missing in it.
pub(crate) fn pellets(cloud: &PointCloud) -> Result<Vec<PelletRecord>, String> {
    let stride = cloud.point_stride as usize;
    let mut offsets = [0; FIELDS.len()];
    for ((name, kind), offset) in FIELDS.iter().zip(&mut offsets) {
        let field = cloud
            .fields
            .iter()
            .find(|field| field.name == *name && field.r#type == *kind as i32)
            .ok_or_else(|| format!("its points have no field `{name}` of four bytes"))?;
        *offset = field.offset as usize;
        if *offset + FIELD_BYTES > stride {
            return Err(format!("field `{name}` lies outside its points"));
        }
    }
    let word = |point: &[u8], field: usize| {
        let offset = offsets[field];
        [0, 1, 2, 3].map(|byte| point[offset + byte])
    };
    Ok(cloud
        .data
        .chunks_exact(stride)
        .map(|point| {
            let value = |field| f32::from_le_bytes(word(point, field));
            PelletRecord {
                position: [value(0), value(1), value(2)],
                radius: value(3),
                speed: value(4),
                force: value(5),
                id: u32::from_le_bytes(word(point, 6)),
            }
        })
        .collect())
}
