//! `pelletflow export`.

use crate::args::export::{ExportArguments, FormatName};
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::count;
use pelletflow_log::{ExportFormat, export};

/// Writes a recording as files of other programs.
pub(crate) fn write_export(arguments: &ExportArguments) -> Result<Exit, Failure> {
    if arguments.output.is_file() {
        let message = format!(
            "{} is a file; name a directory for the files of an export",
            arguments.output.display()
        );
        return Err(Failure::new(Exit::BadInput, message));
    }
    let format = match arguments.format {
        FormatName::Vtk => ExportFormat::Vtk,
        FormatName::Csv => ExportFormat::Csv,
        FormatName::Parquet => ExportFormat::Parquet,
    };
    let exported = export(&arguments.recording, format, &arguments.output)?;
    let mut lines: Vec<String> = exported
        .files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    lines.push(format!("{} frames", count(exported.frames as u64)));
    if exported.is_cut_off {
        lines.push("the recording is cut off: what came after the cut is missing".into());
    }
    screen::result(&lines.join("\n"))?;
    Ok(Exit::Done)
}
