//! The motion along the normal, by an error-controlled solver.

use crate::ImpactError;
use crate::damping::Law;
use differential_equations::ode::OrdinaryNumericalMethod;
use differential_equations::prelude::{
    ControlFlag, Error, ExplicitRungeKutta, IVP, Interpolation, ODE, Solout, Solution, Status,
};

/// Relative error of one step of the solver [-]; the whole hit is then right to about 1e-7 (tested).
const STEP_ERROR: f64 = 1.0e-13;

/// Longest hit that is followed, in the times of the hit; an elastic one takes 3.2 [-].
const LONGEST: f64 = 1.0e4;

/// Steps of the solver; a hit takes about 100 [-].
const MOST_STEPS: usize = 200_000;

/// Overlap and the rate at which it grows.
type Motion = [f64; 2];

/// A moment of a hit, in its own lengths and times.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moment {
    pub(crate) time: f64,
    pub(crate) overlap: f64,
    pub(crate) rate: f64,
}

/// A hit along the normal, in its own lengths and times.
#[derive(Debug)]
pub(crate) struct HeadOn {
    law: Law,
    pub(crate) deepest: Moment,
    pub(crate) hardest: Moment,
    pub(crate) release: Moment,
}

impl HeadOn {
    pub(crate) fn new(law: Law) -> Result<Self, ImpactError> {
        Ok(Self {
            law,
            deepest: until(law, |_, _, rate| rate)?,
            hardest: until(law, Law::growth)?,
            release: until(law, Law::release)?,
        })
    }

    pub(crate) fn force(&self, moment: &Moment) -> f64 {
        self.law.force(moment.overlap, moment.rate)
    }

    /// The motion at evenly spaced times, first touch and release among them.
    pub(crate) fn moments(&self, intervals: usize) -> Result<Vec<Moment>, ImpactError> {
        let step = self.release.time / intervals as f64;
        let times: Vec<f64> = (1..intervals).map(|index| index as f64 * step).collect();
        let solution = IVP::ode(&Motions(self.law), 0.0, self.release.time, START)
            .t_eval(times)
            .method(method())
            .solve()
            .map_err(|error| no_release(&error))?;
        let first = Moment {
            time: 0.0,
            overlap: START[0],
            rate: START[1],
        };
        let between = solution.iter().map(|(&time, &[overlap, rate])| Moment {
            time,
            overlap,
            rate,
        });
        Ok(std::iter::once(first)
            .chain(between)
            .chain([self.release])
            .collect())
    }
}

/// First touch at unit speed.
const START: Motion = [0.0, 1.0];

/// The equation of motion.
struct Motions(Law);

impl ODE<f64, Motion> for Motions {
    fn diff(&self, _time: f64, &[overlap, rate]: &Motion, change: &mut Motion) {
        *change = [rate, -self.0.force(overlap, rate)];
    }
}

/// Looks for the moment when something falls through zero, and ends there.
///
/// The solver's own events stop up to 5e-5 short of the root; halving the step that holds it goes to the last bit.
struct Fall {
    law: Law,
    falling: fn(Law, f64, f64) -> f64,
}

impl Solout<f64, Motion> for Fall {
    fn solout<I>(
        &mut self,
        time: f64,
        previous_time: f64,
        motion: &Motion,
        _previous: &Motion,
        interpolator: &mut I,
        solution: &mut Solution<f64, Motion>,
    ) -> ControlFlag<f64, Motion>
    where
        I: Interpolation<f64, Motion> + ?Sized,
    {
        let is_past = |motion: &Motion| (self.falling)(self.law, motion[0], motion[1]) < 0.0;
        if !is_past(motion) {
            return ControlFlag::Continue;
        }
        let (mut before, mut after) = (previous_time, time);
        let mut found = *motion;
        // A double has 53 bits.
        for _ in 0..53 {
            let middle = f64::midpoint(before, after);
            match interpolator.interpolate(middle) {
                Ok(motion) if is_past(&motion) => (after, found) = (middle, motion),
                Ok(_) => before = middle,
                Err(_) => break,
            }
        }
        solution.push(after, found);
        ControlFlag::Terminate
    }
}

/// Dormand and Prince's method of order 8 with dense output.
fn method() -> impl OrdinaryNumericalMethod<f64, Motion> + Interpolation<f64, Motion> {
    ExplicitRungeKutta::dop853()
        .rtol(STEP_ERROR)
        .atol(0.01 * STEP_ERROR)
        .max_steps(MOST_STEPS)
}

fn until(law: Law, falling: fn(Law, f64, f64) -> f64) -> Result<Moment, ImpactError> {
    let solution = IVP::ode(&Motions(law), 0.0, LONGEST, START)
        .method(method())
        .solout(Fall { law, falling })
        .solve()
        .map_err(|error| no_release(&error))?;
    match (&solution.status, solution.last()) {
        (Status::Interrupted, Ok((&time, &[overlap, rate]))) => Ok(Moment {
            time,
            overlap,
            rate,
        }),
        _ => Err(ImpactError::NoRelease {
            reason: format!(
                "nothing within {LONGEST:e} times the length of the hit over its speed"
            ),
        }),
    }
}

fn no_release(error: &Error<f64, Motion>) -> ImpactError {
    ImpactError::NoRelease {
        reason: format!("{error:?}"),
    }
}
