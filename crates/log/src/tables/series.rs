//! Meters and ledgers: rows of named numbers over time, by the names in their schema.

use super::{Column, Table};
use crate::message::series;

/// A row for every message.
pub(super) struct Series {
    name: String,
    time: Vec<f64>,
    /// Quantities, in the order of their numbers from 1 on.
    quantities: Vec<(String, Vec<f64>)>,
}

impl Series {
    /// A table of a name, with the fields of a schema; what is wrong with that.
    pub(super) fn new(name: &str, schema: &[u8]) -> Result<Self, String> {
        let names = series::names(schema).ok_or("its schema is no row of names")?;
        Ok(Self {
            name: name.into(),
            time: Vec::new(),
            quantities: names.into_iter().map(|name| (name, Vec::new())).collect(),
        })
    }

    pub(super) fn take(&mut self, time: f64, data: &[u8]) -> Result<(), String> {
        let values = series::decode(data).ok_or("its fields are no row of numbers")?;
        if values.len() != self.quantities.len() {
            return Err(format!(
                "it has {} values; its schema has {}",
                values.len(),
                self.quantities.len()
            ));
        }
        self.time.push(time);
        for ((_, column), value) in self.quantities.iter_mut().zip(values) {
            column.push(value);
        }
        Ok(())
    }

    pub(super) fn table(self) -> Table {
        let quantities = self.quantities.into_iter();
        let columns = quantities.map(|(name, values)| Column::new(name, values));
        Table {
            name: self.name,
            columns: std::iter::once(Column::new("time_s", self.time))
                .chain(columns)
                .collect(),
        }
    }
}
