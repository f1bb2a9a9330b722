//! What a scene may hold: one file per table. The doc comments are what an editor shows.

pub(crate) mod expect;
pub(crate) mod feed;
pub(crate) mod header;
pub(crate) mod material;
pub(crate) mod mesh;
pub(crate) mod meter;
pub(crate) mod motion;
pub(crate) mod run;
pub(crate) mod shape;
pub(crate) mod strength_card;
pub(crate) mod wall;

use crate::named::Named;
use schemars::JsonSchema;
use serde::Deserialize;

/// A scene of pelletflow: pellets, equipment, and what is to be computed.
///
/// Plain numbers are SI; texts with units are accepted: "15 mm", "250 t/h", "30 deg".
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "pelletflow scene")]
pub(crate) struct SceneSpec {
    /// Version of this format; 1.
    #[schemars(extend("const" = 1))]
    pub(crate) schema_version: u32,
    /// What the scene is about, its seed and its gravity.
    #[serde(default)]
    pub(crate) scene: header::HeaderSpec,
    /// Materials by name.
    #[serde(default)]
    pub(crate) materials: Named<material::MaterialSpec>,
    /// What two materials do together, by both names: `[pairs."pellet-steel"]`.
    #[serde(default)]
    pub(crate) pairs: Named<material::PairSpec>,
    /// Kinds of pellets by name.
    #[serde(default)]
    pub(crate) pellets: Named<material::PelletSpec>,
    /// Contact laws and neighbor search.
    #[serde(default)]
    pub(crate) contact: header::ContactSpec,
    /// Equipment by name.
    #[serde(default)]
    pub(crate) walls: Named<wall::WallSpec>,
    /// Pellets there at the start, by name.
    #[serde(default)]
    pub(crate) fill: Named<feed::FillSpec>,
    /// Feeders by name.
    #[serde(default)]
    pub(crate) inlets: Named<feed::InletSpec>,
    /// Regions where pellets leave, by name.
    #[serde(default)]
    pub(crate) outlets: Named<feed::OutletSpec>,
    /// What is measured, by name.
    #[serde(default)]
    pub(crate) meters: Named<meter::MeterSpec>,
    /// The box in which pellets may be; chosen from the scene where none is given.
    pub(crate) domain: Option<header::DomainSpec>,
    /// How long and in what steps.
    pub(crate) time: run::TimeSpec,
    /// What ends the run before its time.
    #[serde(default)]
    pub(crate) stop: run::StopSpec,
    /// What is recorded and how often.
    #[serde(default)]
    pub(crate) output: run::OutputSpec,
    /// When the run counts as failed.
    #[serde(default)]
    pub(crate) limits: run::LimitsSpec,
    /// Work that may be left out because it changes nothing.
    #[serde(default)]
    pub(crate) skip: run::SkipSpec,
    /// What a pellet withstands.
    pub(crate) strength: Option<material::StrengthSpec>,
    /// What a right run shows, by dotted key of its summary: `"mass.lost" = 0`.
    #[serde(default)]
    pub(crate) expect: expect::ExpectSpec,
}
