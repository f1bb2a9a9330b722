//! `[meters.NAME]`.

use schemars::JsonSchema;
use serde::Deserialize;

/// What is measured while the run goes on.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum MeterSpec {
    /// Mass discharged through one outlet, and its rate.
    MassFlow {
        /// Name of the outlet.
        outlet: String,
    },
    /// Force of all pellets on one wall.
    WallForce {
        /// Name of the wall.
        wall: String,
    },
}
