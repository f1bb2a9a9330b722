//! The first two samples of a contact, by following it from first touch.
//!
//! Between two samples a body flies straight, so what a kick does is a way: one of `J` at a sample takes it `J Δt / m*` off
//! course by the next. The first two kicks of a contact are those that bring the bodies to where the contact alone brings
//! them at the second and at the third sample. From there on force and motion are smooth, and samples stand for steps.
//!
//! The overlap of the samples runs ahead of the true one by `Δt² F / 12 m*`, where the leapfrog keeps its energy
//! ([`Sampling`](super::Sampling)).

use super::normal::Normal;
use super::{Contact, ContactHistory};
use crate::MaterialPair;

/// Parts in which the contact is followed from first touch to its second sample [-]; short ones first, since damping sets
/// in as a root.
const FIRST_PARTS: u32 = 4;
/// Parts from the second sample to the third [-].
const NEXT_PARTS: u32 = 2;

/// A force that stands for a step, and the part of it that is the spring's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kick {
    /// Of spring and damping together [N].
    pub(super) force: f64,
    /// Of the spring [N].
    pub(super) elastic: f64,
}

/// A contact that begins: what its bodies bring.
#[derive(Debug, Clone, Copy)]
pub(super) struct Beginning<'a> {
    pub(super) contact: &'a Contact,
    pub(super) pair: &'a MaterialPair,
    pub(super) history: &'a ContactHistory,
    /// Speed of approach at first touch [m/s].
    pub(super) speed: f64,
    /// Time from first touch to the first sample over a step [-].
    pub(super) share: f64,
    /// [s].
    pub(super) time_step: f64,
}

/// The motion along the normal, and how far spring and damping have taken it off its course.
#[derive(Debug, Clone, Copy, Default)]
struct Course {
    overlap: f64,
    speed: f64,
    /// By the spring alone.
    elastic_way: f64,
    elastic_speed: f64,
}

impl Beginning<'_> {
    /// The kick of the first sample.
    pub(super) fn first<N: Normal>(&self) -> Kick {
        let (_, way) = self.to_second::<N>();
        self.kick(way)
    }

    /// The kick of the second sample.
    pub(super) fn second<N: Normal>(&self) -> Kick {
        let (mut course, first) = self.to_second::<N>();
        let part = self.time_step / f64::from(NEXT_PARTS);
        for _ in 0..NEXT_PARTS {
            course = self.advanced::<N>(course, part);
        }
        let both = self.off_course::<N>(course, self.share + 2.0);
        // The first kick has twice the time.
        self.kick([both[0] - 2.0 * first[0], both[1] - 2.0 * first[1]])
    }

    /// The motion at the second sample, and the way off course there, by all and by the spring alone [m].
    fn to_second<N: Normal>(&self) -> (Course, [f64; 2]) {
        let end = (self.share + 1.0) * self.time_step;
        let mut course = Course {
            speed: self.speed,
            ..Course::default()
        };
        let mut time = 0.0;
        for part in 1..=FIRST_PARTS {
            let next = end * (f64::from(part) / f64::from(FIRST_PARTS)).powi(3);
            course = self.advanced::<N>(course, next - time);
            time = next;
        }
        (course, self.off_course::<N>(course, self.share + 1.0))
    }

    fn off_course<N: Normal>(&self, course: Course, steps: f64) -> [f64; 2] {
        let straight = self.speed * steps * self.time_step;
        let slowing = self.rate::<N>(course);
        let ahead = self.time_step * self.time_step / 12.0;
        [
            straight - course.overlap + ahead * slowing.speed,
            ahead * slowing.elastic_speed - course.elastic_way,
        ]
    }

    fn kick(&self, way: [f64; 2]) -> Kick {
        let [force, elastic] =
            way.map(|way| way / (self.time_step * self.time_step * self.contact.inverse_mass));
        Kick { force, elastic }
    }

    /// How the motion changes, `m* δ̈ = −F`.
    fn rate<N: Normal>(&self, course: Course) -> Course {
        let at = Contact {
            overlap: course.overlap.max(0.0),
            ..*self.contact
        };
        let law = N::force(&at, self.pair, self.history, course.speed);
        Course {
            overlap: course.speed,
            speed: -law.force * self.contact.inverse_mass,
            elastic_way: course.elastic_speed,
            elastic_speed: -law.elastic * self.contact.inverse_mass,
        }
    }

    /// A time later [s], by the classical method of Runge and Kutta.
    fn advanced<N: Normal>(&self, from: Course, time: f64) -> Course {
        let first = self.rate::<N>(from);
        let second = self.rate::<N>(from.moved(0.5 * time, first));
        let third = self.rate::<N>(from.moved(0.5 * time, second));
        let fourth = self.rate::<N>(from.moved(time, third));
        from.moved(time / 6.0, first)
            .moved(time / 3.0, second)
            .moved(time / 3.0, third)
            .moved(time / 6.0, fourth)
    }
}

impl Course {
    fn moved(self, time: f64, rate: Self) -> Self {
        Self {
            overlap: self.overlap + time * rate.overlap,
            speed: self.speed + time * rate.speed,
            elastic_way: self.elastic_way + time * rate.elastic_way,
            elastic_speed: self.elastic_speed + time * rate.elastic_speed,
        }
    }
}
