//! Shapes as written to solids as computed.

use super::{Resolver, point, sides};
use crate::key_path::KeyPath;
use crate::quantity::{Angle, Coordinate, Size};
use crate::spec::shape::{RotateSpec, ShapeSpec, SolidSpec};
use pelletflow_core::shape::{Profile, ShapeError};
use pelletflow_core::{Shape, UnitQuaternion, UnitVector3, Vec3};

impl Resolver<'_> {
    pub(super) fn shape(&mut self, spec: &ShapeSpec, path: &KeyPath) -> Shape {
        let mut shape = self.solid(&spec.solid, path);
        if let Some(rotate) = &spec.rotate {
            shape = self.rotated(shape, rotate, &path.key("rotate"));
        }
        match spec.translate {
            Some(by) => shape.translated(point(by)),
            None => shape,
        }
    }

    /// What is made of other shapes has those checked where they stand.
    fn solid(&mut self, spec: &SolidSpec, path: &KeyPath) -> Shape {
        match spec {
            SolidSpec::Union { of } => Shape::Union {
                of: self.parts(of, path),
            },
            SolidSpec::Intersection { of } => Shape::Intersection {
                of: self.parts(of, path),
            },
            SolidSpec::Difference { of, minus } => Shape::Difference {
                of: Box::new(self.shape(of, &path.key("of"))),
                minus: Box::new(self.shape(minus, &path.key("minus"))),
            },
            SolidSpec::Blend { of, radius } => Shape::Blend {
                radius: radius.0,
                of: self.parts(of, path),
            },
            SolidSpec::Mirror {
                of,
                point: at,
                normal,
            } => Shape::Mirrored {
                point: point(*at),
                normal: self.direction(*normal, &path.key("normal")),
                of: Box::new(self.shape(of, &path.key("of"))),
            },
            SolidSpec::Scale { of, factor, about } => {
                let scaled = Shape::Scaled {
                    by: *factor,
                    of: Box::new(self.shape(of, &path.key("of"))),
                };
                let about = about.map_or_else(Vec3::zeros, point);
                moved(scaled, (1.0 - factor) * about)
            }
            SolidSpec::Offset { of, by } => Shape::Offset {
                by: by.0,
                of: Box::new(self.shape(of, &path.key("of"))),
            },
            SolidSpec::Shell { of, thickness } => {
                let of = self.shape(of, &path.key("of"));
                self.shell(of, thickness.0, path)
            }
            primitive => self.primitive(primitive, path),
        }
    }

    fn primitive(&mut self, spec: &SolidSpec, path: &KeyPath) -> Shape {
        let solid = match spec {
            SolidSpec::HalfSpace { point: at, normal } => Shape::HalfSpace {
                point: point(*at),
                normal: self.direction(*normal, &path.key("normal")),
            },
            SolidSpec::Sphere { center, radius } => {
                moved(Shape::Sphere { radius: radius.0 }, point(*center))
            }
            SolidSpec::Cylinder {
                base,
                axis,
                radius,
                height,
            } => {
                let half_length = height.0 / 2.0;
                let solid = Shape::Cylinder {
                    radius: radius.0,
                    half_length,
                };
                self.stood(solid, half_length, *axis, point(*base), path)
            }
            SolidSpec::Cone {
                base,
                axis,
                lower_radius,
                upper_radius,
                height,
            } => {
                let half_length = height.0 / 2.0;
                let solid = Shape::Cone {
                    lower_radius: lower_radius.0,
                    upper_radius: upper_radius.0,
                    half_length,
                };
                self.stood(solid, half_length, *axis, point(*base), path)
            }
            SolidSpec::Torus {
                center,
                axis,
                ring_radius,
                tube_radius,
            } => {
                let solid = self.torus(ring_radius.0, tube_radius.0, path);
                self.stood(solid, 0.0, *axis, point(*center), path)
            }
            SolidSpec::Capsule {
                base,
                axis,
                radius,
                height,
            } => {
                let half_length = height.0 / 2.0;
                let solid = Shape::Capsule {
                    radius: radius.0,
                    half_length,
                };
                self.stood(solid, half_length, *axis, point(*base), path)
            }
            SolidSpec::Ellipsoid { center, half_axes } => {
                let half_axes = sides(*half_axes);
                moved(Shape::Ellipsoid { half_axes }, point(*center))
            }
            SolidSpec::Box {
                min,
                max,
                center,
                size,
            } => self.cuboid([*min, *max], *center, *size, path),
            SolidSpec::Plate {
                center,
                size,
                incline,
                heading,
            } => plate(point(*center), sides(*size) / 2.0, [*incline, *heading]),
            SolidSpec::Revolution {
                profile,
                thickness,
                base,
            } => {
                let profile = profile_of(profile, *thickness);
                moved(
                    Shape::Revolution { profile },
                    base.map_or_else(Vec3::zeros, point),
                )
            }
            SolidSpec::Union { .. }
            | SolidSpec::Intersection { .. }
            | SolidSpec::Difference { .. }
            | SolidSpec::Blend { .. }
            | SolidSpec::Mirror { .. }
            | SolidSpec::Scale { .. }
            | SolidSpec::Offset { .. }
            | SolidSpec::Shell { .. } => {
                unreachable!("what is made of other shapes is resolved before")
            }
        };
        if let Err(error) = solid.validate() {
            self.findings.add(path, error.to_string());
        }
        solid
    }

    fn parts(&mut self, parts: &[ShapeSpec], path: &KeyPath) -> Vec<Shape> {
        parts
            .iter()
            .enumerate()
            .map(|(index, part)| self.shape(part, &path.key("of").index(index)))
            .collect()
    }

    /// A solid about the z axis, stood with its lower end on `base` and along `axis`.
    fn stood(
        &mut self,
        solid: Shape,
        half_length: f64,
        axis: Option<[f64; 3]>,
        base: Vec3,
        path: &KeyPath,
    ) -> Shape {
        let Some(axis) = axis else {
            return moved(solid, base + half_length * Vec3::z());
        };
        let axis = self.direction(axis, &path.key("axis"));
        // Straight down has no shortest turn; any axis across will do.
        let turn = UnitQuaternion::rotation_between(&Vec3::z(), &axis).unwrap_or_else(|| {
            UnitQuaternion::from_axis_angle(&Vec3::x_axis(), std::f64::consts::PI)
        });
        moved(turned(solid, turn), base + half_length * axis.into_inner())
    }

    fn shell(&mut self, of: Shape, thickness: f64, path: &KeyPath) -> Shape {
        let shell = Shape::Shell {
            thickness,
            of: Box::new(of),
        };
        // Other mistakes have been found in the part itself.
        if let Err(ShapeError::TooLarge { value, limit, .. }) = shell.validate() {
            self.findings.add(
                &path.key("thickness"),
                format!(
                    "`thickness` is {value} m; expected less than {limit} m, half of the smallest side of `of`; make the \
                     wall thinner or leave the shape solid"
                ),
            );
            return stand_in();
        }
        shell
    }

    fn torus(&mut self, ring_radius: f64, tube_radius: f64, path: &KeyPath) -> Shape {
        if tube_radius >= ring_radius {
            self.findings.add(
                &path.key("tube_radius"),
                format!(
                    "`tube_radius` is {tube_radius} m and `ring_radius` {ring_radius} m; expected `tube_radius` below \
                     `ring_radius`; make the tube thinner or the ring wider"
                ),
            );
            return stand_in();
        }
        Shape::Torus {
            ring_radius,
            tube_radius,
        }
    }

    fn cuboid(
        &mut self,
        [min, max]: [Option<[Coordinate; 3]>; 2],
        center: Option<[Coordinate; 3]>,
        size: Option<[Size; 3]>,
        path: &KeyPath,
    ) -> Shape {
        let (center, half_sides) = match (min, max, center, size) {
            (Some(min), Some(max), None, None) => {
                let (min, max) = (point(min), point(max));
                if let Some(axis) = (0..3).find(|&axis| min[axis] >= max[axis]) {
                    let name = ["x", "y", "z"][axis];
                    self.findings.add(
                        &path.key("max"),
                        format!(
                            "`max` is {} m along {name} and `min` is {} m; expected `max` above `min`",
                            max[axis], min[axis]
                        ),
                    );
                    return stand_in();
                }
                ((min + max) / 2.0, (max - min) / 2.0)
            }
            (None, None, Some(center), Some(size)) => (point(center), sides(size) / 2.0),
            _ => {
                self.findings.add(
                    path,
                    "a box needs either `min` and `max`, or `center` and `size`",
                );
                return stand_in();
            }
        };
        moved(Shape::Cuboid { half_sides }, center)
    }

    fn rotated(&mut self, shape: Shape, spec: &RotateSpec, path: &KeyPath) -> Shape {
        let axis: UnitVector3<f64> = self.direction(spec.axis, &path.key("axis"));
        let turn = UnitQuaternion::from_axis_angle(&axis, spec.angle.0);
        let about = spec.about.map_or_else(Vec3::zeros, point);
        moved(turned(shape, turn), about - turn * about)
    }
}

