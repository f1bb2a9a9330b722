//! Prescribed motion of walls: where they are at a time, without any memory.

mod table;

pub use table::{Interpolation, MotionTable};

use nalgebra::{UnitQuaternion, UnitVector3};
use pelletflow_core::{Bounds, Pose, Vec3};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// How a wall moves.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
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
        /// How it turns meanwhile, if it does.
        swing: Option<Swing>,
    },
    /// It follows a table.
    Table(MotionTable),
    /// It moves in several ways at once: each in the frame that the next carries along.
    Combined {
        /// The ways, the innermost first.
        motions: Vec<Motion>,
    },
}

/// A turn to and fro, in time with a vibration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Swing {
    /// A point of the axis, before the displacement [m].
    pub center: Vec3,
    /// Direction of the axis [-].
    pub axis: UnitVector3<f64>,
    /// Greatest turn, and the way it goes first, right-handed about the axis [rad].
    pub angle: f64,
}

/// Where a wall is and how it goes on at one instant: a turn about an axis, then a displacement.
struct Placement {
    /// Displacement [m].
    shift: Vec3,
    /// Its rate [m/s].
    velocity: Vec3,
    /// A point of the axis before the displacement [m].
    center: Vec3,
    axis: UnitVector3<f64>,
    /// Turn [rad].
    angle: f64,
    /// Its rate [rad/s].
    turn_rate: f64,
}

/// The most that a motion does at any time.
struct Greatest {
    speed: f64,
    turn_rate: f64,
    center: Vec3,
    shift: Vec3,
}

impl Motion {
    /// Where the wall is: `world_from_body` at a time [s].
    pub fn pose(&self, time: f64) -> Pose {
        if let Self::Combined { motions } = self {
            return motions.iter().fold(Pose::identity(), |inner, motion| {
                motion.pose(time).after(&inner)
            });
        }
        let placement = self.placement(time);
        let rotation = UnitQuaternion::from_axis_angle(&placement.axis, placement.angle);
        let center = placement.center;
        Pose {
            rotation,
            translation: center - rotation * center + placement.shift,
        }
    }

    /// Velocity of the wall's material at a point of the world [m], at a time [s]; in [m/s].
    pub fn velocity(&self, point: Vec3, time: f64) -> Vec3 {
        if let Self::Combined { motions } = self {
            let (mut velocity, mut point) = (Vec3::zeros(), point);
            let mut turn = UnitQuaternion::identity();
            for motion in motions.iter().rev() {
                velocity += turn * motion.velocity(point, time);
                let pose = motion.pose(time);
                point = pose.inverse_point(point);
                turn *= pose.rotation;
            }
            return velocity;
        }
        let placement = self.placement(time);
        let arm = point - placement.center - placement.shift;
        placement.velocity + placement.turn_rate * placement.axis.cross(&arm)
    }

    /// Spin of the wall at a time [s]; in [rad/s].
    pub fn spin(&self, time: f64) -> Vec3 {
        if let Self::Combined { motions } = self {
            return motions.iter().fold(Vec3::zeros(), |inner, motion| {
                motion.spin(time) + motion.pose(time).direction(inner)
            });
        }
        let placement = self.placement(time);
        placement.turn_rate * placement.axis.into_inner()
    }

    /// Greatest speed of any point of a body in a box, as far as it reaches into a domain [m/s].
    pub fn greatest_speed(&self, body: &Bounds, domain: &Bounds) -> f64 {
        let mut body = body.common(domain);
        let motions = match self {
            Self::Combined { motions } => motions,
            _ => std::slice::from_ref(self),
        };
        let mut speed = 0.0;
        for motion in motions {
            let greatest = motion.greatest();
            if greatest.turn_rate > 0.0 {
                let corner = (body.min - greatest.center)
                    .abs()
                    .sup(&(body.max - greatest.center).abs());
                let reach = corner.norm();
                speed += greatest.turn_rate * reach;
                body = Bounds::about_origin(Vec3::repeat(reach)).translated(greatest.center);
            }
            speed += greatest.speed;
            body.min -= greatest.shift;
            body.max += greatest.shift;
            body = body.common(domain);
        }
        speed
    }

    /// Whether the wall ever moves.
    pub fn is_moving(&self) -> bool {
        match self {
            Self::Fixed => false,
            Self::Combined { motions } => motions.iter().any(Self::is_moving),
            _ => true,
        }
    }

    /// Where the wall is and how it goes on, of a motion that is not combined.
    fn placement(&self, time: f64) -> Placement {
        match *self {
            Self::Fixed | Self::Combined { .. } => Placement::at_rest(),
            Self::Translating {
                velocity,
                start,
                end,
            } => Placement {
                shift: velocity * (time.clamp(start, end.max(start)) - start),
                velocity: if (start..end).contains(&time) {
                    velocity
                } else {
                    Vec3::zeros()
                },
                ..Placement::at_rest()
            },
            Self::Rotating {
                center,
                axis,
                rate,
                start,
                end,
            } => Placement {
                center,
                axis,
                angle: rate * (time.clamp(start, end.max(start)) - start),
                turn_rate: if (start..end).contains(&time) {
                    rate
                } else {
                    0.0
                },
                ..Placement::at_rest()
            },
            Self::Vibrating {
                amplitude,
                frequency,
                swing,
            } => {
                let pulsation = TAU * frequency;
                let (sine, cosine) = (pulsation * time).sin_cos();
                let swing = swing.unwrap_or(Swing {
                    center: Vec3::zeros(),
                    axis: Vec3::z_axis(),
                    angle: 0.0,
                });
                Placement {
                    shift: amplitude * sine,
                    velocity: amplitude * (pulsation * cosine),
                    center: swing.center,
                    axis: swing.axis,
                    angle: swing.angle * sine,
                    turn_rate: swing.angle * (pulsation * cosine),
                }
            }
            Self::Table(ref table) => table.at(time),
        }
    }

    /// The most of a motion that is not combined.
    fn greatest(&self) -> Greatest {
        let nothing = Greatest {
            speed: 0.0,
            turn_rate: 0.0,
            center: Vec3::zeros(),
            shift: Vec3::zeros(),
        };
        match *self {
            Self::Fixed | Self::Combined { .. } => nothing,
            Self::Translating {
                velocity,
                start,
                end,
            } => Greatest {
                speed: velocity.norm(),
                // Without an end a motion goes on for ever, but only along its velocity.
                shift: velocity.map(|component| match component {
                    0.0 => 0.0,
                    _ => component.abs() * (end - start),
                }),
                ..nothing
            },
            Self::Rotating { center, rate, .. } => Greatest {
                turn_rate: rate.abs(),
                center,
                ..nothing
            },
            Self::Vibrating {
                amplitude,
                frequency,
                swing,
            } => Greatest {
                speed: TAU * frequency * amplitude.norm(),
                turn_rate: swing.map_or(0.0, |swing| TAU * frequency * swing.angle.abs()),
                center: swing.map_or(Vec3::zeros(), |swing| swing.center),
                shift: amplitude.abs(),
            },
            Self::Table(ref table) => Greatest {
                speed: table.greatest_velocity().norm(),
                turn_rate: table.greatest_turn_rate(),
                center: table.center,
                shift: table.greatest_shift(),
            },
        }
    }
}

impl Placement {
    fn at_rest() -> Self {
        Self {
            shift: Vec3::zeros(),
            velocity: Vec3::zeros(),
            center: Vec3::zeros(),
            axis: Vec3::z_axis(),
            angle: 0.0,
            turn_rate: 0.0,
        }
    }
}

#[cfg(test)]
mod contract;
