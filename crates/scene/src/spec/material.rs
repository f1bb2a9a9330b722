//! `[materials.NAME]`, `[pairs."A-B"]`, `[pellets.NAME]` and `[strength]`.

use crate::quantity::{Density, Force, Modulus, Portion, Size, Stiffness, SurfaceEnergy};
use schemars::JsonSchema;
use serde::Deserialize;

/// An isotropic elastic material; give one of the two moduli.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MaterialSpec {
    /// Mass per volume of the body itself, not of its bulk [kg/m³].
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub(crate) density: Density,
    /// Young's modulus [Pa].
    pub(crate) youngs_modulus: Option<Modulus>,
    /// Shear modulus [Pa].
    pub(crate) shear_modulus: Option<Modulus>,
    /// Young's modulus of the real body, where the one above is softened to spare steps [Pa]; hits are then told at
    /// both.
    pub(crate) true_youngs_modulus: Option<Modulus>,
    /// Poisson's ratio [-].
    #[schemars(extend("exclusiveMinimum" = -1.0, "exclusiveMaximum" = 0.5))]
    pub(crate) poisson_ratio: f64,
}

/// What is measured on two materials together.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PairSpec {
    /// Rebound speed over approach speed of a normal impact [-].
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1.0))]
    pub(crate) restitution: f64,
    /// Coulomb's coefficient of sliding friction [-].
    #[schemars(extend("minimum" = 0.0, "maximum" = 10.0))]
    pub(crate) friction: f64,
    /// Coefficient of rolling friction [-].
    #[serde(default)]
    #[schemars(extend("minimum" = 0.0, "maximum" = 10.0))]
    pub(crate) rolling_friction: f64,
    /// Damping of rolling and twisting by the law `spring-dashpot`, over critical damping [-]; 0.3 where none is given.
    #[schemars(extend("minimum" = 0.0, "maximum" = 10.0))]
    pub(crate) rolling_damping: Option<f64>,
    /// Stiffness by the normal law `linear` [N/m].
    pub(crate) stiffness: Option<Stiffness>,
    /// Pressure in the middle of the contact at which the softer body yields, by the normal law `plastic` [Pa].
    pub(crate) yield_pressure: Option<Modulus>,
    /// Work that parting takes per area of contact, by the normal law `jkr` [J/m²].
    pub(crate) surface_energy: Option<SurfaceEnergy>,
}

/// Pellets of one material and one distribution of sizes.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PelletSpec {
    /// Name of the material.
    pub(crate) material: String,
    /// Diameter of all [m], or a table of a distribution.
    pub(crate) diameter: DiameterSpec,
}

/// Diameter of all [m], or a table of a distribution.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum DiameterSpec {
    /// All alike [m].
    Single(Size),
    /// Of a distribution.
    Distributed(DistributionSpec),
}

/// A distribution of diameters: `min` and `max` alone, any between as likely by number; with `mean` and `deviation`
/// normal; with `median` and `spread` log-normal; or `openings` and `passing` of a screen analysis.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct DistributionSpec {
    /// Smallest diameter [m]; three deviations below the middle where none is given.
    pub(crate) min: Option<Size>,
    /// Largest diameter [m]; three deviations above the middle where none is given.
    pub(crate) max: Option<Size>,
    /// Mean of a normal distribution, by number [m].
    pub(crate) mean: Option<Size>,
    /// Standard deviation of a normal distribution [m].
    pub(crate) deviation: Option<Size>,
    /// Median of a log-normal distribution, by number [m].
    pub(crate) median: Option<Size>,
    /// Standard deviation of the logarithm of a log-normal distribution [-].
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 2.0))]
    pub(crate) spread: Option<f64>,
    /// Openings of the sieves of a screen analysis, rising [m].
    pub(crate) openings: Option<Vec<Size>>,
    /// Mass that passes each of them over the whole, rising from 0 to 1 [-].
    pub(crate) passing: Option<Vec<Portion>>,
}

/// What a pellet withstands.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StrengthSpec {
    /// Normal force at which half of the pellets break [N].
    pub(crate) load: Force,
}
