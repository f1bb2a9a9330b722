//! `motion` of a wall.

use crate::quantity::{Coordinate, Frequency, Moment, TurnRate, Velocity};
use schemars::JsonSchema;
use serde::Deserialize;

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
    },
}
