//! Messages of our own: a row of named numbers, for meters and ledgers.
//!
//! A meter names its quantities itself, so the protobuf schema is made from the names:
//! a new meter needs nothing here.

use foxglove::Schema;
use foxglove::prost_types::field_descriptor_proto::{Label, Type};
use foxglove::prost_types::{
    DescriptorProto, FieldDescriptorProto, FileDescriptorProto, FileDescriptorSet,
};
use pelletflow_sim::{EnergyLedger, MassLedger, MeterReading};
use prost::Message;

/// Protobuf package of our messages.
const PACKAGE: &str = "pelletflow";
/// Wire type of a `double` in a protobuf tag.
const EIGHT_BYTES: u64 = 1;

/// Named values, each with its unit in the name.
pub(crate) type Row<'a> = [(&'a str, f64)];

/// The schema of a message of the given kind, such as `mass-flow`, with one `double` per value.
pub(crate) fn schema(kind: &str, row: &Row) -> Schema {
    let name = type_name(kind);
    let field = row
        .iter()
        .zip(1..)
        .map(|((field, _), number)| FieldDescriptorProto {
            name: Some((*field).into()),
            number: Some(number),
            label: Some(Label::Optional as i32),
            r#type: Some(Type::Double as i32),
            json_name: Some((*field).into()),
            ..FieldDescriptorProto::default()
        })
        .collect();
    let file = FileDescriptorProto {
        name: Some(format!("{PACKAGE}/{name}.proto")),
        package: Some(PACKAGE.into()),
        message_type: vec![DescriptorProto {
            name: Some(name.clone()),
            field,
            ..DescriptorProto::default()
        }],
        syntax: Some("proto3".into()),
        ..FileDescriptorProto::default()
    };
    let files = FileDescriptorSet { file: vec![file] };
    Schema::new(
        format!("{PACKAGE}.{name}"),
        "protobuf",
        files.encode_to_vec(),
    )
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
