//! Prescribed motion of walls: where they are at a time, without any memory.

use nalgebra::{UnitQuaternion, UnitVector3};
use pelletflow_core::{Pose, Vec3};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// How a wall moves.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Motion {
    /// It stays.
    #[default]
    Fixed,
    /// It moves evenly between two moments.
    Translating {
        /// Velocity [m/s].
        velocity: Vec3,
        /// First moment [s].
        start: f64,
        /// Last moment [s]; infinite where there is none.
        end: f64,
    },
    /// It turns evenly about an axis between two moments.
    Rotating {
        /// A point of the axis [m].
        center: Vec3,
        /// Direction of the axis [-].
        axis: UnitVector3<f64>,
        /// Turn per time, right-handed about the axis [rad/s].
        rate: f64,
        /// First moment [s].
        start: f64,
        /// Last moment [s]; infinite where there is none.
        end: f64,
    },
    /// It swings to and fro, starting from rest position.
    Vibrating {
        /// Greatest displacement, and the way it goes first [m].
        amplitude: Vec3,
        /// Swings per time [Hz].
        frequency: f64,
    },
}

impl Motion {
    /// Where the wall is: `world_from_body` at a time [s].
    pub fn pose(&self, time: f64) -> Pose {
        match *self {
            Self::Fixed => Pose::identity(),
            Self::Translating {
                velocity,
                start,
                end,
            } => Pose {
                translation: velocity * (time.clamp(start, end.max(start)) - start),
                ..Pose::identity()
            },
            Self::Rotating {
                center,
                axis,
                rate,
                start,
                end,
            } => {
                let angle = rate * (time.clamp(start, end.max(start)) - start);
                let rotation = UnitQuaternion::from_axis_angle(&axis, angle);
                Pose {
                    rotation,
                    translation: center - rotation * center,
                }
            }
            Self::Vibrating {
                amplitude,
                frequency,
            } => Pose {
                translation: amplitude * (TAU * frequency * time).sin(),
                ..Pose::identity()
            },
        }
    }

    /// Velocity of the wall's material at a point of the world [m], at a time [s]; in [m/s].
    pub fn velocity(&self, point: Vec3, time: f64) -> Vec3 {
        match *self {
            Self::Fixed => Vec3::zeros(),
            Self::Translating {
                velocity,
                start,
                end,
            } => {
                if (start..end).contains(&time) {
                    velocity
                } else {
                    Vec3::zeros()
                }
            }
            Self::Rotating {
                center,
                axis,
                rate,
                start,
                end,
            } => {
                if (start..end).contains(&time) {
                    rate * axis.cross(&(point - center))
                } else {
                    Vec3::zeros()
                }
            }
            Self::Vibrating {
                amplitude,
                frequency,
            } => amplitude * (TAU * frequency * (TAU * frequency * time).cos()),
        }
    }

    /// Spin of the wall at a time [s]; in [rad/s].
    pub fn spin(&self, time: f64) -> Vec3 {
        match *self {
            Self::Rotating {
                axis,
                rate,
                start,
                end,
                ..
            } if (start..end).contains(&time) => rate * axis.into_inner(),
            _ => Vec3::zeros(),
        }
    }

    /// Greatest speed of any point within `reach` of the axis or origin [m/s].
    pub fn greatest_speed(&self, reach: f64) -> f64 {
        match *self {
            Self::Fixed => 0.0,
            Self::Translating { velocity, .. } => velocity.norm(),
            Self::Rotating { rate, .. } => rate.abs() * reach,
            Self::Vibrating {
                amplitude,
                frequency,
            } => TAU * frequency * amplitude.norm(),
        }
    }

    /// Whether the wall ever moves.
    pub fn is_moving(&self) -> bool {
        !matches!(self, Self::Fixed)
    }
}
