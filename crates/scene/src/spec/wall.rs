//! `[walls.NAME]`.

use super::mesh::MeshSpec;
use super::motion::MotionsSpec;
use super::shape::ShapeSpec;
use crate::quantity::{Moment, Velocity};
use schemars::JsonSchema;
use serde::Deserialize;

/// A piece of equipment.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WallSpec {
    /// Name of the material.
    pub(crate) material: String,
    /// Its solid; this or `mesh`.
    pub(crate) shape: Option<ShapeSpec>,
    /// Its triangles, from a file of CAD; this or `shape`.
    pub(crate) mesh: Option<MeshSpec>,
    /// How it moves, or a list of motions, the innermost first; it stays where nothing is said.
    #[serde(default)]
    pub(crate) motion: MotionsSpec,
    /// Velocity of its surface beside its motion, as of a belt; only the part along the surface acts [m/s].
    pub(crate) surface_velocity: Option<[Velocity; 3]>,
    /// Moment at which it vanishes, as a gate that opens [s].
    pub(crate) opens_at: Option<Moment>,
    /// Moment at which it appears, as a gate that closes [s].
    pub(crate) closes_at: Option<Moment>,
    /// More than one opening and closing; in place of `opens_at` and `closes_at`.
    pub(crate) schedule: Option<ScheduleSpec>,
}

/// The moments at which a gate opens and closes.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScheduleSpec {
    /// How it is at first.
    #[serde(default)]
    pub(crate) at_first: GateState,
    /// Moments at which it changes, rising [s].
    #[schemars(extend("minItems" = 1))]
    pub(crate) changes: Vec<Moment>,
}

/// Whether a gate is there.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum GateState {
    /// It is there.
    #[default]
    Closed,
    /// It is not there.
    Open,
}
