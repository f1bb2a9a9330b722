//! `/contacts`: every contact as a point with its force, overlap and the two that touch.

use super::cloud::{Field, cloud, place, points, shortened, stride};
use super::hits::wall_number;
use foxglove::messages::PointCloud;
use foxglove::messages::packed_element_field::NumericType;
use pelletflow_sim::{ContactPartner, ContactView};

/// The values of a point, in order; `wall` is negative where two pellets touch, `partner` means nothing where it is not.
const FIELDS: [Field; 11] = [
    ("x", NumericType::Float32),
    ("y", NumericType::Float32),
    ("z", NumericType::Float32),
    ("force", NumericType::Float32),
    ("overlap", NumericType::Float32),
    ("force_x", NumericType::Float32),
    ("force_y", NumericType::Float32),
    ("force_z", NumericType::Float32),
    ("pellet", NumericType::Uint32),
    ("partner", NumericType::Uint32),
    ("wall", NumericType::Int32),
];

/// A contact as it is recorded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactRecord {
    /// Place [m].
    pub(crate) place: [f32; 3],
    /// Normal force [N].
    pub(crate) normal_force: f32,
    /// Overlap [m].
    pub(crate) overlap: f32,
    /// Force on the pellet [N].
    pub(crate) force: [f32; 3],
    /// Number of the pellet [-].
    pub(crate) pellet: u32,
    /// Number of the other pellet, if it is one [-].
    pub(crate) partner: u32,
    /// Index of the wall; negative where two pellets touch [-].
    pub(crate) wall: i32,
}

/// All contacts at a time [s], in the order given.
pub(crate) fn message(time: f64, contacts: &[ContactView]) -> PointCloud {
    let mut data = Vec::with_capacity(contacts.len() * stride(&FIELDS));
    for contact in contacts {
        let [x, y, z] = place(contact.point, contact.radius);
        let [normal, overlap] = [contact.normal_force, contact.overlap].map(shortened);
        let [force_x, force_y, force_z] = <[f64; 3]>::from(contact.force).map(shortened);
        for value in [x, y, z, normal, overlap, force_x, force_y, force_z] {
            data.extend_from_slice(&value.to_le_bytes());
        }
        let (partner, wall) = match contact.partner {
            ContactPartner::Pellet(id) => (id, wall_number(None)),
            ContactPartner::Wall(index) => (0, wall_number(Some(index))),
        };
        data.extend_from_slice(&contact.pellet.to_le_bytes());
        data.extend_from_slice(&partner.to_le_bytes());
        data.extend_from_slice(&wall.to_le_bytes());
    }
    cloud(time, &FIELDS, data)
}

/// The contacts of a message; what is missing in it.
pub(crate) fn contacts(cloud: &PointCloud) -> Result<impl Iterator<Item = ContactRecord>, String> {
    let contacts = points(cloud, &FIELDS)?.map(|values| {
        let number = |index: usize| f32::from_le_bytes(values[index]);
        ContactRecord {
            place: [0, 1, 2].map(number),
            normal_force: number(3),
            overlap: number(4),
            force: [5, 6, 7].map(number),
            pellet: u32::from_le_bytes(values[8]),
            partner: u32::from_le_bytes(values[9]),
            wall: i32::from_le_bytes(values[10]),
        }
    });
    Ok(contacts)
}
