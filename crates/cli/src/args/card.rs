//! Arguments of `pelletflow card`.

use super::hit::HitArguments;
use super::quantity::{length, modulus, plain, share};
use super::safe_speed::DistributionName;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "\
A sheet of a crushing test, one line for each pellet; the diameter may be left out:
  # date: 2024-07-01
  load [kN], diameter [mm]
  2.41,      12.1
  1.87,      11.6

A sheet of a drop test, one line for each height or speed, each pellet dropped once:
  height [m], dropped, broken
  5,          60,      4

Loads in N, kN, daN, kgf or MN; semicolons go with decimal commas.

Examples:
  pelletflow card --crush loads.csv --name \"works A, July\" -o works-a.toml
  pelletflow card --crush loads.csv --unit kgf --distribution weibull
  pelletflow card --crush loads.csv --drop drops.csv --tumble 94.5% --pellet fired-pellet
  pelletflow safe-speed --strength-card works-a.toml --pellet fired-pellet")]
pub(crate) struct CardArguments {
    /// Sheet of a crushing test, a table of comma-separated values.
    #[arg(long, value_name = "FILE")]
    pub(crate) crush: PathBuf,
    /// Unit of the loads where the header tells none: N, kN, daN, kgf.
    #[arg(long, value_name = "UNIT")]
    pub(crate) unit: Option<String>,
    /// How the load scatters [default: the one that the loads lie nearer to].
    #[arg(long, value_name = "NAME", value_enum)]
    pub(crate) distribution: Option<DistributionName>,
    /// Diameter of the pellets crushed, where the sheet has no column of it.
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    pub(crate) test_diameter: Option<f64>,
    /// Pressure in the middle of a contact that the pellets yield under; goes into the card.
    #[arg(long, value_name = "PRESSURE", value_parser = modulus)]
    pub(crate) yield_pressure: Option<f64>,
    /// Sheet of a drop test: gives the fracture energy of single blows.
    #[arg(long, value_name = "FILE")]
    pub(crate) drop: Option<PathBuf>,
    /// Damage constant γ of repeated blows; goes into the card with the fracture energy.
    #[arg(long, value_name = "NUMBER", value_parser = damage_constant, requires = "drop")]
    pub(crate) damage_constant: Option<f64>,
    /// Tumble index (ISO 3271), such as 94.5%: kept as a note on attrition, used for nothing else.
    #[arg(long, value_name = "SHARE", value_parser = part)]
    pub(crate) tumble: Option<f64>,
    /// Abrasion index (ISO 3271), such as 4.5%.
    #[arg(long, value_name = "SHARE", value_parser = part, requires = "tumble")]
    pub(crate) abrasion: Option<f64>,
    /// Name of the pellets [default: the name of the sheet].
    #[arg(long, value_name = "TEXT")]
    pub(crate) name: Option<String>,
    /// File of the card; never one that exists.
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Draw the loads and the distribution as SVG.
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Gives the forces of a drop test by Hertz.
    #[command(flatten)]
    pub(crate) hit: HitArguments,
}

/// A share from 0 to 1.
fn part(text: &str) -> Result<f64, String> {
    let part = share(text)?;
    if (0.0..=1.0).contains(&part) {
        return Ok(part);
    }
    Err(format!(
        "`{text}` is no index; expected 0 to 1, for example 94.5%"
    ))
}

fn damage_constant(text: &str) -> Result<f64, String> {
    let constant = plain(text)?;
    if constant > 0.0 {
        return Ok(constant);
    }
    Err(format!(
        "a damage constant of {constant} is none; expected more than 0"
    ))
}
