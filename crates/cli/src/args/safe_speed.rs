//! Arguments of `pelletflow safe-speed` and `pelletflow materials`.

use super::hit::HitArguments;
use super::quantity::{
    ModulusRange, ValueRange, force, length, modulus_range, risk, share, speed, value_range,
};
use super::thread_count;
use crate::commands::hit::bad_input;
use crate::exit::Failure;
use clap::{ArgGroup, Args, ValueEnum};
use pelletflow_scene::Override;
use std::path::PathBuf;

const SCENE: &str = "Scene";

#[derive(Debug, Args)]
#[command(
    group = ArgGroup::new("given_strength").required(true).args(["strength", "strength_card"]),
    after_help = "\
Examples:
  pelletflow safe-speed --strength 2.45kN --scatter 30% --tests 60 --risk 1% --pellet fired-pellet
  pelletflow safe-speed --strength 2.45kN --diameter 15mm --shear-modulus 60MPa --poisson 0.22 --density 3700
  pelletflow safe-speed --strength-card works-a.toml --risk 0.1% --diameter 12mm --youngs-modulus 2GPa --json

In a scene, by whole runs, each with another value of one setting:
  pelletflow safe-speed --strength-card works-a.toml --scene chute.toml --range 2..15m/s
  pelletflow safe-speed --strength-card works-a.toml --scene plate.toml --vary walls.plate.motion.angle --range 10..60deg

A strength card, as `pelletflow card` makes it of a sheet:
  name = \"works A, July\"
  source = \"60 pellets, ISO 4700\"
  distribution = \"log-normal\"        # or \"weibull\", \"fixed\"
  mean = \"2.45 kN\"
  coefficient_of_variation = \"30 %\"   # or: median and deviation; for Weibull: scale and modulus
  test_diameter = \"11.25 mm\"          # left out, the load is that of any size
  sample_size = 60                    # left out, the numbers count as exact"
)]
pub(crate) struct SafeSpeedArguments {
    #[command(flatten)]
    pub(crate) hit: HitArguments,
    #[command(flatten)]
    pub(crate) of_scene: SceneArguments,
    /// Crushing load: the mean where --scatter is given, the load of every pellet where it is not.
    #[arg(long, value_name = "FORCE", value_parser = force)]
    pub(crate) strength: Option<f64>,
    /// TOML file of a crushing test.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["scatter", "distribution", "tests", "test_diameter"])]
    pub(crate) strength_card: Option<PathBuf>,
    /// Standard deviation of the crushing load over its mean, such as 30%.
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true)]
    pub(crate) scatter: Option<f64>,
    /// How the crushing load scatters.
    #[arg(long, value_name = "NAME", value_enum, requires = "scatter", default_value_t = DistributionName::LogNormal)]
    pub(crate) distribution: DistributionName,
    /// Number of pellets crushed; the numbers count as exact where it is left out.
    #[arg(long, value_name = "N", requires = "scatter", value_parser = clap::value_parser!(u32).range(2..))]
    pub(crate) tests: Option<u32>,
    /// Diameter of the pellets crushed; left out, the load is that of any size.
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    pub(crate) test_diameter: Option<f64>,
    /// Share of pellets that may break, such as 1%.
    #[arg(long, value_name = "SHARE", value_parser = risk, default_value = "1%", allow_hyphen_values = true)]
    pub(crate) risk: f64,
    /// Shear moduli of the pellet between which the truth lies [default: the library's, for one of its pellets].
    #[arg(long, value_name = "LOW..HIGH", value_parser = modulus_range)]
    pub(crate) shear_modulus_range: Option<ModulusRange>,
    /// Fall that the chute must bear; its slope is chosen for it.
    #[arg(long, value_name = "HEIGHT", value_parser = length, default_value = "5m", conflicts_with = "arrival_speed")]
    pub(crate) fall: f64,
    /// Speed straight down that the chute must bear, in place of a fall.
    #[arg(long, value_name = "SPEED", value_parser = speed)]
    pub(crate) arrival_speed: Option<f64>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

impl SceneArguments {
    /// What only a scene has use for is refused where there is none.
    ///
    /// Clap does not ask for `--scene` where something else, as `--pellet`, excludes it.
    pub(crate) fn refuse_without_scene(&self) -> Result<(), Failure> {
        let given = [
            ("--vary", self.vary.is_some()),
            ("--range", self.range.is_some()),
            ("--threads", self.threads.is_some()),
            ("--set", !self.set.is_empty()),
        ];
        match given.iter().find(|(_, is_given)| *is_given) {
            Some((name, _)) => Err(bad_input(format!(
                "{name} is of a scene; give --scene SCENE in place of a pellet and a surface"
            ))),
            None => Ok(()),
        }
    }
}

/// A scene in place of a lone pellet and a surface.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct SceneArguments {
    /// Scene to run, in place of a lone pellet and a surface.
    #[arg(
        long,
        help_heading = SCENE,
        value_name = "SCENE",
        requires = "range",
        conflicts_with_all = [
            "pellet", "diameter", "shear_modulus", "youngs_modulus", "poisson", "density", "onto_shear_modulus",
            "onto_poisson", "shear_modulus_range", "arrival_speed",
        ]
    )]
    pub(crate) scene: Option<PathBuf>,
    /// Key of the scene that is varied [default: how fast pellets come in, where there is one way in].
    #[arg(long, help_heading = SCENE, value_name = "KEY", requires = "scene")]
    pub(crate) vary: Option<String>,
    /// Values between which is sought, such as 2..15m/s; SI units where none is given.
    #[arg(long, help_heading = SCENE, value_name = "LOW..HIGH", requires = "scene", value_parser = value_range, allow_hyphen_values = true)]
    pub(crate) range: Option<ValueRange>,
    /// Width of the last bracket over that of the range.
    #[arg(long, help_heading = SCENE, value_name = "SHARE", requires = "scene", value_parser = risk, default_value = "1%")]
    pub(crate) tolerance: f64,
    /// Number of seeds run at the value found.
    #[arg(long, help_heading = SCENE, value_name = "N", requires = "scene", value_parser = clap::value_parser!(u32).range(1..=100), default_value_t = 3)]
    pub(crate) seeds: u32,
    /// Number of threads of each run [default: all there are].
    #[arg(long, help_heading = SCENE, value_name = "N", requires = "scene", value_parser = thread_count)]
    pub(crate) threads: Option<usize>,
    /// Set a value of the scene; can be given more than once.
    #[arg(long, help_heading = SCENE, value_name = "KEY=VALUE", requires = "scene")]
    pub(crate) set: Vec<Override>,
}

/// A distribution of the crushing load, by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DistributionName {
    /// The logarithm is normal.
    LogNormal,
    /// Weibull's weakest link.
    Weibull,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  pelletflow materials
  pelletflow materials --json | jq '.[].name'")]
pub(crate) struct MaterialsArguments {
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}
