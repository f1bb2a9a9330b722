//! Shapes as an engineer writes them.

use crate::quantity::{Angle, Coordinate, Size};
use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde_json::Value;

/// Largest factor of a scaling [-]; beyond it a unit was mistaken.
pub(super) const LARGEST_FACTOR: f64 = 1.0e6;

/// A solid: its kind, and how it is turned and then moved.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[schemars(transform = spread_over_kinds)]
pub(crate) struct ShapeSpec {
    /// The solid before it is placed.
    #[serde(flatten)]
    pub(crate) solid: SolidSpec,
    /// A turn about an axis.
    pub(crate) rotate: Option<RotateSpec>,
    /// A move, after the turn [m].
    pub(crate) translate: Option<[Coordinate; 3]>,
}

/// A solid of one kind.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub(crate) enum SolidSpec {
    /// Everything on the far side of a plane.
    HalfSpace {
        /// A point of the plane [m].
        point: [Coordinate; 3],
        /// Direction out of the solid, of any length [-].
        normal: [f64; 3],
    },
    /// A ball.
    Sphere {
        /// Center [m].
        center: [Coordinate; 3],
        /// Radius [m].
        radius: Size,
    },
    /// A solid cylinder.
    Cylinder {
        /// Center of the lower end [m].
        base: [Coordinate; 3],
        /// Direction from the lower end to the upper, of any length [-]; z where none is given.
        axis: Option<[f64; 3]>,
        /// Radius [m].
        radius: Size,
        /// Length along the axis [m].
        height: Size,
    },
    /// A solid frustum.
    Cone {
        /// Center of the lower end [m].
        base: [Coordinate; 3],
        /// Direction from the lower end to the upper, of any length [-]; z where none is given.
        axis: Option<[f64; 3]>,
        /// Radius of the lower end [m].
        #[schemars(extend("minimum" = 0.0))]
        lower_radius: Coordinate,
        /// Radius of the upper end [m].
        #[schemars(extend("minimum" = 0.0))]
        upper_radius: Coordinate,
        /// Length along the axis [m].
        height: Size,
    },
    /// A ring, round in its cross-section.
    Torus {
        /// Center [m].
        center: [Coordinate; 3],
        /// Direction of the axis of the ring, of any length [-]; z where none is given.
        axis: Option<[f64; 3]>,
        /// Radius of the circle along the middle of the tube [m].
        ring_radius: Size,
        /// Radius of the tube, less than that of the ring [m].
        tube_radius: Size,
    },
    /// A solid cylinder with balls for ends.
    Capsule {
        /// Center of the lower ball [m].
        base: [Coordinate; 3],
        /// Direction from the lower ball to the upper, of any length [-]; z where none is given.
        axis: Option<[f64; 3]>,
        /// Radius of the cylinder and of the balls [m].
        radius: Size,
        /// Length along the axis between the centers of the balls [m].
        height: Size,
    },
    /// A ball stretched along the axes.
    Ellipsoid {
        /// Center [m].
        center: [Coordinate; 3],
        /// Half of each axis, along x, y and z [m].
        half_axes: [Size; 3],
    },
    /// A box along the axes; give `min` and `max`, or `center` and `size`.
    Box {
        /// Lowest corner [m].
        min: Option<[Coordinate; 3]>,
        /// Highest corner [m].
        max: Option<[Coordinate; 3]>,
        /// Center [m].
        center: Option<[Coordinate; 3]>,
        /// Sides along x, y and z [m].
        size: Option<[Size; 3]>,
    },
    /// A sheet that falls off toward +x by an angle, as the floor of a chute.
    Plate {
        /// Middle of the upper face [m].
        center: [Coordinate; 3],
        /// Length, width and thickness: along x, y and z before it is inclined [m].
        size: [Size; 3],
        /// Angle by which it falls off toward +x [rad]; level where none is given.
        incline: Option<Angle>,
        /// Turn about z after that, counterclockwise from above [rad].
        heading: Option<Angle>,
    },
    /// A profile turned about the z axis.
    Revolution {
        /// Corners [radius, z] [m]: a closed polygon, or with `thickness` the middle line of a plate.
        #[schemars(extend("minItems" = 2))]
        profile: Vec<[Coordinate; 2]>,
        /// Thickness of the plate [m].
        thickness: Option<Size>,
        /// Where the origin of the profile is put [m].
        base: Option<[Coordinate; 3]>,
    },
    /// All of several shapes together.
    Union {
        /// The parts.
        #[schemars(extend("minItems" = 1))]
        of: Vec<ShapeSpec>,
    },
    /// What several shapes have in common.
    Intersection {
        /// The parts.
        #[schemars(extend("minItems" = 1))]
        of: Vec<ShapeSpec>,
    },
    /// One shape with another cut away.
    Difference {
        /// What is cut.
        of: Box<ShapeSpec>,
        /// What is taken away.
        minus: Box<ShapeSpec>,
    },
    /// All of several shapes together, with a fillet in the corners where they meet.
    Blend {
        /// The parts.
        #[schemars(extend("minItems" = 1))]
        of: Vec<ShapeSpec>,
        /// Radius of the fillets [m].
        radius: Size,
    },
    /// A shape seen in a plane mirror.
    Mirror {
        /// What is mirrored.
        of: Box<ShapeSpec>,
        /// A point of the plane [m].
        point: [Coordinate; 3],
        /// Direction across the plane, of any length [-].
        normal: [f64; 3],
    },
    /// A shape made larger or smaller, alike in all directions.
    Scale {
        /// What is scaled.
        of: Box<ShapeSpec>,
        /// The factor of all lengths [-].
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = LARGEST_FACTOR))]
        factor: f64,
        /// The point that stays where it is [m]; the origin where none is given.
        about: Option<[Coordinate; 3]>,
    },
    /// A shape hollowed out, closed on all sides; its outer face stays where it is.
    Shell {
        /// What is hollowed out.
        of: Box<ShapeSpec>,
        /// Thickness of the wall that is left, less than half of the smallest side of the shape [m].
        thickness: Size,
    },
    /// A shape grown outward; its edges become round.
    Offset {
        /// What is grown.
        of: Box<ShapeSpec>,
        /// By how much [m].
        by: Size,
    },
}

/// A turn about an axis, right-handed.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RotateSpec {
    /// Direction of the axis, of any length [-].
    pub(crate) axis: [f64; 3],
    /// Angle [rad].
    pub(crate) angle: Angle,
    /// A point of the axis [m]; the origin where none is given.
    pub(crate) about: Option<[Coordinate; 3]>,
}

/// Gives every kind the properties common to all, so that each can refuse unknown keys by itself.
fn spread_over_kinds(schema: &mut Schema) {
    let Some(common) = schema.remove("properties") else {
        return;
    };
    let Some(Value::Array(kinds)) = schema.get_mut("oneOf") else {
        return;
    };
    for kind in kinds {
        if let (Some(properties), Value::Object(common)) =
            (kind["properties"].as_object_mut(), &common)
        {
            properties.extend(common.clone());
        }
        kind["additionalProperties"] = false.into();
    }
}
