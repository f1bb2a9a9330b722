//! Arguments of `pelletflow accuracy`.

use super::quantity::risk;
use super::thread_count;
use clap::{Args, ValueEnum};
use pelletflow_scene::Override;
use pelletflow_sim::Integrator;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "\
Errors are held against values that the scene states as exact, and otherwise against the finest run:
  [expect]
  \"contacts.max_force_n\" = { value = 264.796, relative = \"0.1 %\", exact = true }
Where a nudge of gravity by a billionth grows a thousandfold, the flow is chaotic: then every case is run with several
seeds, and errors are those of the means, with 95 % confidence intervals.

Examples:
  pelletflow accuracy drop.toml --plot accuracy.svg
  pelletflow accuracy drop.toml --steps-per-contact 10,20,40,80 --error 0.01%
  pelletflow accuracy hopper.toml --set time.end=\"0.5 s\" --repeats 3 --integrator located-verlet")]
pub(crate) struct AccuracyArguments {
    /// Scene file; it is run to its end time.
    pub(crate) scene: PathBuf,
    /// Set a value of the scene; can be given more than once.
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<Override>,
    /// Integrator to compare; can be given more than once [default: all].
    #[arg(long, value_name = "NAME", value_enum)]
    pub(crate) integrator: Vec<IntegratorName>,
    /// Steps per contact of the fastest hit expected, 10 or more each.
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = step_count, default_value = "10,12.3,16,20,28,40,56,80")]
    pub(crate) steps_per_contact: Vec<f64>,
    /// Error that the recommended step is to keep, such as 0.1%.
    #[arg(long, value_name = "SHARE", value_parser = risk, default_value = "0.1%")]
    pub(crate) error: f64,
    /// Runs per case where the flow is chaotic.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1000), default_value_t = 4)]
    pub(crate) repeats: u32,
    /// Number of threads of each run.
    #[arg(long, value_name = "N", value_parser = thread_count, default_value_t = 1)]
    pub(crate) threads: usize,
    /// Draw run time against error as SVG.
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Names of the integrators.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum IntegratorName {
    /// Kick, then drift.
    SemiImplicitEuler,
    /// Velocity Verlet.
    VelocityVerlet,
    /// Velocity Verlet with first touch and release located within the step.
    LocatedVerlet,
}

impl IntegratorName {
    pub(crate) fn integrator(self) -> Integrator {
        match self {
            Self::SemiImplicitEuler => Integrator::SemiImplicitEuler,
            Self::VelocityVerlet => Integrator::VelocityVerlet,
            Self::LocatedVerlet => Integrator::LocatedVerlet,
        }
    }
}

fn step_count(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(steps) if (10.0..=1.0e4).contains(&steps) => Ok(steps),
        _ => Err("expected 10 to 10000 steps per contact".into()),
    }
}
