//! A strength card: what a crushing test found.

use crate::quantity::{Force, Share, Size};
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
