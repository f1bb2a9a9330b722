//! The parts of a law put together: one contact, or a batch of them by the same functions.

use super::batch::{self, Batch, Lanes};
use super::laws::TurningLaw;
use super::memory::Extra;
use super::motion::{Alone, Motion};
use super::normal::{Normal, NormalForce};
use super::peak::{self, Quantity};
use super::sampling::{Sample, Sampling};
use super::spring::{SpringForce, turned_into_plane};
use super::tangential::{Slide, Tangential};
use super::turning::{ConstantTorque, FreeTurning, Resistance, SpringDashpot, Turning};
use super::{Contact, ContactForce, ContactHistory};
use crate::instructions::{InstructionSet, Task};
use crate::{MaterialPair, Vec3};
use std::marker::PhantomData;

/// Resistance to rolling and twisting.
pub(super) trait Turnings {
    /// Torque against rolling.
    fn roll(&self, resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce;
    /// Torque against twisting.
    fn twist(&self, resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce;
    /// Whether springs resist rolling, and twisting.
    fn have_springs(&self) -> [bool; 2];
}

/// Laws of rolling and twisting that are known when this is compiled.
pub(super) struct Fixed<R, W>(PhantomData<(R, W)>);

impl<R: Turning, W: Turning> Turnings for Fixed<R, W> {
    #[inline(always)]
    fn roll(&self, resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce {
        R::torque(resistance, spin, stretch)
    }

    #[inline(always)]
    fn twist(&self, resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce {
        W::torque(resistance, spin, stretch)
    }

    #[inline(always)]
    fn have_springs(&self) -> [bool; 2] {
        [R::HAS_SPRING, W::HAS_SPRING]
    }
}

/// Laws of rolling and twisting that a scene chooses.
pub(super) struct Chosen {
    pub(super) rolling: TurningLaw,
    pub(super) twisting: TurningLaw,
}

impl TurningLaw {
    #[inline(always)]
    fn torque(self, resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce {
        match self {
            Self::None => FreeTurning::torque(resistance, spin, stretch),
            Self::ConstantTorque => ConstantTorque::torque(resistance, spin, stretch),
            Self::SpringDashpot => SpringDashpot::torque(resistance, spin, stretch),
        }
    }
}

impl Turnings for Chosen {
    #[inline(always)]
    fn roll(&self, resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce {
        self.rolling.torque(resistance, spin, stretch)
    }

    #[inline(always)]
    fn twist(&self, resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce {
        self.twisting.torque(resistance, spin, stretch)
    }

    #[inline(always)]
    fn have_springs(&self) -> [bool; 2] {
        [self.rolling, self.twisting].map(|law| law == TurningLaw::SpringDashpot)
    }
}

/// A contact's normal direction at a sample.
struct Touch {
    sample: Sample,
    predicted_speed: f64,
}

/// Force of one contact over one step.
#[inline(never)]
pub(super) fn force<N: Normal, T: Tangential, W: Turnings>(
    contact: &Contact,
    pair: &MaterialPair,
    turnings: &W,
    history: &mut ContactHistory,
    sampling: &Sampling,
) -> ContactForce {
    let mut touch = touch::<N>(contact, pair, history, sampling);
    if touch.sample.is_edge {
        let alone = Alone {
            contact,
            pair,
            history,
        };
        touch.sample = sampling.at_edge::<N>(&alone, touch.predicted_speed, touch.sample);
    }
    composed::<T, W>(contact, pair, turnings, &touch, history, sampling)
}

/// Contacts of a batch, to be worked out by laws that are known when this is compiled.
struct Forces<'a, N, T, W> {
    batch: &'a mut Batch,
    count: usize,
    sampling: &'a Sampling,
    turnings: W,
    laws: PhantomData<(N, T)>,
}

impl<N: Normal, T: Tangential, W: Turnings> Task for Forces<'_, N, T, W> {
    type Output = ();

    /// All lanes as if in the smooth middle of their contacts, then those few again that begin or end.
    #[inline(always)]
    fn run(self) {
        let Self {
            batch,
            count,
            sampling,
            turnings,
            ..
        } = self;
        let [rolling, twisting] = turnings.have_springs();
        let remembered = Extra {
            depth: N::REMEMBERS_DEPTH,
            rolling,
            twisting,
            sliders: T::HAS_SLIDERS,
        };
        let extra = std::mem::take(&mut batch.extra);
        let mut next_extra = std::mem::take(&mut batch.next_extra);
        for lane in 0..batch::whole_blocks(count) {
            let contact = batch.contact(lane);
            let pair = batch.pair(lane);
            let mut history = batch.basic_history(lane);
            read(remembered, &extra, lane, &mut history);
            let touch = touch::<N>(&contact, &pair, &history, sampling);
            let force =
                composed::<T, W>(&contact, &pair, &turnings, &touch, &mut history, sampling);
            batch.set_force(lane, &contact, &force, &history);
            batch.set_edge(lane, touch.sample.is_edge);
            write(remembered, &mut next_extra, lane, &mut history);
        }
        if sampling.is_located() && batch.has_edge(count) {
            for lane in 0..count {
                if batch.is_edge(lane) {
                    let contact = batch.contact(lane);
                    let pair = batch.pair(lane);
                    let mut history = batch.basic_history(lane);
                    read(remembered, &extra, lane, &mut history);
                    let force =
                        force::<N, T, W>(&contact, &pair, &turnings, &mut history, sampling);
                    batch.set_force(lane, &contact, &force, &history);
                    write(remembered, &mut next_extra, lane, &mut history);
                }
            }
        }
        batch.extra = extra;
        batch.next_extra = next_extra;
    }
}

#[inline(always)]
fn read(remembered: Extra, extra: &[Lanes], lane: usize, history: &mut ContactHistory) {
    let mut place = 0;
    remembered.each(history, |number| {
        *number = extra[place][lane];
        place += 1;
    });
}

#[inline(always)]
fn write(remembered: Extra, extra: &mut [Lanes], lane: usize, history: &mut ContactHistory) {
    let mut place = 0;
    remembered.each(history, |number| {
        extra[place][lane] = *number;
        place += 1;
    });
}

/// Forces of the first `count` contacts of a batch.
pub(super) fn forces<N: Normal, T: Tangential, W: Turnings>(
    batch: &mut Batch,
    count: usize,
    turnings: W,
    sampling: &Sampling,
    instructions: InstructionSet,
) {
    instructions.run(Forces::<N, T, W> {
        batch,
        count: count.min(batch::LANES),
        sampling,
        turnings,
        laws: PhantomData,
    });
}

/// Greatest force or overlap within a number of steps of a sample; that of the sample where the top is farther away.
pub(super) fn peak_near<N: Normal>(
    (quantity, steps): (Quantity, u32),
    contact: &Contact,
    pair: &MaterialPair,
    history: &ContactHistory,
    sampling: &Sampling,
) -> f64 {
    let touch = touch::<N>(contact, pair, history, sampling);
    let from = if history.normal_force == 0.0 {
        Motion {
            overlap: contact.overlap,
            speed: touch.predicted_speed,
        }
    } else {
        sampling.true_motion::<N>(contact, touch.sample.speed, &touch.sample.law)
    };
    let sampled = match quantity {
        Quantity::Force => touch.sample.law.force,
        Quantity::Overlap => contact.overlap,
    };
    let within = (steps, sampling.time_step());
    let alone = Alone {
        contact,
        pair,
        history,
    };
    peak::top_near::<N>(quantity, &alone, from, within).unwrap_or(sampled)
}

#[inline(always)]
fn touch<N: Normal>(
    contact: &Contact,
    pair: &MaterialPair,
    history: &ContactHistory,
    sampling: &Sampling,
) -> Touch {
    let predicted_speed = -contact.relative_velocity.dot(&contact.normal);
    let predicted = N::force(contact, pair, history, predicted_speed);
    Touch {
        sample: sampling.smooth::<N>(contact, &predicted, predicted_speed, history),
        predicted_speed,
    }
}

#[inline(always)]
fn composed<T: Tangential, W: Turnings>(
    contact: &Contact,
    pair: &MaterialPair,
    turnings: &W,
    touch: &Touch,
    history: &mut ContactHistory,
    sampling: &Sampling,
) -> ContactForce {
    let Sample { law, applied, .. } = touch.sample;
    let slide = Slide {
        velocity: contact.relative_velocity + touch.predicted_speed * contact.normal,
        time_step: sampling.time_step(),
        rate: sampling.rate(),
        elapsed: touch.sample.elapsed,
        behind: touch.sample.behind,
    };
    let sliding = T::force(contact, pair, &applied, &slide, history);
    let (rolling, twisting) = turned(contact, pair, turnings, &applied, history, sampling);
    history.deepest_overlap = if contact.overlap > history.deepest_overlap {
        contact.overlap
    } else {
        history.deepest_overlap
    };
    history.samples = if applied.is_touching {
        history.samples + 1.0
    } else {
        0.0
    };
    history.normal_force = if !applied.is_touching {
        0.0
    } else if applied.force == 0.0 {
        f64::MIN_POSITIVE
    } else {
        applied.force
    };
    ContactForce {
        normal: law.force,
        force: applied.force * contact.normal + sliding.force,
        tangential: sliding.force.norm(),
        turning_torque: rolling.force + twisting.force,
        elastic_energy: law.elastic_energy,
        dissipation: applied.dissipation + applied.spring_heat * sampling.rate(),
        shear_energy: sliding.elastic_energy + rolling.elastic_energy + twisting.elastic_energy,
        shear_power: sliding.power + rolling.power + twisting.power,
    }
}

/// What resists rolling, and what resists twisting.
#[inline(always)]
fn turned<W: Turnings>(
    contact: &Contact,
    pair: &MaterialPair,
    turnings: &W,
    normal: &NormalForce,
    history: &mut ContactHistory,
    sampling: &Sampling,
) -> (SpringForce, SpringForce) {
    let twist = contact.relative_spin.dot(&contact.normal) * contact.normal;
    let roll = contact.relative_spin - twist;
    let mut rolled = turned_into_plane(history.rolling_stretch, contact.normal);
    let mut twisted = history.twisting_stretch * contact.normal;
    let of_rolling = Resistance::of_rolling(contact, pair, normal, sampling);
    let of_twisting = Resistance::of_twisting(contact, pair, normal, sampling);
    let rolling = turnings.roll(&of_rolling, roll, &mut rolled);
    let twisting = turnings.twist(&of_twisting, twist, &mut twisted);
    history.rolling_stretch = rolled;
    history.twisting_stretch = twisted.dot(&contact.normal);
    (rolling, twisting)
}

impl<R, W> Default for Fixed<R, W> {
    fn default() -> Self {
        Self(PhantomData)
    }
}
