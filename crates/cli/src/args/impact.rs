//! Arguments of `pelletflow impact`.

use super::hit::HitArguments;
use super::quantity::{Speeds, angle, friction, restitution, speeds, time};
use clap::{Args, ValueEnum};
use pelletflow_impact::Slip;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  pelletflow impact --diameter 15mm --shear-modulus 60MPa --poisson 0.22 --density 3700 --onto steel --speed 1..8
  pelletflow impact --pellet fired-pellet --speed 5 --restitution 0.5 --plot force.svg
  pelletflow impact --pellet papers-pellet --speed 2,4 --angle 45deg --friction 0.4 --plot spin.svg --show spin
  pelletflow impact --pellet papers-pellet --speed 1..8:0.5 --json | jq '.[].peak_force_n'

Figures of the paper, each by one command; the other options change them:
  pelletflow impact --figure 2 --plot figure-2.svg
  2  force over time at 1 to 8 m/s             6  force over time for shear moduli of 10 to 150 MPa
  3  the same on a slope of 45 degrees         7  force over time for diameters of 3 to 25 mm
  4  horizontal speed over time on the slope   8  peak force over speed, on the flat and on the slope
  5  spin over time on the slope               9  the bell curve for three sets of its parameters")]
pub(crate) struct ImpactArguments {
    #[command(flatten)]
    pub(crate) hit: HitArguments,
    /// Speed of arrival: one, a list or a range, such as 5, 1,2.5,8 or 1..8:0.5 (m/s).
    #[arg(long, value_name = "SPEED", value_parser = speeds, required_unless_present = "figure")]
    pub(crate) speed: Option<Speeds>,
    /// Angle between the path and the normal of the surface, such as 45deg: the slope that a falling pellet lands on.
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_negative_numbers = true)]
    pub(crate) angle: Option<f64>,
    /// Rebound speed over approach speed along the normal; elastic where it is left out.
    #[arg(long, value_name = "E", value_parser = restitution, allow_negative_numbers = true)]
    pub(crate) restitution: Option<f64>,
    /// Viscoelastic in place of a restitution: the relaxation time, such as 5us.
    #[arg(long, value_name = "TIME", value_parser = time, conflicts_with = "restitution")]
    pub(crate) relaxation_time: Option<f64>,
    /// Coefficient of sliding friction, for a hit at an angle [default: the surface's in the library].
    #[arg(long, value_name = "MU", value_parser = friction, allow_negative_numbers = true)]
    pub(crate) friction: Option<f64>,
    /// How the surfaces resist sliding.
    #[arg(long, value_name = "LAW", value_enum, default_value_t = SlipName::Partial)]
    pub(crate) slip: SlipName,
    /// Draw a figure of the paper, from its pellet on steel.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(2..=9))]
    pub(crate) figure: Option<u8>,
    /// Write a plot as SVG.
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
    /// What the plot shows [default: the force over time].
    #[arg(
        long,
        value_name = "WHAT",
        value_enum,
        requires = "plot",
        conflicts_with = "figure"
    )]
    pub(crate) show: Option<View>,
    /// Write the hits over time as CSV.
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// A law of sliding, by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SlipName {
    /// Friction at once, as in the paper.
    Coulomb,
    /// One spring, as in flows.
    Mindlin,
    /// Partial slip, the exact solution.
    Partial,
}

impl From<SlipName> for Slip {
    fn from(name: SlipName) -> Self {
        match name {
            SlipName::Coulomb => Self::Coulomb,
            SlipName::Mindlin => Self::Mindlin,
            SlipName::Partial => Self::Partial,
        }
    }
}

/// What a plot shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum View {
    /// Force over time.
    Force,
    /// Force over the time of the hit, both as shares, with the fitted curves.
    Shape,
    /// Speed along the surface over time.
    TangentialSpeed,
    /// Horizontal speed of a pellet that fell straight down, over time.
    HorizontalSpeed,
    /// Spin over time.
    Spin,
    /// Peak force over speed.
    PeakForce,
}

impl View {
    /// Whether only a hit at an angle has something to show.
    pub(crate) fn is_of_sliding(self) -> bool {
        matches!(
            self,
            Self::TangentialSpeed | Self::HorizontalSpeed | Self::Spin
        )
    }
}
