//! `[fill.NAME]`, `[inlets.NAME]` and `[outlets.NAME]`.

use super::shape::ShapeSpec;
use crate::quantity::{Coordinate, FeedRate, Mass, Moment, TurnRate, Velocity};
use schemars::JsonSchema;
use serde::Deserialize;

/// Pellets there at the start: a `region` with a `count`, a `mass` or a level, or their centers `at`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FillSpec {
    /// Name of the kind of pellets.
    pub(crate) pellets: String,
    /// Where the pellets are put, without overlap and from the bottom up; each lies wholly inside.
    pub(crate) region: Option<ShapeSpec>,
    /// How many [-].
    #[schemars(extend("minimum" = 1))]
    pub(crate) count: Option<usize>,
    /// At least this mass, to the next whole pellet [kg].
    pub(crate) mass: Option<Mass>,
    /// Height against gravity, from the origin, up to which the settled bed fills the region [m]; the number of pellets
    /// follows from an estimate of how densely they pack.
    pub(crate) to_level: Option<Coordinate>,
    /// How the pellets are put into the region; `lattice` where all are of one size or nothing pulls them down, `deposit`
    /// else.
    pub(crate) packing: Option<PackingSpec>,
    /// Centers of the pellets, one by one [m]; in place of `region`.
    #[schemars(extend("minItems" = 1))]
    pub(crate) at: Option<Vec<[Coordinate; 3]>>,
    /// Velocity at the start [m/s]; at rest where none is given.
    pub(crate) velocity: Option<[Velocity; 3]>,
    /// Spin at the start [rad/s]; none where none is given.
    pub(crate) spin: Option<[TurnRate; 3]>,
}

/// How pellets are put into a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum PackingSpec {
    /// On a jittered lattice of the largest diameter.
    Lattice,
    /// One after another, each in a low place on those before: a bed that is nearly settled.
    Deposit,
}

/// A feeder: pellets appear at a rate, at random places of a region.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct InletSpec {
    /// Name of the kind of pellets.
    pub(crate) pellets: String,
    /// Where pellets appear; each lies wholly inside.
    pub(crate) region: ShapeSpec,
    /// How fast they come: "250 t/h" or "200 1/s"; a plain number is kg/s.
    pub(crate) rate: FeedRate,
    /// Velocity as they appear [m/s]; at rest where none is given.
    pub(crate) velocity: Option<[Velocity; 3]>,
    /// First moment of feeding [s]; 0 where none is given.
    pub(crate) start: Option<Moment>,
    /// Last moment of feeding [s]; never where none is given.
    pub(crate) end: Option<Moment>,
}

/// Where pellets leave: one whose center is inside is discharged.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct OutletSpec {
    /// The region.
    pub(crate) region: ShapeSpec,
}
