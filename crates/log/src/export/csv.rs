//! Tables as text with commas.

use crate::tables::{Table, Tables, Values};
use csv::Writer;
use std::fs::File;
use std::io::{self, BufWriter};

/// A table as text: a line of names, then a line for each row. An unknown value is empty.
pub(super) struct Sheet {
    writer: Writer<BufWriter<File>>,
}

impl Sheet {
    /// Begins a file with the names of the columns.
    pub(super) fn create(file: BufWriter<File>, table: &Table, _: &Tables) -> io::Result<Self> {
        let mut writer = Writer::from_writer(file);
        writer.write_record(table.columns.iter().map(|column| &column.name))?;
        Ok(Self { writer })
    }
}

impl super::Sheet for Sheet {
    const ENDING: &'static str = "csv";

    fn append(&mut self, table: &Table) -> io::Result<()> {
        for row in 0..table.rows() {
            for column in &table.columns {
                let cell = if column.is_known(row) {
                    text(&column.values, row)
                } else {
                    String::new()
                };
                self.writer.write_field(cell)?;
            }
            self.writer.write_record(None::<&[u8]>)?;
        }
        Ok(())
    }

    fn finish(mut self) -> io::Result<()> {
        self.writer.flush()
    }
}

/// A value as short as it can be without loss.
fn text(values: &Values, row: usize) -> String {
    match values {
        Values::Float32(values) => format!("{:?}", values[row]),
        Values::Float64(values) => format!("{:?}", values[row]),
        Values::Int32(values) => values[row].to_string(),
        Values::UInt32(values) => values[row].to_string(),
        Values::UInt64(values) => values[row].to_string(),
        Values::Bool(values) => values[row].to_string(),
        Values::Text(values) => values[row].clone(),
        Values::Label { labels, indices } => labels[indices[row] as usize].clone(),
    }
}
