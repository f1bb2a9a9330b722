//! Files that a command writes beside what it prints.

use crate::commands::hit::bad_input;
use crate::exit::{Exit, Failure};
use pelletflow_log::plot::Chart;
use std::path::Path;

/// Writes a chart as SVG.
pub(crate) fn draw(path: &Path, chart: &Chart) -> Result<(), Failure> {
    let svg = chart
        .to_svg()
        .map_err(|error| bad_input(error.to_string()))?;
    write(path, &svg)
}

/// Writes text.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(|error| {
        Failure::new(
            Exit::InputOutput,
            format!(
                "{} cannot be written: {error}; name another file",
                path.display()
            ),
        )
    })
}
