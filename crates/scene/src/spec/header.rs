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
    /// How bodies resist rolling over each other; `constant-torque` where none is given.
    pub(crate) rolling: Option<TurningSpec>,
    /// How bodies resist twisting on each other; `none` where none is given.
    pub(crate) twisting: Option<TurningSpec>,
    /// How neighbors are found; every way gives the same result.
    pub(crate) search: SearchSpec,
    /// Extra reach of a neighbor list [m]; it follows the motion seen where none is given.
    pub(crate) skin: Option<Size>,
}

/// How bodies push apart.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum NormalSpec {
    /// Hertz's force with damping from the restitution of the pair.
    #[default]
    Hertz,
    /// A spring of the pair's `stiffness` with damping from its restitution.
    Linear,
    /// Hertz's force up to the pair's `yield_pressure`, with its damping; plastic beyond.
    Plastic,
    /// Hertz's force with the pair's `surface_energy`: bodies stick.
    Jkr,
}

/// How bodies resist sliding.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum TangentialSpec {
    /// No friction.
    None,
    /// Coulomb's friction against any sliding, without memory; what it should hold creeps.
    Coulomb,
    /// Mindlin's spring with history, capped by Coulomb's friction.
    #[default]
    Mindlin,
    /// A row of springs across the contact, each let go by friction: the rim slides first.
    PartialSlip,
}

/// How bodies resist turning.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum TurningSpec {
    /// No resistance.
    None,
    /// A torque of constant size against the turning; what it should hold creeps.
    ConstantTorque,
    /// A damped spring that gives way at that torque.
    SpringDashpot,
}

/// How neighbors are found.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum SearchSpec {
    /// The grid for near-equal sizes, the hierarchical grid for wide ratios.
    #[default]
    Auto,
    /// A grid of cells.
    Grid,
    /// A grid of cells for each octave of sizes.
    HierarchicalGrid,
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
    /// Axes along which a pellet that leaves the box comes in again at the opposite side: `["x", "y"]`; none where none
    /// is given.
    #[serde(default)]
    pub(crate) periodic: Vec<AxisSpec>,
}

/// An axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum AxisSpec {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}
