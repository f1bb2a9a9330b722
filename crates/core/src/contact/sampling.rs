//! How a force worked out once a step stands for the whole step.
//!
//! A step adds `F Δt`, so over an impact the sum of the samples stands for the integral of the force: the trapezoidal
//! rule. Where the force begins or ends between two samples that rule loses its order: for `F ∝ sᵖ` from first touch
//! on, it errs by `ζ(−p, θ) Δtᵖ⁺¹`, with θ the share of a step from first touch to the first sample and ζ Hurwitz's
//! zeta function (Navot 1961). Located sampling takes that error off the first and the last sample of an elastic contact.
//! Damping changes the speed within the first step, and lets go of bodies that still overlap: a damped contact is followed
//! by itself through its first two samples and its last.
//! In between it does two more things at no cost in samples: it completes the predicted speed by what the contact itself
//! has changed since the last sample, and it takes off the leading error of the leapfrog, `Δt² S / 12 m*` of the force
//! (the force gradient of Takahashi & Imada 1984 for one contact).

use super::beginning::Beginning;
use super::motion::{Alone, Motion};
use super::normal::{Normal, NormalForce};
use super::release;
use super::{Contact, ContactHistory};

/// A rule by which samples of a force stand for its integral.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// The time step [s].
    time_step: f64,
    /// Steps per second [1/s].
    rate: f64,
    /// What the last sample's force is multiplied by to complete the speed: half a step, or nothing [s].
    completion: f64,
    /// `Δt² / 12`, or nothing [s²].
    gradient: f64,
}

/// The normal part of one sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Speed of approach at the sample [m/s].
    pub(super) speed: f64,
    /// The force of the law, as it is to be reported.
    pub(super) law: NormalForce,
    /// The force that stands for the step.
    pub(super) applied: NormalForce,
    /// Whether the contact begins or ends near this sample.
    pub(super) is_edge: bool,
    /// Whether the force is gone by the next sample, at the rate it changes now.
    pub(super) ends: bool,
    /// Time since the last sample, or since first touch [s].
    pub(super) elapsed: f64,
    /// Time before the sample for which a velocity stands where a spring stiffens with the contact [s].
    pub(super) behind: f64,
}

/// Samples of a contact that its beginning takes; beyond, samples stand for a smooth motion [-].
const SAMPLES_OF_BEGINNING: f64 = 3.0;

impl Sampling {
    /// The bare law at every sample, over steps of `time_step` [s].
    pub fn plain(time_step: f64) -> Self {
        Self {
            time_step,
            rate: 1.0 / time_step,
            completion: 0.0,
            gradient: 0.0,
        }
    }

    /// First touch and release located within the step of `time_step` [s].
    pub fn located(time_step: f64) -> Self {
        Self {
            time_step,
            rate: 1.0 / time_step,
            completion: 0.5 * time_step,
            gradient: time_step * time_step / 12.0,
        }
    }

    /// The time step [s].
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// Steps per second [1/s].
    pub(super) fn rate(&self) -> f64 {
        self.rate
    }

    /// Whether first touch and release are located.
    pub fn is_located(&self) -> bool {
        self.gradient > 0.0
    }

    /// The motion that a sample of the leapfrog stands for: one of an overlap, a speed of approach [m/s] and a force.
    ///
    /// The leapfrog conserves `T (1 + Δt² S / 6 m*) + V − c F² Δt² / m*` in place of `T + V`, with c of 1/24
    /// (Hairer, Lubich & Wanner 2006, section IX.3), and of 1/12 with the force gradient. Damped, the whole rate of the
    /// force takes the place of `S v`.
    pub(super) fn true_motion<N: Normal>(
        &self,
        contact: &Contact,
        speed: f64,
        law: &NormalForce,
    ) -> Motion {
        let per_mass = self.time_step * self.time_step * contact.inverse_mass;
        let share = if self.is_located() { 12.0 } else { 24.0 };
        let of_damping = if law.elastic_overlap > 0.0 {
            N::DAMPING_POWER * law.damping * speed / law.elastic_overlap
        } else {
            0.0
        };
        let rate =
            (law.stiffness + of_damping) * speed - law.damping * law.force * contact.inverse_mass;
        Motion {
            overlap: contact.overlap - law.force * per_mass / share,
            speed: speed + rate * per_mass / 12.0,
        }
    }

    /// The sample in the smooth middle of a contact.
    #[inline(always)]
    pub(super) fn smooth<N: Normal>(
        &self,
        contact: &Contact,
        predicted: &NormalForce,
        predicted_speed: f64,
        history: &ContactHistory,
    ) -> Sample {
        let last_force = history.normal_force;
        let inverse_mass = contact.inverse_mass;
        let speed =
            predicted_speed - self.completion * inverse_mass * (predicted.force - last_force);
        let completed = predicted.at_speed(speed);
        let law = self.softened(completed, inverse_mass);
        let begins = last_force == 0.0;
        let ends = N::ENDS_AT_ZERO
            && speed < 0.0
            && completed.force > 0.0
            && self.is_gone_next::<N>(&completed, contact, speed);
        Sample {
            speed,
            law,
            applied: law,
            is_edge: (begins || ends || history.samples == 1.0) && self.gradient > 0.0,
            ends,
            elapsed: if begins {
                0.5 * self.time_step
            } else {
                self.time_step
            },
            behind: 0.5 * self.time_step,
        }
    }

