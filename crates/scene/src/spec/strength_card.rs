//! A strength card: what a crushing test found, and what other tests of the same pellets did.

use crate::quantity::{Force, Modulus, Portion, Share, Size, SpecificEnergy, Speed};
use schemars::JsonSchema;
use serde::Deserialize;

/// What a crushing test found.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StrengthCardSpec {
    /// Name of the pellets.
    pub(crate) name: String,
    /// Where the numbers come from.
    pub(crate) source: String,
    /// How the load scatters.
    pub(crate) distribution: DistributionSpec,
    /// Mean load; the load itself where it is fixed [N].
    pub(crate) mean: Option<Force>,
    /// Standard deviation of the load over its mean [-].
    pub(crate) coefficient_of_variation: Option<Share>,
    /// Load that half break under, for the log-normal distribution [N].
    pub(crate) median: Option<Force>,
    /// Standard deviation of the logarithm of the load, for the log-normal distribution [-].
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub(crate) deviation: Option<f64>,
    /// Load that 63 % break under, for Weibull's distribution [N].
    pub(crate) scale: Option<Force>,
    /// Weibull modulus [-].
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub(crate) modulus: Option<f64>,
    /// Diameter of the tested pellets [m]; left out, the load is that of any size.
    pub(crate) test_diameter: Option<Size>,
    /// Number of tested pellets [-].
    #[schemars(extend("minimum" = 2))]
    pub(crate) sample_size: Option<u32>,
    /// Pressure in the middle of a contact that the pellet yields under [Pa]; left out, it stays elastic up to breakage.
    pub(crate) yield_pressure: Option<Modulus>,
    /// How the numbers were found.
    pub(crate) provenance: Option<ProvenanceSpec>,
    /// What breaks in a blow.
    pub(crate) fracture_energy: Option<FractureEnergySpec>,
    /// What a drop test found.
    #[serde(default)]
    pub(crate) drops: Vec<DropSpec>,
    /// What a tumble test found.
    pub(crate) tumble: Option<TumbleSpec>,
}

/// How a load scatters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum DistributionSpec {
    /// It does not.
    Fixed,
    /// Weibull's distribution.
    Weibull,
    /// The logarithm is normal.
    LogNormal,
}

/// How the numbers of a card were found; for people, and for the record.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProvenanceSpec {
    /// File of the sheet.
    pub(crate) file: Option<String>,
    /// Date of the sheet, as it stands there.
    pub(crate) date: Option<String>,
    /// The test.
    pub(crate) method: Option<String>,
    /// How the distribution was fitted.
    pub(crate) fit: Option<String>,
    /// Interval of the scale or of the median [N].
    pub(crate) center_interval: Option<[Force; 2]>,
    /// Interval of the modulus or of the deviation [-].
    pub(crate) shape_interval: Option<[f64; 2]>,
    /// Distance of Anderson and Darling [-].
    pub(crate) distance: Option<f64>,
    /// p value of the distance [-].
    pub(crate) p_value: Option<f64>,
}

/// The energy that breaks a pellet in a blow, per mass.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FractureEnergySpec {
    /// Median for pellets of any size [J/kg].
    pub(crate) median: Option<SpecificEnergy>,
    /// Median for large pellets on a rigid surface [J/kg].
    pub(crate) large: Option<SpecificEnergy>,
    /// Stiffness of the pellet over that of the surface [-].
    #[schemars(extend("minimum" = 0.0))]
    pub(crate) stiffness_ratio: Option<f64>,
    /// Diameter below which size matters [m].
    pub(crate) characteristic_diameter: Option<Size>,
    /// Exponent of the size [-].
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub(crate) exponent: Option<f64>,
    /// Standard deviation of the logarithm of the energy [-].
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub(crate) deviation: f64,
    /// Greatest fracture energy over the median [-].
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub(crate) truncation: Option<f64>,
    /// Damage constant [-]; left out, weak blows leave no trace.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub(crate) damage_constant: Option<f64>,
    /// Number of tested pellets [-].
    #[schemars(extend("minimum" = 2))]
    pub(crate) sample_size: Option<u32>,
}

/// Pellets dropped once each at one speed.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DropSpec {
    /// Speed at which they hit [m/s].
    pub(crate) speed: Speed,
    /// Number of pellets dropped [-].
    #[schemars(extend("minimum" = 1))]
    pub(crate) dropped: u32,
    /// Number of them that broke [-].
    pub(crate) broken: u32,
}

/// What a tumble test found (ISO 3271); it enters no breakage.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TumbleSpec {
    /// Share of the mass that stays on the sieve of 6.3 mm [-].
    pub(crate) tumble_index: Portion,
    /// Share of the mass that passes the sieve of 0.5 mm [-].
    pub(crate) abrasion_index: Option<Portion>,
}
