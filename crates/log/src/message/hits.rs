//! `/hits` and `/hits/classes`: hits in full, many to a message, and the sketch of all of them.
//!
//! One column for each quantity: a row of every column is one hit, or one class.

use super::own;
use crate::tables::Column;
use foxglove::Schema;
use foxglove::prost_types::field_descriptor_proto::{Label, Type};
use pelletflow_core::Vec3;
use pelletflow_sim::{Cause, Hit, HitClass, HitClassKey, HitPartner, MOST_COUNTED};
use prost::Message;
use std::collections::BTreeMap;

/// What stands for a pellet where a wall is named.
const NO_WALL: i32 = -1;
/// What is wrong with a message whose columns are not of one length.
pub(crate) const UNEQUAL_COLUMNS: &str = "its columns differ in length";

/// A message of columns, and its schema, from one list of their names, types and numbers.
macro_rules! columns {
    ($(#[$doc:meta])* $message:ident { $($column:ident: $kind:ident $type:ty = $number:literal,)* }) => {
        $(#[$doc])*
        #[derive(Clone, PartialEq, Message)]
        pub(crate) struct $message {
            $(#[prost($kind, repeated, tag = $number)] pub(crate) $column: Vec<$type>,)*
        }

        impl $message {
            pub(crate) fn schema() -> Schema {
                own::schema(
                    stringify!($message),
                    Label::Repeated,
                    [$((stringify!($column), type_of!($kind))),*],
                )
            }

            /// Number of rows, if all columns have as many.
            pub(crate) fn rows(&self) -> Option<usize> {
                let lengths = [$(self.$column.len()),*];
                lengths.iter().all(|length| *length == lengths[0]).then_some(lengths[0])
            }

            /// The columns by name, as they are in the message.
            pub(crate) fn into_columns(self) -> Vec<Column> {
                vec![$(Column::new(stringify!($column), self.$column)),*]
            }
        }
    };
}

macro_rules! type_of {
    (double) => {
        Type::Double
    };
    (float) => {
        Type::Float
    };
    (uint32) => {
        Type::Uint32
    };
    (uint64) => {
        Type::Uint64
    };
    (sint32) => {
        Type::Sint32
    };
    (bool) => {
        Type::Bool
    };
}

columns! {
    /// Hits in full.
    Hits {
        peak_time_s: double f64 = "1",
        begin_s: double f64 = "2",
        duration_s: double f64 = "3",
        steps: uint64 u64 = "4",
        is_open: bool bool = "5",
        cause: uint32 u32 = "6",
        pellet: uint32 u32 = "7",
        diameter_m: double f64 = "8",
        mass_kg: double f64 = "9",
        wall: sint32 i32 = "10",
        partner: uint32 u32 = "11",
        partner_diameter_m: double f64 = "12",
        partner_mass_kg: double f64 = "13",
        x_m: float f32 = "14",
        y_m: float f32 = "15",
        z_m: float f32 = "16",
        peak_force_n: double f64 = "17",
        sampled_force_n: double f64 = "18",
        arrival_force_n: double f64 = "19",
        peak_pressure_pa: double f64 = "20",
        normal_impulse_n_s: double f64 = "21",
        tangential_impulse_n_s: double f64 = "22",
        lost_energy_j: double f64 = "23",
        approach_speed_m_per_s: float f32 = "24",
        sliding_speed_m_per_s: float f32 = "25",
        effective_radius_m: float f32 = "26",
        arrival_pressure_pa: double f64 = "27",
    }
}

columns! {
    /// Classes of all hits by partner and force.
    HitClasses {
        wall: sint32 i32 = "1",
        force_class: sint32 i32 = "2",
        least_force_n: double f64 = "3",
        count: uint64 u64 = "4",
        kept: uint64 u64 = "5",
        normal_impulse_n_s: double f64 = "6",
        tangential_impulse_n_s: double f64 = "7",
        lost_energy_j: double f64 = "8",
        approach_energy_j: double f64 = "9",
    }
}

/// Index of a wall as it is written; of none, and of one beyond all numbers, that of no wall.
pub(super) fn wall_number(wall: Option<usize>) -> i32 {
    wall.and_then(|wall| i32::try_from(wall).ok())
        .unwrap_or(NO_WALL)
}

/// Hits as a message.
pub(crate) fn message(hits: &[Hit]) -> Hits {
    let mut block = Hits::default();
    for hit in hits {
        let (wall, partner, partner_diameter, partner_mass) = match hit.partner {
            HitPartner::Pellet { id, diameter, mass } => (NO_WALL, id, diameter, mass),
            HitPartner::Wall(wall) => (wall_number(Some(wall)), 0, 0.0, 0.0),
        };
        block.peak_time_s.push(hit.peak_time);
        block.begin_s.push(hit.begin);
        block.duration_s.push(hit.duration);
        block.steps.push(hit.steps);
        block.is_open.push(hit.is_open);
        block.cause.push(hit.cause as u32);
        block.pellet.push(hit.pellet);
        block.diameter_m.push(hit.diameter);
        block.mass_kg.push(hit.mass);
        block.wall.push(wall);
        block.partner.push(partner);
        block.partner_diameter_m.push(partner_diameter);
        block.partner_mass_kg.push(partner_mass);
        block.x_m.push(hit.place.x as f32);
        block.y_m.push(hit.place.y as f32);
        block.z_m.push(hit.place.z as f32);
        block.peak_force_n.push(hit.peak_force);
        block.sampled_force_n.push(hit.sampled_force);
        block.arrival_force_n.push(hit.arrival_force);
        block.peak_pressure_pa.push(hit.peak_pressure);
        block.normal_impulse_n_s.push(hit.normal_impulse);
        block.tangential_impulse_n_s.push(hit.tangential_impulse);
        block.lost_energy_j.push(hit.lost_energy);
        block.approach_speed_m_per_s.push(hit.approach_speed as f32);
        block.sliding_speed_m_per_s.push(hit.sliding_speed as f32);
        block.effective_radius_m.push(hit.effective_radius as f32);
        block.arrival_pressure_pa.push(hit.arrival_pressure);
    }
    block
}

/// The hits of a message; what is wrong with it.
pub(crate) fn hits(block: &Hits) -> Result<Vec<Hit>, String> {
    let rows = block.rows().ok_or(UNEQUAL_COLUMNS)?;
    let cause = |row: usize| {
        let number = block.cause[row] as usize;
        let cause = Cause::ALL.get(number).copied();
        cause.ok_or_else(|| format!("cause {number} is unknown"))
    };
    (0..rows)
        .map(|row| {
            Ok(Hit {
                pellet: block.pellet[row],
                diameter: block.diameter_m[row],
                mass: block.mass_kg[row],
                partner: match usize::try_from(block.wall[row]) {
                    Ok(wall) => HitPartner::Wall(wall),
                    Err(_) => HitPartner::Pellet {
                        id: block.partner[row],
                        diameter: block.partner_diameter_m[row],
                        mass: block.partner_mass_kg[row],
                    },
                },
                cause: cause(row)?,
                is_open: block.is_open[row],
                begin: block.begin_s[row],
                duration: block.duration_s[row],
                steps: block.steps[row],
                peak_time: block.peak_time_s[row],
                place: Vec3::new(
                    f64::from(block.x_m[row]),
                    f64::from(block.y_m[row]),
                    f64::from(block.z_m[row]),
                ),
                peak_force: block.peak_force_n[row],
                sampled_force: block.sampled_force_n[row],
                arrival_force: block.arrival_force_n[row],
                arrival_pressure: block.arrival_pressure_pa[row],
                peak_pressure: block.peak_pressure_pa[row],
                normal_impulse: block.normal_impulse_n_s[row],
                tangential_impulse: block.tangential_impulse_n_s[row],
                lost_energy: block.lost_energy_j[row],
                approach_speed: f64::from(block.approach_speed_m_per_s[row]),
                sliding_speed: f64::from(block.sliding_speed_m_per_s[row]),
                effective_radius: f64::from(block.effective_radius_m[row]),
            })
        })
        .collect()
}

/// The sketch of all hits as a message.
pub(crate) fn classes_message(classes: &BTreeMap<HitClassKey, HitClass>) -> HitClasses {
    let mut block = HitClasses::default();
    for (key, class) in classes {
        block.wall.push(wall_number(key.wall));
        block.force_class.push(key.force_class);
        block.least_force_n.push(key.forces()[0]);
        block.count.push(class.count);
        block.kept.push(class.kept);
        block.normal_impulse_n_s.push(class.normal_impulse);
        block.tangential_impulse_n_s.push(class.tangential_impulse);
        block.lost_energy_j.push(class.lost_energy);
        block.approach_energy_j.push(class.approach_energy);
    }
    block
}

/// The sketch of a message; what is wrong with it.
pub(crate) fn classes(block: &HitClasses) -> Result<BTreeMap<HitClassKey, HitClass>, String> {
    let rows = block.rows().ok_or(UNEQUAL_COLUMNS)?;
    let known = HitClassKey::FORCE_CLASSES;
    if let Some(class) = block
        .force_class
        .iter()
        .find(|class| !known.contains(class))
    {
        let (least, greatest) = (known.start(), known.end());
        return Err(format!(
            "its force class {class} is none; expected {least} to {greatest}"
        ));
    }
    let counts = || block.count.iter().zip(&block.kept);
    if let Some((count, kept)) = counts().find(|(count, kept)| kept > count) {
        return Err(format!("a class keeps {kept} of its {count} hits"));
    }
    let total = counts().try_fold(0_u64, |total, (count, _)| total.checked_add(*count));
    if total.is_none_or(|total| total > MOST_COUNTED) {
        return Err(format!("it counts more than {MOST_COUNTED} hits"));
    }
    Ok((0..rows)
        .map(|row| {
            let key = HitClassKey {
                wall: usize::try_from(block.wall[row]).ok(),
                force_class: block.force_class[row],
            };
            let class = HitClass {
                count: block.count[row],
                kept: block.kept[row],
                normal_impulse: block.normal_impulse_n_s[row],
                tangential_impulse: block.tangential_impulse_n_s[row],
                lost_energy: block.lost_energy_j[row],
                approach_energy: block.approach_energy_j[row],
            };
            (key, class)
        })
        .collect())
}