/// A sheet placed by the middle of its upper face, about which it turns: down toward +x, then about z.
fn plate(center: Vec3, half_sides: Vec3, [incline, heading]: [Option<Angle>; 2]) -> Shape {
    let turn = |axis, angle: Option<Angle>| {
        UnitQuaternion::from_axis_angle(&axis, angle.map_or(0.0, |angle| angle.0))
    };
    let sheet = Shape::Cuboid { half_sides }.translated(-half_sides.z * Vec3::z());
    let tilt = turn(Vec3::z_axis(), heading) * turn(Vec3::y_axis(), incline);
    moved(turned(sheet, tilt), center)
}

fn profile_of(corners: &[[Coordinate; 2]], thickness: Option<Size>) -> Profile {
    let corners = corners
        .iter()
        .map(|corner| corner.map(|Coordinate(value)| value))
        .collect();
    match thickness {
        Some(Size(thickness)) => Profile::Plate { corners, thickness },
        None => Profile::Closed { corners },
    }
}

/// The shape moved; one that stays where it is costs nothing more to evaluate.
fn moved(shape: Shape, by: Vec3) -> Shape {
    if by == Vec3::zeros() {
        shape
    } else {
        shape.translated(by)
    }
}

fn turned(shape: Shape, by: UnitQuaternion<f64>) -> Shape {
    if by == UnitQuaternion::identity() {
        shape
    } else {
        shape.rotated(by)
    }
}

/// Taken for a shape that cannot be, so that the checks can go on.
fn stand_in() -> Shape {
    Shape::Sphere { radius: 1.0 }
}