    /// A force less its part in the leading error of the leapfrog.
    #[inline(always)]
    fn softened(&self, law: NormalForce, inverse_mass: f64) -> NormalForce {
        NormalForce {
            force: law.force * (1.0 - self.gradient * law.stiffness * inverse_mass),
            ..law
        }
    }

    /// Whether the law's force, at the rate it changes now, is gone within a step.
    ///
    /// The rate is `(S + p c v / δ) v − c F / m*`; all is multiplied by δ to spare the division.
    #[inline(always)]
    fn is_gone_next<N: Normal>(&self, force: &NormalForce, contact: &Contact, speed: f64) -> bool {
        let overlap = force.elastic_overlap;
        let by_overlap = force.stiffness * overlap + N::DAMPING_POWER * force.damping * speed;
        let by_speed = force.damping * force.force * contact.inverse_mass * overlap;
        overlap * force.force + self.time_step * (by_overlap * speed - by_speed) < 0.0
    }

    /// The sample next to first touch or release, from that of a smooth contact.
    pub(super) fn at_edge<N: Normal>(
        &self,
        alone: &Alone<'_>,
        predicted_speed: f64,
        smooth: Sample,
    ) -> Sample {
        if alone.history.normal_force == 0.0 {
            self.at_first::<N>(alone, predicted_speed, smooth)
        } else if smooth.law.damping == 0.0 {
            self.at_elastic_last::<N>(alone.contact, smooth)
        } else if smooth.ends && alone.history.samples >= SAMPLES_OF_BEGINNING {
            self.at_damped_last::<N>(alone, predicted_speed, smooth)
        } else if alone.history.samples == 1.0 {
            self.at_damped_second::<N>(alone, predicted_speed, smooth)
        } else {
            smooth
        }
    }

    /// The first sample of a contact.
    fn at_first<N: Normal>(&self, alone: &Alone<'_>, speed: f64, smooth: Sample) -> Sample {
        let share = alone.contact.overlap / (speed * self.time_step);
        let Some(share) = share_of_first(speed, share).filter(|share| *share > 0.0) else {
            return smooth;
        };
        let (force, dissipation) = if smooth.law.damping == 0.0 {
            (smooth.law.elastic * weight(N::ELASTIC_POWER, share), 0.0)
        } else {
            let beginning = self.beginning(alone, speed, share);
            let force = beginning.first_kick::<N>();
            let stored = beginning.spring_work::<N>(force);
            let power = force * self.mean_speed(force, alone.contact, speed);
            (force, power - stored * self.rate)
        };
        Sample {
            speed,
            applied: NormalForce {
                force,
                dissipation,
                ..smooth.law
            },
            elapsed: share * self.time_step,
            behind: (weight(N::DAMPING_POWER, share) - 0.5) * self.time_step,
            ..smooth
        }
    }

    /// The second sample of a damped contact.
    fn at_damped_second<N: Normal>(
        &self,
        alone: &Alone<'_>,
        predicted_speed: f64,
        smooth: Sample,
    ) -> Sample {
        let [speed, between] = self.last_speeds(alone, predicted_speed);
        let share = (alone.contact.overlap / self.time_step - between) / speed;
        let Some(share) = share_of_first(speed, share) else {
            return smooth;
        };
        let force = self.beginning(alone, speed, share).second_kick::<N>();
        // What else met the bodies since may have made another beginning of it; no law that ends at zero pulls.
        if force < 0.0 && N::ENDS_AT_ZERO {
            return smooth;
        }
        self.kicked(force, alone.contact, between, smooth)
    }

    /// The last sample of an elastic contact.
    ///
    /// Weights at both ends make a contact the same forward and backward in time, and its energy has no drift.
    fn at_elastic_last<N: Normal>(&self, contact: &Contact, smooth: Sample) -> Sample {
        let law = &smooth.law;
        // The bodies part at the speed that this sample leaves them with.
        let parting = smooth.speed - self.completion * law.elastic * contact.inverse_mass;
        let share = law.elastic_overlap / (-parting * self.time_step);
        if !smooth.ends || share >= 1.0 {
            return smooth;
        }
        Sample {
            applied: NormalForce {
                force: law.elastic * weight(N::ELASTIC_POWER, share),
                ..*law
            },
            ..smooth
        }
    }

