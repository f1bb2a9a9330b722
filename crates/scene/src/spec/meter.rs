//! `[meters.NAME]`.

use crate::quantity::{Coordinate, Size, SpeedBound, WearCoefficient};
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
    /// Mass and pellets that pass a plane or a disc of it, by direction.
    PlaneFlow {
        /// A point of the plane; the center of the disc [m].
        point: [Coordinate; 3],
        /// Direction that counts as forward, of any length [-].
        normal: [f64; 3],
        /// Radius of the disc [m]; the whole plane where none is given.
        radius: Option<Size>,
    },
    /// Force and torque of all pellets on one wall.
    WallForce {
        /// Name of the wall.
        wall: String,
        /// Point that the torque is about, which stays where the wall moves [m]; the center of the wall's box at the start
        /// where none is given, and the origin where the wall has no end.
        about: Option<[Coordinate; 3]>,
    },
    /// Impacts on one wall and their energy, patch by patch.
    WallImpacts {
        /// Name of the wall.
        wall: String,
        /// Width of the patches [m].
        cell: Size,
        /// Speed of approach up to which a touch is no impact [m/s]; 0.1 m/s where none is given.
        least_speed: Option<SpeedBound>,
    },
    /// Wear of one wall by impacts and by sliding, patch by patch.
    Wear {
        /// Name of the wall.
        wall: String,
        /// Width of the patches [m].
        cell: Size,
        /// Archard's coefficient over the hardness [1/Pa]; sliding does not wear where none is given.
        archard: Option<WearCoefficient>,
        /// Finnie's constant [1/Pa]; impacts do not wear where none is given.
        finnie: Option<WearCoefficient>,
        /// Speed of approach up to which a touch is no impact [m/s]; 0.1 m/s where none is given.
        least_speed: Option<SpeedBound>,
    },
    /// Density, velocity and agitation of the pellets whose centers are in a box.
    Box {
        /// Lowest corner [m].
        min: [Coordinate; 3],
        /// Highest corner [m].
        max: [Coordinate; 3],
    },
    /// How long pellets stay, from when they came to when they left through an outlet.
    Residence,
    /// Angle of repose of a heap.
    Heap {
        /// Where the axis of the heap meets the ground [m].
        point: [Coordinate; 3],
        /// Direction of the axis, out of the ground, of any length [-]; z where none is given.
        up: Option<[f64; 3]>,
    },
}
