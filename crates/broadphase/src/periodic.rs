//! Periodic axes: what leaves a box on one side comes in at the opposite one.

use crate::{SphereRow, is_within_reach};
use pelletflow_core::{Bounds, Vec3};

/// A box with axes along which space repeats itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeriodicBox {
    low: [f64; 3],
    /// Zero along an axis that is not periodic.
    length: [f64; 3],
    /// Displacement beyond which another image is nearer; infinite along an axis that is not periodic.
    half: [f64; 3],
}

impl PeriodicBox {
    /// A box that is periodic along some axes; none where it is along no axis.
    pub fn new(bounds: &Bounds, is_periodic: [bool; 3]) -> Option<Self> {
        let length = bounds.max - bounds.min;
        let along = |axis: usize, value: f64, otherwise: f64| {
            if is_periodic[axis] { value } else { otherwise }
        };
        is_periodic.contains(&true).then(|| Self {
            low: bounds.min.into(),
            length: [0, 1, 2].map(|axis| along(axis, length[axis], 0.0)),
            half: [0, 1, 2].map(|axis| along(axis, length[axis] / 2.0, f64::INFINITY)),
        })
    }

    /// Whether space repeats itself along an axis.
    pub fn is_periodic(&self, axis: usize) -> bool {
        self.length[axis] > 0.0
    }

    /// Lowest coordinate along an axis [m].
    pub(crate) fn low(&self, axis: usize) -> f64 {
        self.low[axis]
    }

    /// Length of the box along an axis; zero where it is not periodic [m].
    pub fn length(&self, axis: usize) -> f64 {
        self.length[axis]
    }

    /// The shortest of a displacement's images, of two points that are in the box but for less than half of it [m].
    ///
    /// Opposite displacements give exactly opposite images.
    #[inline]
    #[must_use]
    pub fn nearest(&self, displacement: [f64; 3]) -> [f64; 3] {
        let mut nearest = displacement;
        for (axis, component) in nearest.iter_mut().enumerate() {
            // Two comparisons and no call: rounding is a function on old processors.
            let sides = f64::from(i8::from(*component > self.half[axis]))
                - f64::from(i8::from(*component < -self.half[axis]));
            *component -= self.length[axis] * sides;
        }
        nearest
    }

    /// The image of a point that lies in the box along its periodic axes [m]; a point in it keeps its bits.
    #[must_use]
    pub fn wrapped(&self, point: Vec3) -> Vec3 {
        let mut wrapped = point;
        for axis in 0..3 {
            let along = point[axis] - self.low[axis];
            if self.is_periodic(axis) && !(0.0..self.length[axis]).contains(&along) {
                wrapped[axis] -= self.length[axis] * (along / self.length[axis]).floor();
            }
        }
        wrapped
    }

    /// A point of the box and all its images next to the box [m].
    pub fn images(&self, point: Vec3) -> impl Iterator<Item = Vec3> + '_ {
        let sides = |axis: usize| {
            if self.is_periodic(axis) {
                -1..=1
            } else {
                0..=0
            }
        };
        let shift = |axis: usize, side: i8| self.length[axis] * f64::from(side);
        sides(0).flat_map(move |x| {
            sides(1).flat_map(move |y| {
                sides(2).map(move |z| point + Vec3::new(shift(0, x), shift(1, y), shift(2, z)))
            })
        })
    }
}

/// Whether the gap between two pellets, or the nearest of their images, is less than the skin [m].
#[inline]
pub(crate) fn is_image_within_reach(
    periodic: &PeriodicBox,
    a: &SphereRow,
    b: &SphereRow,
    skin: f64,
) -> bool {
    let [x, y, z] = periodic.nearest([a[0] - b[0], a[1] - b[1], a[2] - b[2]]);
    is_within_reach(&[x, y, z, a[3]], &[0.0, 0.0, 0.0, b[3]], skin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn periodic() -> PeriodicBox {
        let bounds = Bounds {
            min: Vec3::new(-1.0, 2.0, 0.0),
            max: Vec3::new(3.0, 5.0, 1.0),
        };
        PeriodicBox::new(&bounds, [true, true, false]).expect("two axes are periodic")
    }

    fn point() -> impl Strategy<Value = Vec3> {
        (-1.0..3.0_f64, 2.0..5.0_f64, -4.0..4.0_f64).prop_map(|(x, y, z)| Vec3::new(x, y, z))
    }

    proptest! {
        #[test]
        fn no_image_is_nearer_than_the_nearest(a in point(), b in point()) {
            let periodic = periodic();
            let nearest = Vec3::from(periodic.nearest((a - b).into())).norm();
            let least = periodic.images(b).map(|b| (a - b).norm()).fold(f64::INFINITY, f64::min);
            // One subtraction more or less.
            prop_assert!((nearest - least).abs() < 1.0e-14);
        }

        #[test]
        fn opposite_displacements_have_opposite_images(a in point(), b in point()) {
            let periodic = periodic();
            let there = Vec3::from(periodic.nearest((a - b).into()));
            let back = Vec3::from(periodic.nearest((b - a).into()));
            prop_assert_eq!(there, -back);
        }

        #[test]
        fn a_point_comes_back_to_the_box_by_whole_lengths(inside in point(), x in -3..4_i8, y in -3..4_i8) {
            let away = inside + Vec3::new(4.0 * f64::from(x), 3.0 * f64::from(y), 0.0);
            let wrapped = periodic().wrapped(away);
            // Rounding of coordinates up to 15.
            prop_assert!((wrapped - inside).norm() < 1.0e-14);
        }
    }

    #[test]
    fn a_box_without_periodic_axes_is_none() {
        let bounds = Bounds::about_origin(Vec3::repeat(1.0));
        assert_eq!(PeriodicBox::new(&bounds, [false; 3]), None);
    }
}
