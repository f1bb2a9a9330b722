//! Hits in full, and the sketch of all of them, with names for their numbers.

use super::{Column, Table, TableKind, Values};
use crate::message::hits;
use pelletflow_sim::{Cause, Hit};
use prost::Message;

/// A row for every hit kept in full, in the order in which they ended.
#[derive(Default)]
pub(super) struct Hits {
    rows: hits::Hits,
}

impl Hits {
    pub(super) fn take(&mut self, data: &[u8]) -> Result<(), String> {
        // Columns of a message lengthen those that are there.
        self.rows.merge(data).map_err(|error| error.to_string())?;
        let rows = self.rows.rows();
        rows.map(drop)
            .ok_or_else(|| hits::UNEQUAL_COLUMNS.to_owned())
    }

    /// The table; what is wrong with its rows.
    pub(super) fn table(self, walls: &[String]) -> Result<Table, String> {
        let causes = Cause::ALL.map(|cause| cause.name().to_owned());
        let with_pellet: Vec<bool> = self.rows.wall.iter().map(|wall| *wall < 0).collect();
        let columns = self.rows.into_columns().into_iter().map(|column| {
            match (column.name.as_str(), column.values) {
                ("wall", Values::Int32(indices)) => wall_names(&indices, walls),
                ("cause", Values::UInt32(indices)) => named(column.name, indices, &causes, "cause"),
                ("partner" | "partner_diameter_m" | "partner_mass_kg", values) => {
                    Ok(Column::new(column.name, values).known_where(with_pellet.clone()))
                }
                (_, values) => Ok(Column::new(column.name, values)),
            }
        });
        Ok(Table {
            name: TableKind::Hits.name().into(),
            columns: columns.collect::<Result<_, _>>()?,
        })
    }
}

/// Hits as the table that a recording of them is read as; `walls` are the names of the walls, in the order of the setup.
///
/// # Panics
/// When a hit is with a wall that has no name.
pub fn hits_table(hits: &[Hit], walls: &[String]) -> Table {
    let rows = hits::message(hits);
    let table = Hits { rows }.table(walls);
    table.expect("every wall of a hit has its name")
}

/// A row for every class of hits, in the last sketch.
#[derive(Default)]
pub(super) struct Classes {
    rows: hits::HitClasses,
}

impl Classes {
    pub(super) fn take(&mut self, data: &[u8]) -> Result<(), String> {
        self.rows = hits::HitClasses::decode(data).map_err(|error| error.to_string())?;
        hits::classes(&self.rows).map(drop)
    }

    /// The table; what is wrong with its rows.
    pub(super) fn table(self, walls: &[String]) -> Result<Table, String> {
        let columns = self.rows.into_columns().into_iter().map(|column| {
            match (column.name.as_str(), column.values) {
                ("wall", Values::Int32(indices)) => wall_names(&indices, walls),
                (_, values) => Ok(Column::new(column.name, values)),
            }
        });
        Ok(Table {
            name: TableKind::HitClasses.name().into(),
            columns: columns.collect::<Result<_, _>>()?,
        })
    }
}

/// Names of walls by index; none where the partner is a pellet, whose index is negative.
pub(super) fn wall_names(indices: &[i32], walls: &[String]) -> Result<Column, String> {
    let is_wall = indices.iter().map(|index| *index >= 0).collect();
    let indices = indices
        .iter()
        .map(|index| u32::try_from(*index).unwrap_or(0));
    let mut labels = walls.to_vec();
    if labels.is_empty() {
        // Rows without a wall have to name something.
        labels.push(String::new());
    }
    let column = named("wall".into(), indices.collect(), &labels, "wall")?;
    Ok(column.known_where(is_wall))
}

/// A column of names by index; what is wrong with an index.
fn named(name: String, indices: Vec<u32>, labels: &[String], what: &str) -> Result<Column, String> {
    if let Some(unknown) = indices
        .iter()
        .find(|index| **index as usize >= labels.len())
    {
        return Err(format!(
            "its rows tell of {what} {unknown}; it knows {} from 0 on",
            labels.len()
        ));
    }
    let labels = labels.to_vec();
    Ok(Column::new(name, Values::Label { labels, indices }))
}
