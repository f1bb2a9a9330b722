//! `meters/NAME.csv`: what each patch of a wall received.

use crate::error::RunError;
use crate::output::Output;
use crate::summary::PatchSummary;
use pelletflow_sim::{PatchTable, Simulation};
use std::fmt::Write;

/// Patches that the summary shows of each meter [-].
const WORST: usize = 5;

/// Writes a table for every meter that keeps patches.
///
/// Done before a run as well, so that none of an earlier run stands beside a new recording.
pub(crate) fn write(output: &Output, simulation: &Simulation) -> Result<(), RunError> {
    for (name, table) in simulation.patch_tables() {
        output.write_in("meters", &format!("{name}.csv"), &csv(&table))?;
    }
    Ok(())
}

/// A line of names, then a line for each patch, the worst first; numbers as short as they can be without loss.
fn csv(table: &PatchTable) -> String {
    let mut text = table.columns.join(",");
    text.push('\n');
    for row in &table.rows {
        for (index, value) in row.iter().enumerate() {
            let separator = if index > 0 { "," } else { "" };
            write!(text, "{separator}{value:?}").expect("a text takes all that is written to it");
        }
        text.push('\n');
    }
    text
}

/// The worst patches of a table, each with its place.
pub(crate) fn worst(table: &PatchTable) -> Vec<PatchSummary> {
    let named = |row: &Vec<f64>| {
        let names = table.columns.iter().map(|&column| column.into());
        names.zip(row.iter().copied()).collect()
    };
    table.rows.iter().take(WORST).map(named).collect()
}
