//! `[scene]`, `[contact]` and `[domain]`.

use crate::quantity::{Acceleration, Coordinate, Size};
use schemars::JsonSchema;
use serde::Deserialize;

/// What the scene is about.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct HeaderSpec {
    /// Title, for reports and recordings; the file's name where there is none.
    pub(crate) title: String,
    /// What is to be seen in it, in a sentence or two.
    pub(crate) description: String,
    /// Seed of every random draw.
    pub(crate) seed: u64,
    /// Acceleration of gravity [m/s²].
    pub(crate) gravity: [Acceleration; 3],
}

/// Standard gravity, rounded as engineers do [m/s²].
const GRAVITY: f64 = 9.81;

impl Default for HeaderSpec {
    fn default() -> Self {
        Self {
            title: String::new(),
            description: String::new(),
            seed: 1,
            gravity: [Acceleration(0.0), Acceleration(0.0), Acceleration(-GRAVITY)],
        }
    }
}

/// Contact laws and neighbor search.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct ContactSpec {
    /// How bodies push apart.
    pub(crate) normal: NormalSpec,
    /// How bodies resist sliding.
    pub(crate) tangential: TangentialSpec,
    /// How bodies resist rolling.
    pub(crate) rolling: RollingSpec,
    /// How neighbors are found; every way gives the same result.
    pub(crate) search: SearchSpec,
    /// Extra reach of a neighbor list [m]; chosen from the pellets where none is given.
    pub(crate) skin: Option<Size>,
}

/// How bodies push apart.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum NormalSpec {
    /// Hertz's force with damping from the restitution of the pair.
    #[default]
    Hertz,
}

/// How bodies resist sliding.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum TangentialSpec {
    /// No friction.
    None,
    /// Mindlin's spring with history, capped by Coulomb's friction.
    #[default]
    Mindlin,
}

/// How bodies resist rolling.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum RollingSpec {
    /// No resistance.
    None,
    /// A torque of constant size against the rolling.
    #[default]
    ConstantTorque,
}

/// How neighbors are found.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum SearchSpec {
    /// The grid for near-equal sizes, the tree for wide ratios.
    #[default]
    Auto,
    /// A grid of cells.
    Grid,
    /// A tree of boxes.
    Tree,
    /// Every pair; slow, to compare with.
    AllPairs,
}

/// The box in which pellets may be; one that leaves it elsewhere than by an outlet is lost.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DomainSpec {
    /// Lowest corner [m].
    pub(crate) min: [Coordinate; 3],
    /// Highest corner [m].
    pub(crate) max: [Coordinate; 3],
}
