//! A camera without perspective, so that lengths can be compared all over the picture.

use pelletflow::core::{Bounds, Vec3};

/// How far the camera looks down [rad].
const ELEVATION: f64 = 0.30;
/// How far the camera stands to the side [rad].
const AZIMUTH: f64 = 0.20;
/// Share of a panel that is left free on each side [-].
const MARGIN: f64 = 0.07;

/// A ray of light, backwards: from the eye into the scene.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ray {
    pub(crate) origin: Vec3,
    /// Unit vector.
    pub(crate) direction: Vec3,
}

impl Ray {
    pub(crate) fn at(&self, distance: f64) -> Vec3 {
        self.origin + distance * self.direction
    }
}

pub(crate) struct Camera {
    forward: Vec3,
    right: Vec3,
    up: Vec3,
    /// What the middle of the panel shows.
    target: Vec3,
    /// Distance from the target to the eye [m].
    distance: f64,
    /// Length that one pixel shows [m].
    pixel: f64,
}

impl Camera {
    /// Looks along the y axis, from above and a little from the side, at the whole of a box.
    pub(crate) fn at(bounds: &Bounds, [width, height]: [usize; 2]) -> Self {
        let forward = Vec3::new(
            AZIMUTH.sin() * ELEVATION.cos(),
            AZIMUTH.cos() * ELEVATION.cos(),
            -ELEVATION.sin(),
        );
        let right = forward.cross(&Vec3::z()).normalize();
        let up = right.cross(&forward);
        let half = (bounds.max - bounds.min) / 2.0;
        let extent = |axis: Vec3| half.dot(&axis.abs());
        let free = 1.0 - 2.0 * MARGIN;
        let by_width = 2.0 * extent(right) / (free * width as f64);
        let by_height = 2.0 * extent(up) / (free * height as f64);
        Self {
            forward,
            right,
            up,
            target: (bounds.min + bounds.max) / 2.0,
            distance: 2.0 * half.norm(),
            pixel: by_width.max(by_height),
        }
    }

    /// The ray through a point of the panel, counted from its middle, right and up [px].
    pub(crate) fn ray(&self, right: f64, up: f64) -> Ray {
        let aside = self.pixel * (right * self.right + up * self.up);
        Ray {
            origin: self.target + aside - self.distance * self.forward,
            direction: self.forward,
        }
    }
}
