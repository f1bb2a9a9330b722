//! How the spheres of a batch meet.

use super::{Batch, Row, set_vector, vector, whole_blocks};
use crate::Vec3;
use crate::instructions::{InstructionSet, Task};

/// Two spheres that touch, as rows.
#[derive(Debug, Clone, Copy)]
pub struct SpherePair {
    /// Center of the first less that of the second [m], and the radius of the first [m].
    pub between: Row,
    /// Radius of the second [m].
    pub other_radius: f64,
    /// Velocity of the first less that of the second [m/s], and the sum of the inverse masses [1/kg].
    pub velocity: Row,
    /// Spins [rad/s]; the companions are not read.
    pub spins: [Row; 2],
}

impl Batch {
    /// Puts two spheres into a lane; [`meet`](Self::meet) makes contacts of them.
    ///
    /// `is_counted` tells whether the totals hold it.
    #[inline(always)]
    pub fn set_spheres(&mut self, lane: usize, pair: &SpherePair, is_counted: bool) {
        for axis in 0..3 {
            self.between[axis][lane] = pair.between[axis];
            self.velocity[axis][lane] = pair.velocity[axis];
            self.spins[0][axis][lane] = pair.spins[0][axis];
            self.spins[1][axis][lane] = pair.spins[1][axis];
        }
        self.radii[0][lane] = pair.between[3];
        self.radii[1][lane] = pair.other_radius;
        self.inverse_mass[lane] = pair.velocity[3];
        self.counted[lane] = f64::from(u8::from(is_counted));
    }

    /// Works out how the spheres in the first `count` lanes touch.
    pub fn meet(&mut self, count: usize, instructions: InstructionSet) {
        instructions.run(Meet { batch: self, count });
    }

    #[inline(always)]
    fn meet_all(&mut self, count: usize) {
        for lane in 0..whole_blocks(count) {
            let [x, y, z] = [
                self.between[0][lane],
                self.between[1][lane],
                self.between[2][lane],
            ];
            let radii = [self.radii[0][lane], self.radii[1][lane]];
            let inverse_mass = self.inverse_mass[lane];
            let distance = (x * x + y * y + z * z).sqrt();
            let radii_sum = radii[0] + radii[1];
            // One division serves three.
            let inverse = 1.0 / (distance * (radii_sum * inverse_mass));
            let per_distance = inverse * (radii_sum * inverse_mass);
            let per_sums = inverse * distance;
            let normal = Vec3::new(x * per_distance, y * per_distance, z * per_distance);
            let overlap = radii_sum - distance;
            let arms = [radii[0] - 0.5 * overlap, radii[1] - 0.5 * overlap];
            let (a, b) = (vector(&self.spins[0], lane), vector(&self.spins[1], lane));
            let sliding = (arms[0] * a + arms[1] * b).cross(&normal);
            set_vector(&mut self.normal, lane, normal);
            let velocity = vector(&self.velocity, lane) - sliding;
            set_vector(&mut self.relative_velocity, lane, velocity);
            set_vector(&mut self.relative_spin, lane, a - b);
            self.overlap[lane] = overlap;
            self.arms[0][lane] = arms[0];
            self.arms[1][lane] = arms[1];
            self.effective_radius[lane] = radii[0] * radii[1] * inverse_mass * per_sums;
            self.effective_mass[lane] = radii_sum * per_sums;
        }
    }
}

/// The geometry of spheres.
struct Meet<'a> {
    batch: &'a mut Batch,
    count: usize,
}

impl Task for Meet<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.batch.meet_all(self.count);
    }
}
