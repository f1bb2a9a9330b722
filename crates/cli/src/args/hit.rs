//! Arguments that tell a pellet and the surface that it hits.

use super::quantity::{density, length, modulus, plain};
use clap::Args;

const HEADING: &str = "Pellet and surface";

/// A pellet and the surface that it hits; each value overrides that of the named material.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct HitArguments {
    /// Pellet of the library, see `pelletflow materials`; the options below change it.
    #[arg(long, help_heading = HEADING, value_name = "NAME")]
    pub(crate) pellet: Option<String>,
    /// Diameter of the pellet, such as 15mm.
    #[arg(long, help_heading = HEADING, value_name = "LENGTH", value_parser = length)]
    pub(crate) diameter: Option<f64>,
    /// Shear modulus of the pellet, such as 60MPa.
    #[arg(long, help_heading = HEADING, value_name = "MODULUS", value_parser = modulus, conflicts_with = "youngs_modulus")]
    pub(crate) shear_modulus: Option<f64>,
    /// Young's modulus of the pellet, in place of its shear modulus.
    #[arg(long, help_heading = HEADING, value_name = "MODULUS", value_parser = modulus)]
    pub(crate) youngs_modulus: Option<f64>,
    /// Poisson's ratio of the pellet.
    #[arg(long, help_heading = HEADING, value_name = "RATIO", value_parser = plain, allow_negative_numbers = true)]
    pub(crate) poisson: Option<f64>,
    /// Density of the pellet itself, such as 3700 (kg/m3).
    #[arg(long, help_heading = HEADING, value_name = "DENSITY", value_parser = density, allow_negative_numbers = true)]
    pub(crate) density: Option<f64>,
    /// Material of the surface, of the library.
    #[arg(long, help_heading = HEADING, value_name = "NAME", default_value = "steel")]
    pub(crate) onto: String,
    /// Shear modulus of the surface, such as 81GPa.
    #[arg(long, help_heading = HEADING, value_name = "MODULUS", value_parser = modulus)]
    pub(crate) onto_shear_modulus: Option<f64>,
    /// Poisson's ratio of the surface.
    #[arg(long, help_heading = HEADING, value_name = "RATIO", value_parser = plain, allow_negative_numbers = true)]
    pub(crate) onto_poisson: Option<f64>,
}
