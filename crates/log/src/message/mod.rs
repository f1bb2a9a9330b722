//! One file per channel: what is recorded, turned into the message that viewers know.

mod cloud;
pub(crate) mod color;
pub(crate) mod contacts;
pub(crate) mod equipment;
pub(crate) mod event;
pub(crate) mod hits;
pub(crate) mod own;
pub(crate) mod pellets;
pub(crate) mod series;
pub(crate) mod spheres;
pub(crate) mod transforms;
pub(crate) mod worst;

use foxglove::messages::{Point3, Quaternion, Timestamp, Vector3};
use pelletflow_core::Vec3;

/// Frame that everything is placed in.
pub(crate) const WORLD: &str = "world";

/// Frame of a wall, which moves with it.
pub(crate) fn wall_frame(name: &str) -> String {
    format!("walls/{name}")
}

/// Simulated time [s] as log time [ns].
pub(crate) fn nanoseconds(time: f64) -> u64 {
    (time * 1.0e9).round() as u64
}

/// Log time [ns] as simulated time [s].
pub(crate) fn seconds(nanoseconds: u64) -> f64 {
    nanoseconds as f64 * 1.0e-9
}

/// Simulated time [s] as viewers stamp it, counted from 1970.
pub(crate) fn timestamp(time: f64) -> Timestamp {
    let nanoseconds = nanoseconds(time);
    Timestamp::new(
        (nanoseconds / 1_000_000_000) as u32,
        (nanoseconds % 1_000_000_000) as u32,
    )
}

pub(crate) fn vector(of: Vec3) -> Vector3 {
    Vector3 {
        x: of.x,
        y: of.y,
        z: of.z,
    }
}

pub(crate) fn point(of: Vec3) -> Point3 {
    Point3 {
        x: of.x,
        y: of.y,
        z: of.z,
    }
}

/// The pose that changes nothing.
pub(crate) fn in_place() -> foxglove::messages::Pose {
    foxglove::messages::Pose {
        position: Some(vector(Vec3::zeros())),
        orientation: Some(Quaternion {
            x: 0.0,
            y: 0.0,
            z: 0.0,
            w: 1.0,
        }),
    }
}

#[cfg(test)]
mod contract;
