//! `motion` of a wall.

use crate::quantity::{Angle, Coordinate, Frequency, Moment, TurnRate, Velocity};
use schemars::JsonSchema;
use serde::Deserialize;

/// One way to move, or a list of ways, each in the frame that the next carries along: a screw turns on a frame that
/// shakes.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum MotionsSpec {
    /// One way.
    One(MotionSpec),
    /// Several ways, the innermost first.
    Several(Vec<MotionSpec>),
}

impl Default for MotionsSpec {
    fn default() -> Self {
        Self::One(MotionSpec::default())
    }
}

/// How a wall moves.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum MotionSpec {
    /// It stays.
    #[default]
    Fixed,
    /// It moves evenly between two moments.
    Translating {
        /// Velocity [m/s].
        velocity: [Velocity; 3],
        /// First moment [s]; 0 where none is given.
        start: Option<Moment>,
        /// Last moment [s]; never where none is given.
        end: Option<Moment>,
    },
    /// It turns evenly about an axis between two moments.
    Rotating {
        /// A point of the axis [m].
        center: [Coordinate; 3],
        /// Direction of the axis, of any length [-].
        axis: [f64; 3],
        /// Turn per time, right-handed about the axis [rad/s].
        rate: TurnRate,
        /// First moment [s]; 0 where none is given.
        start: Option<Moment>,
        /// Last moment [s]; never where none is given.
        end: Option<Moment>,
    },
    /// It swings to and fro, starting from rest position.
    Vibrating {
        /// Greatest displacement, and the way it goes first [m].
        amplitude: [Coordinate; 3],
        /// Swings per time [Hz].
        frequency: Frequency,
        /// How it turns to and fro in time with that; it does not where nothing is said.
        swing: Option<SwingSpec>,
    },
    /// It follows a table of moments, and waits at the first row before and at the last row after.
    Table {
        /// Moments of the rows, rising [s].
        #[schemars(extend("minItems" = 2))]
        moments: Vec<Moment>,
        /// Displacement from the rest position at each moment [m]; none where none are given.
        displacements: Option<Vec<[Coordinate; 3]>>,
        /// Turn about the axis at each moment, right-handed [rad]; none where none are given.
        angles: Option<Vec<Angle>>,
        /// A point of the axis, before the displacement [m]; the origin where none is given.
        center: Option<[Coordinate; 3]>,
        /// Direction of the axis, of any length [-]; z where none is given.
        axis: Option<[f64; 3]>,
        /// How it goes from one row to the next; `linear` where nothing is said.
        #[serde(default)]
        interpolation: InterpolationSpec,
    },
}

/// A turn to and fro, in time with a vibration.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SwingSpec {
    /// A point of the axis, before the displacement [m].
    pub(crate) center: [Coordinate; 3],
    /// Direction of the axis, of any length [-].
    pub(crate) axis: [f64; 3],
    /// Greatest turn, and the way it goes first, right-handed about the axis [rad].
    pub(crate) angle: Angle,
}

/// How a motion goes from one row of its table to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum InterpolationSpec {
    /// Evenly; the velocity jumps at each row.
    #[default]
    Linear,
    /// By cubics whose velocity is continuous, without overshoot, and zero at both ends.
    Smooth,
}
