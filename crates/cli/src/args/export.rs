//! Arguments of `pelletflow export`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "\
Names end in their unit; everything is SI.
  vtk      pellets.pvd and walls.pvd, to be opened in ParaView, with a file for each frame; hits.vtp
  csv      bodies.csv, hits.csv, mass_ledger.csv and so on, and meters/NAME.csv
  parquet  the same with types, compressed, for data frames

Examples:
  pelletflow export out/hopper/run.mcap --format vtk -o hopper-vtk
  pelletflow export out/hopper/run.mcap --format csv -o hopper-csv
  pelletflow export out/hopper/run.mcap --format parquet -o hopper   then pandas.read_parquet(\"hopper/bodies.parquet\")")]
pub(crate) struct ExportArguments {
    /// Recording.
    pub(crate) recording: PathBuf,
    /// What it is written as.
    #[arg(long, value_name = "FORMAT", value_enum)]
    pub(crate) format: FormatName,
    /// Directory of the files; made where it does not exist.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
}

/// What a recording is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FormatName {
    /// For `ParaView`.
    Vtk,
    /// For spreadsheets.
    Csv,
    /// For data frames.
    Parquet,
}
