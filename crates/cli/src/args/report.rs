//! Arguments of `pelletflow report`.

use super::score::{LawName, StrengthArgument, strength};
use clap::Args;
use std::path::PathBuf;

/// Bytes that a page is allowed unless told otherwise: what a mail takes and a browser opens at once [B].
const USUAL_SIZE: &str = "8MB";
/// Least size of a page [B]: below, nothing is left for the replay.
const LEAST_SIZE: f64 = 0.5e6;
/// Greatest size of a page [B]: above, browsers refuse it.
const GREATEST_SIZE: f64 = 400.0e6;

#[derive(Debug, Args)]
#[command(after_help = "\
The page opens in any browser without a network: what was run, plots, the hits, and a replay in space.
Where a recording is too large for a page, it shows fewer frames, then fewer pellets, and says so.

Examples:
  pelletflow report out/hopper/run.mcap                      write out/hopper/report.html
  pelletflow report out/hopper/run.mcap -o hopper.html --strength 80N   show which hits break pellets
  pelletflow report out/chute/run.mcap --strength works-a.toml   by a card: where pellets may break, and how likely
  pelletflow report out/plant/run.mcap --max-size 40MB       more frames, more pellets")]
pub(crate) struct ReportArguments {
    /// Recording.
    pub(crate) recording: PathBuf,
    /// Page to write [default: report.html beside the recording].
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// A load that breaks every pellet, such as 2.45kN, or a strength card [default: the load of the scene's [strength]].
    #[arg(long, value_name = "LOAD|CARD", value_parser = strength, allow_hyphen_values = true)]
    pub(crate) strength: Option<StrengthArgument>,
    /// What breaks a pellet, where a card tells both.
    #[arg(long, value_name = "LAW", value_enum, default_value_t = LawName::Load, requires = "strength")]
    pub(crate) law: LawName,
    /// Size of the page at most, such as 8MB.
    #[arg(long, value_name = "SIZE", value_parser = size, default_value = USUAL_SIZE)]
    pub(crate) max_size: usize,
}

/// A number of bytes such as `8MB`.
fn size(text: &str) -> Result<usize, String> {
    let units = [("kB", 1.0e3), ("MB", 1.0e6), ("GB", 1.0e9)];
    let parsed = units.iter().find_map(|(unit, bytes)| {
        let number = text.trim().strip_suffix(unit)?;
        Some(number.trim().parse::<f64>().ok()? * bytes)
    });
    match parsed {
        Some(bytes) if (LEAST_SIZE..=GREATEST_SIZE).contains(&bytes) => Ok(bytes as usize),
        Some(_) => Err("expected at least 500kB and at most 400MB".into()),
        None => Err("expected a size such as 8MB".into()),
    }
}
