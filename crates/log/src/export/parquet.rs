//! Tables as Parquet: columns with their types, compressed, with the facts of the run.

use crate::tables::{Column, Table, Tables, Values};
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical, ZstdLevel};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{Type, TypePtr};
use std::fs::File;
use std::io::{self, BufWriter};
use std::sync::Arc;

/// A table as Parquet, a group of rows for each part.
pub(super) struct Sheet {
    writer: SerializedFileWriter<BufWriter<File>>,
}

impl Sheet {
    /// Begins a file with the types of the columns, their units and the facts of the run.
    pub(super) fn create(file: BufWriter<File>, table: &Table, of: &Tables) -> io::Result<Self> {
        let facts = of.facts.iter().map(|(key, value)| (key.clone(), value));
        let units = table.columns.iter().map(|column| {
            let key = format!("unit.{}", column.name);
            (key, column.unit.to_owned())
        });
        let facts = facts.map(|(key, value)| (format!("pelletflow.{key}"), value.clone()));
        let told = facts.chain(units);
        let properties = WriterProperties::builder()
            .set_compression(Compression::ZSTD(ZstdLevel::default()))
            .set_created_by(format!("pelletflow {}", env!("CARGO_PKG_VERSION")))
            .set_key_value_metadata(Some(
                told.map(|(key, value)| KeyValue::new(key, value)).collect(),
            ))
            .build();
        let fields: Result<Vec<TypePtr>, ParquetError> = table
            .columns
            .iter()
            .map(|column| kind(column).map(Arc::new))
            .collect();
        let schema = fields.and_then(|fields| {
            Type::group_type_builder(&table.name)
                .with_fields(fields)
                .build()
        });
        let writer = schema.and_then(|schema| {
            SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))
        });
        Ok(Self {
            writer: writer.map_err(as_io)?,
        })
    }
}

impl super::Sheet for Sheet {
    const ENDING: &'static str = "parquet";

    fn append(&mut self, table: &Table) -> io::Result<()> {
        if table.rows() > 0 {
            group(&mut self.writer, table).map_err(as_io)?;
        }
        Ok(())
    }

    fn finish(self) -> io::Result<()> {
        super::flushed(self.writer.into_inner().map_err(as_io)?)
    }
}

fn group(
    writer: &mut SerializedFileWriter<BufWriter<File>>,
    table: &Table,
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    for column in &table.columns {
        let mut file = group
            .next_column()?
            .expect("the file has a column for each of the table");
        put(file.untyped(), column)?;
        file.close()?;
    }
    group.close()?;
    Ok(())
}

/// The type of a column.
fn kind(column: &Column) -> Result<Type, ParquetError> {
    let unsigned = |bits| Some(LogicalType::integer(bits, false));
    let (physical, logical) = match &column.values {
        Values::Float32(_) => (Physical::FLOAT, None),
        Values::Float64(_) => (Physical::DOUBLE, None),
        Values::Int32(_) => (Physical::INT32, None),
        Values::UInt32(_) => (Physical::INT32, unsigned(32)),
        Values::UInt64(_) => (Physical::INT64, unsigned(64)),
        Values::Bool(_) => (Physical::BOOLEAN, None),
        Values::Text(_) | Values::Label { .. } => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    };
    let repetition = match column.is_known {
        Some(_) => Repetition::OPTIONAL,
        None => Repetition::REQUIRED,
    };
    Type::primitive_type_builder(&column.name, physical)
        .with_logical_type(logical)
        .with_repetition(repetition)
        .build()
}

/// Writes the values of a column, those that are known.
fn put(writer: &mut ColumnWriter, column: &Column) -> Result<(), ParquetError> {
    let levels: Option<Vec<i16>> = column
        .is_known
        .as_ref()
        .map(|known| known.iter().map(|&is_known| i16::from(is_known)).collect());
    let levels = levels.as_deref();
    match (writer, &column.values) {
        (ColumnWriter::FloatColumnWriter(writer), Values::Float32(values)) => {
            writer.write_batch(&known(column, values.iter().copied()), levels, None)
        }
        (ColumnWriter::DoubleColumnWriter(writer), Values::Float64(values)) => {
            writer.write_batch(&known(column, values.iter().copied()), levels, None)
        }
        (ColumnWriter::Int32ColumnWriter(writer), Values::Int32(values)) => {
            writer.write_batch(&known(column, values.iter().copied()), levels, None)
        }
        (ColumnWriter::Int32ColumnWriter(writer), Values::UInt32(values)) => {
            let values = values.iter().map(|value| value.cast_signed());
            writer.write_batch(&known(column, values), levels, None)
        }
        (ColumnWriter::Int64ColumnWriter(writer), Values::UInt64(values)) => {
            let values = values.iter().map(|value| value.cast_signed());
            writer.write_batch(&known(column, values), levels, None)
        }
        (ColumnWriter::BoolColumnWriter(writer), Values::Bool(values)) => {
            writer.write_batch(&known(column, values.iter().copied()), levels, None)
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Values::Text(values)) => {
            let values = values.iter().map(|text| ByteArray::from(text.as_str()));
            writer.write_batch(&known(column, values), levels, None)
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Values::Label { labels, indices }) => {
            let values = indices.iter().map(|&index| {
                ByteArray::from(labels.get(index as usize).map_or("", String::as_str))
            });
            writer.write_batch(&known(column, values), levels, None)
        }
        _ => unreachable!("the types of the file are those of the table"),
    }?;
    Ok(())
}

/// The values of a column that are known.
fn known<T>(column: &Column, values: impl Iterator<Item = T>) -> Vec<T> {
    let rows = values.enumerate();
    rows.filter(|(row, _)| column.is_known(*row))
        .map(|(_, value)| value)
        .collect()
}

fn as_io(error: ParquetError) -> io::Error {
    io::Error::other(error)
}
