//! `mesh = { file = "chute.stl" }` of a wall.

use super::shape::{LARGEST_FACTOR, RotateSpec};
use crate::quantity::{Coordinate, Size};
use schemars::JsonSchema;
use serde::Deserialize;

/// Triangles from a file of CAD: thin sheets, touched from both sides.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeshSpec {
    /// STL or OBJ file; its path is seen from the folder of the scene.
    pub(crate) file: String,
    /// Unit of the numbers in the file; m where none is given.
    pub(crate) unit: Option<MeshUnitSpec>,
    /// Factor of all lengths, beside the unit [-].
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = LARGEST_FACTOR))]
    pub(crate) scale: Option<f64>,
    /// A turn about an axis.
    pub(crate) rotate: Option<RotateSpec>,
    /// A move, after the turn [m].
    pub(crate) translate: Option<[Coordinate; 3]>,
    /// Whether corners are welded, and triangles without area and those that are there twice dropped; true where nothing is said.
    pub(crate) repair: Option<bool>,
    /// Distance up to which corners are one [m]; a millionth of the size of the mesh where none is given.
    pub(crate) weld: Option<Size>,
    /// Length of the cells of a grid of distances that stands in for the triangles, baked once at the start [m]; the mesh must
    /// be closed, and a pellet touches it at the nearest point only. The triangles themselves where none is given.
    pub(crate) bake: Option<Size>,
}

/// A unit of length in a file of CAD.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum MeshUnitSpec {
    /// Meters.
    M,
    /// Centimeters.
    Cm,
    /// Millimeters.
    Mm,
    /// Inches.
    In,
    /// Feet.
    Ft,
}

impl MeshUnitSpec {
    /// Its name, and its length [m].
    pub(crate) fn of(unit: Option<Self>) -> (&'static str, f64) {
        match unit.unwrap_or(Self::M) {
            Self::M => ("m", 1.0),
            Self::Cm => ("cm", 1.0e-2),
            Self::Mm => ("mm", 1.0e-3),
            Self::In => ("in", 0.0254),
            Self::Ft => ("ft", 0.3048),
        }
    }
}
