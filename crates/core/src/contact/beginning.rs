//! The first two samples of a damped contact, by following it from first touch.
//!
//! Between two samples a body flies straight, so what a kick does is a way: one of `J` at a sample takes it `J Δt / m*` off
//! course by the next. The first two kicks of a contact are those that bring the bodies to where the contact alone brings
//! them at the second and at the third sample. From there on force and motion are smooth, and samples stand for steps.
//!
//! The way off course of the samples is `Δt² F / 12 m*` less than the true one, and `Δt⁴ F̈ / 240 m*` more: what twice
//! adding up gives of a smooth force in place of its integral. F̈ is that of the powers with which the force begins.

use super::motion::{Alone, Motion};
use super::normal::Normal;

/// Parts in which the contact is followed from first touch to its second sample [-].
const FIRST_PARTS: u32 = 6;
/// Power by which the parts grow longer [-]: damping sets in as a root, which short ones can follow.
const GRADING: i32 = 5;

/// A contact that begins: what its bodies bring.
#[derive(Debug, Clone, Copy)]
pub(super) struct Beginning<'a> {
    pub(super) alone: Alone<'a>,
    /// Speed of approach at first touch [m/s].
    pub(super) speed: f64,
    /// Time from first touch to the first sample over a step [-].
    pub(super) share: f64,
    /// [s].
    pub(super) time_step: f64,
}

impl Beginning<'_> {
    /// The force that stands for the step at the first sample [N].
    pub(super) fn first_kick<N: Normal>(&self) -> f64 {
        let second_sample = self.motion_at_second::<N>();
        self.force_over(self.off_course::<N>(second_sample, self.share + 1.0))
    }

    /// The force that stands for the step at the second sample [N].
    pub(super) fn second_kick<N: Normal>(&self) -> f64 {
        let second_sample = self.motion_at_second::<N>();
        let third_sample = self.alone.advanced::<N>(second_sample, self.time_step);
        let by_first = self.off_course::<N>(second_sample, self.share + 1.0);
        let by_both = self.off_course::<N>(third_sample, self.share + 2.0);
        // The first kick has twice the time.
        self.force_over(by_both - 2.0 * by_first)
    }

    /// Work on the spring that falls to the first sample [J], whose force over the step is this [N].
    ///
    /// That up to the second sample, less what samples of a smooth force count of it from there on (Euler and Maclaurin).
    pub(super) fn spring_work<N: Normal>(&self, first_kick: f64) -> f64 {
        let way = self.speed * self.time_step - self.way_of(first_kick);
        let second_sample = Motion {
            overlap: self.alone.contact.overlap + way,
            speed: self.speed,
        };
        let law = self.alone.force::<N>(second_sample);
        law.elastic_energy + law.spring_heat
            - way * (0.5 * law.elastic - way * law.stiffness / 12.0)
    }

    /// The motion at the second sample.
    fn motion_at_second<N: Normal>(&self) -> Motion {
        let end = (self.share + 1.0) * self.time_step;
        let mut motion = Motion {
            overlap: 0.0,
            speed: self.speed,
        };
        let mut time = 0.0;
        for part in 1..=FIRST_PARTS {
            let next = end * (f64::from(part) / f64::from(FIRST_PARTS)).powi(GRADING);
            motion = self.alone.advanced::<N>(motion, next - time);
            time = next;
        }
        motion
    }

    /// How far samples are off the straight course, a number of steps after first touch [m].
    fn off_course<N: Normal>(&self, motion: Motion, steps: f64) -> f64 {
        let law = self.alone.force::<N>(motion);
        let bend = |power: f64| power * (power - 1.0) / (steps * steps);
        let second_difference = bend(N::ELASTIC_POWER) * law.elastic
            + bend(N::DAMPING_POWER) * (law.force - law.elastic);
        self.speed * steps * self.time_step
            - motion.overlap
            - self.way_of(law.force / 12.0 - second_difference / 240.0)
    }

    /// How far a force over a step takes the bodies off course by the next sample [m].
    fn way_of(&self, force: f64) -> f64 {
        force * self.time_step * self.time_step * self.alone.contact.inverse_mass
    }

    /// The force that takes the bodies so far [m] off course [N].
    fn force_over(&self, way: f64) -> f64 {
        way / (self.time_step * self.time_step * self.alone.contact.inverse_mass)
    }
}
