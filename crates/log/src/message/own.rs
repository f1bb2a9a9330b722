//! Schemas of messages of our own.

use foxglove::Schema;
use foxglove::prost_types::field_descriptor_proto::{Label, Type};
use foxglove::prost_types::{
    DescriptorProto, FieldDescriptorProto, FileDescriptorProto, FileDescriptorSet,
};
use prost::Message;

/// Protobuf package of our messages.
const PACKAGE: &str = "pelletflow";

/// The schema of a message of this name, whose fields are numbered from 1 on and all are one value, or all a column.
pub(crate) fn schema<'a>(
    name: &str,
    label: Label,
    fields: impl IntoIterator<Item = (&'a str, Type)>,
) -> Schema {
    let field = fields
        .into_iter()
        .zip(1..)
        .map(|((field, kind), number)| FieldDescriptorProto {
            name: Some(field.into()),
            number: Some(number),
            label: Some(label as i32),
            r#type: Some(kind as i32),
            json_name: Some(field.into()),
            ..FieldDescriptorProto::default()
        })
        .collect();
    let file = FileDescriptorProto {
        name: Some(format!("{PACKAGE}/{name}.proto")),
        package: Some(PACKAGE.into()),
        message_type: vec![DescriptorProto {
            name: Some(name.into()),
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
