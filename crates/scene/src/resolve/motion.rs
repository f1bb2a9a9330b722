//! Motions of walls.

use super::{Resolver, point, vector, velocity};
use crate::key_path::KeyPath;
use crate::spec::motion::{InterpolationSpec, MotionSpec, MotionsSpec, SwingSpec};
use pelletflow_core::Vec3;
use pelletflow_sim::{Interpolation, Motion, MotionTable, Swing};

impl Resolver<'_> {
    pub(super) fn motions(&mut self, spec: &MotionsSpec, path: &KeyPath) -> Motion {
        match spec {
            MotionsSpec::One(motion) => self.motion(motion, path),
            MotionsSpec::Several(motions) => Motion::Combined {
                motions: motions
                    .iter()
                    .enumerate()
                    .map(|(index, motion)| self.motion(motion, &path.index(index)))
                    .collect(),
            },
        }
    }

    fn motion(&mut self, spec: &MotionSpec, path: &KeyPath) -> Motion {
        match spec {
            MotionSpec::Fixed => Motion::Fixed,
            MotionSpec::Translating {
                velocity: components,
                start,
                end,
            } => {
                let (start, end) = self.span(*start, *end, path);
                Motion::Translating {
                    velocity: velocity(Some(*components)),
                    start,
                    end,
                }
            }
            MotionSpec::Rotating {
                center,
                axis,
                rate,
                start,
                end,
            } => {
                let (start, end) = self.span(*start, *end, path);
                Motion::Rotating {
                    center: point(*center),
                    axis: self.direction(*axis, &path.key("axis")),
                    rate: rate.0,
                    start,
                    end,
                }
            }
            MotionSpec::Vibrating {
                amplitude,
                frequency,
                swing,
            } => Motion::Vibrating {
                amplitude: vector(amplitude.map(|coordinate| coordinate.0)),
                frequency: frequency.0,
                swing: swing
                    .as_ref()
                    .map(|swing| self.swing(swing, &path.key("swing"))),
            },
            MotionSpec::Table {
                moments,
                displacements,
                angles,
                center,
                axis,
                interpolation,
            } => {
                if displacements.is_none() && angles.is_none() {
                    self.findings.add(
                        path,
                        "the table has neither `displacements` nor `angles`; give one or both",
                    );
                }
                let rows = moments.len();
                Motion::Table(MotionTable {
                    moments: moments.iter().map(|moment| moment.0).collect(),
                    displacements: self.column(
                        displacements.as_deref(),
                        |&shift| point(shift),
                        rows,
                        &path.key("displacements"),
                    ),
                    angles: self.column(
                        angles.as_deref(),
                        |angle| angle.0,
                        rows,
                        &path.key("angles"),
                    ),
                    center: center.map_or_else(Vec3::zeros, point),
                    axis: axis
                        .map_or_else(Vec3::z_axis, |axis| self.direction(axis, &path.key("axis"))),
                    interpolation: match interpolation {
                        InterpolationSpec::Linear => Interpolation::Linear,
                        InterpolationSpec::Smooth => Interpolation::Smooth,
                    },
                })
            }
        }
    }

    /// A column of a table with a value for every row; zeros where none is given.
    fn column<S, T: Clone + Default>(
        &mut self,
        values: Option<&[S]>,
        resolved: impl Fn(&S) -> T,
        rows: usize,
        path: &KeyPath,
    ) -> Vec<T> {
        let mut column: Vec<T> = values.unwrap_or_default().iter().map(resolved).collect();
        if values.is_some() && column.len() != rows {
            let (key, given) = (path.last_key(), column.len());
            self.findings.add(
                path,
                format!(
                    "`{key}` has {given} values and `moments` {rows}; expected one for each moment"
                ),
            );
        }
        column.resize(rows, T::default());
        column
    }

    fn swing(&mut self, spec: &SwingSpec, path: &KeyPath) -> Swing {
        Swing {
            center: point(spec.center),
            axis: self.direction(spec.axis, &path.key("axis")),
            angle: spec.angle.0,
        }
    }
}
