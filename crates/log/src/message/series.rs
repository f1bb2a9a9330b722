//! Messages of our own: a row of named numbers, for meters and ledgers.
//!
//! A meter names its quantities itself, so the protobuf schema is made from the names:
//! a new meter needs nothing here.

use super::own;
use foxglove::Schema;
use foxglove::prost_types::FileDescriptorSet;
use foxglove::prost_types::field_descriptor_proto::{Label, Type};
use pelletflow_sim::{EnergyLedger, MassLedger, MeterReading};
use prost::Message;

/// Wire type of a `double` in a protobuf tag.
const EIGHT_BYTES: u64 = 1;

/// Named values, each with its unit in the name.
pub(crate) type Row<'a> = [(&'a str, f64)];

/// The schema of a message of the given kind, such as `mass-flow`, with one `double` per value.
pub(crate) fn schema(kind: &str, row: &Row) -> Schema {
    let fields = row.iter().map(|(field, _)| (*field, Type::Double));
    own::schema(&type_name(kind), Label::Optional, fields)
}

/// The values on the wire, in the order of the schema.
pub(crate) fn encode(row: &Row) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(row.len() * 10);
    for ((_, value), number) in row.iter().zip(1_u64..) {
        prost::encoding::encode_varint(number << 3 | EIGHT_BYTES, &mut bytes);
        bytes.extend_from_slice(&value.to_le_bytes());
    }
    bytes
}

/// The values of a message that [`encode`] made, in the order of the schema; none where it has another form.
pub(crate) fn decode(bytes: &[u8]) -> Option<Vec<f64>> {
    let mut rest = bytes;
    let mut values = Vec::new();
    while !rest.is_empty() {
        let number = values.len() as u64 + 1;
        let tag = prost::encoding::decode_varint(&mut rest).ok()?;
        let (value, after) = rest.split_first_chunk()?;
        if tag != (number << 3 | EIGHT_BYTES) {
            return None;
        }
        values.push(f64::from_le_bytes(*value));
        rest = after;
    }
    Some(values)
}

/// The first value of a message that [`encode`] made; none where it has another form.
pub(crate) fn first_value(bytes: &[u8]) -> Option<f64> {
    decode(bytes)?.first().copied()
}

/// Names of the values of a message, in their order, from its schema; none where that is not one of ours.
pub(crate) fn names(schema: &[u8]) -> Option<Vec<String>> {
    let files = FileDescriptorSet::decode(schema).ok()?;
    let message = files.file.into_iter().next()?.message_type.pop()?;
    let fields = message.field.into_iter().zip(1..);
    fields
        .map(|(field, number)| (field.number == Some(number)).then_some(field.name)?)
        .collect()
}

/// `mass-flow` becomes `MassFlow`.
fn type_name(kind: &str) -> String {
    kind.split('-')
        .flat_map(|word| {
            let (first, rest) = word.split_at(word.len().min(1));
            [first.to_uppercase(), rest.into()]
        })
        .collect()
}

/// What a meter reads.
pub(crate) fn meter(reading: &MeterReading) -> &Row<'static> {
    &reading.values
}

/// The mass ledger.
pub(crate) fn mass(ledger: &MassLedger) -> [(&'static str, f64); 9] {
    [
        ("inserted", ledger.inserted.count as f64),
        ("inside", ledger.inside.count as f64),
        ("discharged", ledger.discharged.count as f64),
        ("lost", ledger.lost.count as f64),
        ("inserted_kg", ledger.inserted.mass),
        ("inside_kg", ledger.inside.mass),
        ("discharged_kg", ledger.discharged.mass),
        ("lost_kg", ledger.lost.mass),
        ("residual_kg", mass_residual(ledger)),
    ]
}

/// Mass that the ledger misses [kg].
pub(crate) fn mass_residual(ledger: &MassLedger) -> f64 {
    ledger.inserted.mass - ledger.inside.mass - ledger.discharged.mass - ledger.lost.mass
}

/// The energy ledger.
pub(crate) fn energy(ledger: &EnergyLedger) -> [(&'static str, f64); 8] {
    [
        ("kinetic_j", ledger.kinetic),
        ("potential_j", ledger.potential),
        ("elastic_j", ledger.elastic),
        ("dissipated_j", ledger.dissipated),
        ("carried_in_j", ledger.carried_in),
        ("wall_work_j", ledger.wall_work),
        ("residual_j", ledger.residual),
        ("throughput_j", ledger.throughput),
    ]
}
