//! Arguments of `pelletflow score`.

use super::quantity::force;
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// Places told unless asked otherwise [-].
pub(crate) const USUAL_PLACES: usize = 10;

#[derive(Debug, Args)]
#[command(after_help = "\
The recorded hits are held against a strength; nothing is simulated again. Change the strength and score again.

Examples:
  pelletflow score out/chute/run.mcap --strength 2.45kN           every pellet breaks at this load
  pelletflow score out/chute/run.mcap --strength works-a.toml     by a card: its loads and their scatter
  pelletflow score out/chute/run.mcap --strength works-a.toml --law energy   by its fracture energy and damage
  pelletflow score out/chute/run.mcap --strength works-a.toml --json | jq .by_wall

`pelletflow card` makes a card of a sheet of the laboratory.")]
pub(crate) struct ScoreArguments {
    /// Recording.
    pub(crate) recording: PathBuf,
    /// A load that breaks every pellet, such as 2.45kN, or a strength card.
    #[arg(long, value_name = "LOAD|CARD", value_parser = strength, allow_hyphen_values = true)]
    pub(crate) strength: StrengthArgument,
    /// What breaks a pellet, where a card tells both.
    #[arg(long, value_name = "LAW", value_enum, default_value_t = LawName::Load)]
    pub(crate) law: LawName,
    /// Number of places listed.
    #[arg(
        long,
        value_name = "N",
        default_value_t = USUAL_PLACES,
        allow_negative_numbers = true
    )]
    pub(crate) places: usize,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// A strength as it stands on the command line.
#[derive(Debug, Clone)]
pub(crate) enum StrengthArgument {
    /// A load [N].
    Load(f64),
    /// A card, by its path.
    Card(PathBuf),
}

/// What breaks a pellet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LawName {
    /// The greatest force that it ever feels.
    Load,
    /// The energy of a blow, against a fracture energy that every blow lowers.
    Energy,
}

/// What begins as a number is a load, all else a card.
pub(super) fn strength(text: &str) -> Result<StrengthArgument, String> {
    let is_number = text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
    let is_file = Path::new(text)
        .extension()
        .is_some_and(|ending| ending == "toml");
    if is_number && !is_file {
        force(text).map(StrengthArgument::Load)
    } else {
        Ok(StrengthArgument::Card(text.into()))
    }
}
