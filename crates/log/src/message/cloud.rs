//! Points with named values, as viewers take them; each value has four bytes.

use super::{WORLD, in_place, timestamp};
use foxglove::messages::packed_element_field::NumericType;
use foxglove::messages::{PackedElementField, PointCloud};

const FIELD_BYTES: usize = 4;

/// A value that each point has, by its name.
pub(super) type Field = (&'static str, NumericType);

/// Binary digits of a number that nobody reads to the last one [-]: one part in eight thousand.
const VALUE_BITS: u32 = 13;
/// Share of a pellet's radius that places are told to [-], as a power of two.
const PLACE_BITS: i32 = 10;

/// Points at a time [s], whose values follow one another in `data` in the order of the fields.
pub(super) fn cloud(time: f64, fields: &[Field], data: Vec<u8>) -> PointCloud {
    PointCloud {
        timestamp: Some(timestamp(time)),
        frame_id: WORLD.into(),
        pose: Some(in_place()),
        point_stride: stride(fields) as u32,
        fields: fields
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

/// Bytes of a point [B].
pub(super) fn stride(fields: &[Field]) -> usize {
    FIELD_BYTES * fields.len()
}

/// The values of each point of a message, by fields; what is missing in it.
pub(super) fn points<const N: usize>(
    cloud: &PointCloud,
    fields: &[Field; N],
) -> Result<impl Iterator<Item = [[u8; FIELD_BYTES]; N]>, String> {
    let stride = cloud.point_stride as usize;
    if stride < FIELD_BYTES * N {
        return Err(format!(
            "its points have {stride} bytes each, too few for {N} fields of four"
        ));
    }
    let mut offsets = [0; N];
    for ((name, kind), offset) in fields.iter().zip(&mut offsets) {
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
    let points = cloud.data.chunks_exact(stride);
    Ok(
        points
            .map(move |point| offsets.map(|offset| [0, 1, 2, 3].map(|byte| point[offset + byte]))),
    )
}

/// A place [m] to less than a thousandth of the radius [m] of a pellet there.
///
/// Digits that nobody can see are zero: they are half of what a file would hold.
pub(super) fn place(coordinates: impl Into<[f64; 3]>, radius: f64) -> [f32; 3] {
    let step = (radius.log2().floor() - f64::from(PLACE_BITS)).exp2();
    let rounded = |coordinate: f64| ((coordinate / step).round() * step) as f32;
    coordinates.into().map(rounded)
}

/// A number in fewer binary digits, rounded.
pub(super) fn shortened(value: f64) -> f32 {
    let dropped = f32::MANTISSA_DIGITS - VALUE_BITS;
    let bits = (value as f32).to_bits().wrapping_add(1 << (dropped - 1));
    f32::from_bits(bits >> dropped << dropped)
}