    /// The last sample of a damped contact, which is followed from the sample before.
    fn at_damped_last<N: Normal>(
        &self,
        alone: &Alone<'_>,
        predicted_speed: f64,
        smooth: Sample,
    ) -> Sample {
        let inverse_mass = alone.contact.inverse_mass;
        let [before, between] = self.last_speeds(alone, predicted_speed);
        let last = Motion {
            overlap: alone.contact.overlap - self.time_step * between,
            speed: f64::midpoint(before, between),
        };
        let at_last = Contact {
            overlap: last.overlap,
            ..*alone.contact
        };
        let law = self.softened(alone.force::<N>(last), inverse_mass);
        let from = self.true_motion::<N>(&at_last, last.speed, &law);
        match release::speed_at_release::<N>(alone, from, self.time_step) {
            Some(speed) => {
                let force = ((between - speed) * self.rate / inverse_mass).max(0.0);
                self.kicked(force, alone.contact, between, smooth)
            }
            None => smooth,
        }
    }

    fn beginning<'a>(&self, alone: &Alone<'a>, speed: f64, share: f64) -> Beginning<'a> {
        Beginning {
            alone: *alone,
            speed,
            share,
            time_step: self.time_step,
        }
    }

    /// Speeds of approach half a step before the last sample, and half a step after it [m/s].
    fn last_speeds(&self, alone: &Alone<'_>, predicted_speed: f64) -> [f64; 2] {
        let slowing = self.time_step * alone.history.normal_force * alone.contact.inverse_mass;
        let between = predicted_speed + 0.5 * slowing;
        [between + slowing, between]
    }

    /// A sample of a force that stands for the step [N], at the speed [m/s] before it.
    fn kicked(&self, force: f64, contact: &Contact, speed: f64, smooth: Sample) -> Sample {
        let of_damping = force - smooth.law.elastic;
        Sample {
            applied: NormalForce {
                force,
                dissipation: of_damping * self.mean_speed(force, contact, speed),
                ..smooth.law
            },
            ..smooth
        }
    }

    /// Mean of the speeds before and after a kick [m/s]: times its impulse, it is the work.
    fn mean_speed(&self, force: f64, contact: &Contact, speed: f64) -> f64 {
        speed - self.completion * force * contact.inverse_mass
    }
}

/// Time from first touch to the first sample over a step [-], of bodies that arrive at a speed [m/s]; none where they have
/// not touched first in that step, or nearly so.
fn share_of_first(speed: f64, share: f64) -> Option<f64> {
    let is_near = speed > 0.0 && (share - 0.5).abs() <= 1.0;
    is_near.then(|| share.clamp(0.0, 1.0))
}

/// What a sample at `share` of a step from where `F ∝ sᵖ` begins is multiplied by, so that the sum is the integral [-].
fn weight(power: f64, share: f64) -> f64 {
    minus_zeta(power, 1.0 + share) / share.powf(power)
}

/// Hurwitz's zeta function `−ζ(−p, a)` for p in \[0, 2\] and a of at least 1 [-], by Euler and Maclaurin's sum.
fn minus_zeta(power: f64, from: f64) -> f64 {
    const TERMS: i32 = 6;
    let head: f64 = (0..TERMS)
        .map(|term| (from + f64::from(term)).powf(power))
        .sum();
    let tail = from + f64::from(TERMS);
    let p = power;
    let at_tail = tail.powf(p);
    // Bernoulli's numbers over factorials: 1/12, −1/720, 1/30240.
    let corrections = p / (12.0 * tail) - p * (p - 1.0) * (p - 2.0) / (720.0 * tail.powi(3))
        + p * (p - 1.0) * (p - 2.0) * (p - 3.0) * (p - 4.0) / (30_240.0 * tail.powi(5));
    at_tail * (tail / (p + 1.0) - 0.5 + corrections) - head
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_zeta_function_has_its_known_values() {
        // ζ(−p, a): Bernoulli polynomials for whole p; ζ(−1.5) and ζ(−0.25) of Riemann for a = 1.
        let known = [
            (0.0, 1.3, 0.8),
            (1.0, 1.3, 0.5 * (1.3 * 0.3 + 1.0 / 6.0)),
            (1.5, 1.0, 0.025_485_201_889_833_036),
            (0.25, 1.0, 0.320_451_264_228_577_3),
        ];
        for (power, from, expected) in known {
            let found = minus_zeta(power, from);
            assert!(
                (found - expected).abs() < 1.0e-9,
                "{power}, {from}: {found}"
            );
        }
    }

    #[test]
    fn a_weighed_sum_of_a_power_is_its_integral_wherever_it_begins() {
        // Beyond the first sample the sum has only the error of its far end, which Euler and Maclaurin give.
        for power in [0.25, 1.5] {
            for share in [1.0e-6, 0.2, 0.5, 0.9, 1.0] {
                let at = |sample: i32| (share + f64::from(sample)).powf(power);
                let last = 400;
                let end = share + f64::from(last);
                let sum: f64 =
                    weight(power, share) * at(0) + (1..last).map(at).sum::<f64>() + 0.5 * at(last)
                        - power * end.powf(power - 1.0) / 12.0;
                let integral = end.powf(power + 1.0) / (power + 1.0);
                assert!(
                    (sum - integral).abs() < 1.0e-8 * integral,
                    "{power}, {share}: {sum} for {integral}"
                );
            }
        }
    }
}
