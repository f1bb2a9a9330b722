//! Run time against error: one scene over step sizes and integrators.
//!
//! Errors are held against values known exactly where the caller has them, and otherwise against the finest run.
//! Where a nudge of a billionth grows a thousandfold by the end, single runs say nothing: then each case is run with
//! several seeds, and the error is that of the mean, with its confidence interval.

mod trial;

pub use trial::{Estimate, Trial};

use pelletflow_sim::{Integrator, Setup, SetupError, StepError};
use statrs::distribution::{ContinuousCDF, StudentsT};
use statrs::statistics::Statistics;
use std::ops::ControlFlow;
use trial::{Outcome, run};

/// What to compare.
#[derive(Debug, Clone, PartialEq)]
pub struct AccuracyRequest<'a> {
    /// The scene.
    pub setup: &'a Setup,
    /// Simulated time of each run [s].
    pub end_time: f64,
    /// Integrators to compare.
    pub integrators: Vec<Integrator>,
    /// Steps per contact of the fastest hit expected [-].
    pub steps_per_contact: Vec<f64>,
    /// Runs per case where the flow is chaotic, 2 or more [-].
    pub repeats: u32,
    /// Threads of each run [-].
    pub threads: usize,
    /// Values known exactly, by key of the summary, each in the unit of its key.
    pub exact: Vec<(String, f64)>,
}

/// What the errors are held against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reference {
    /// A run of the finest step over two.
    FinestRun {
        /// Its step [s].
        time_step: f64,
    },
    /// The mean of runs with other seeds at the finest step.
    MeanOfSeeds {
        /// Their step [s].
        time_step: f64,
        /// How many [-].
        runs: u32,
    },
}

/// A scene over step sizes and integrators.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// What the errors are held against.
    pub reference: Reference,
    /// How many times a nudge of gravity had grown at the end [-].
    pub growth: f64,
    /// Keys of the quantities compared, in the order of every trial's errors.
    pub quantities: Vec<String>,
    /// Keys of those that were held against an exact value.
    pub exact: Vec<String>,
    /// The runs, integrator by integrator, the coarsest step first.
    pub trials: Vec<Trial>,
}

/// A study that says nothing.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AccuracyError {
    /// The scene itself is not valid.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Setup(Vec<SetupError>),
    /// Every step asked for is too large.
    #[error("every step asked for is refused: {0}; ask for more steps per contact")]
    TooCoarse(SetupError),
    /// The reference run failed.
    #[error("the reference run failed: {0}")]
    Reference(StepError),
    /// Nothing touches.
    #[error(
        "nothing touches before {end_time} s, so that runs differ by rounding alone; let the scene run longer"
    )]
    NoContact {
        /// Simulated time of the runs [s].
        end_time: f64,
    },
    /// A quantity that has an exact value is none that can be compared.
    #[error(
        "`{key}` has an exact value and is no quantity of the comparison; expected one of {known}"
    )]
    UnknownQuantity {
        /// The key.
        key: String,
        /// The keys there are.
        known: String,
    },
    /// The caller broke off.
    #[error("interrupted")]
    Interrupted,
}

/// How far a study is: cases done and cases in all.
pub type StudyObserver<'a> = dyn FnMut(usize, usize) -> ControlFlow<()> + 'a;

/// Growth of a nudge above which a flow counts as chaotic [-].
const CHAOTIC_GROWTH: f64 = 1.0e3;
/// Share of gravity by which a run is nudged [-].
const NUDGE: f64 = 1.0e-9;
/// Share of confidence intervals [-].
const CONFIDENCE: f64 = 0.95;
/// Seeds of the reference follow those of the trials at this distance [-].
const REFERENCE_SEED: u64 = 1000;

impl Study {
    /// Runs the comparison; the observer is called after each case and may break it off.
    ///
    /// # Errors
    /// The scene is not valid, nothing can be compared, or the reference failed. A trial that fails is left out.
    pub fn run(
        request: &AccuracyRequest,
        observer: &mut StudyObserver,
    ) -> Result<Self, AccuracyError> {
        let shortest = trial::shortest_contact(request.setup)?;
        let finest = shortest
            / request
                .steps_per_contact
                .iter()
                .copied()
                .fold(1.0, f64::max);
        let cases = request.integrators.len() * request.steps_per_contact.len() + 2;
        let mut done = 0;
        let mut advance = || {
            done += 1;
            match observer(done, cases) {
                ControlFlow::Continue(()) => Ok(()),
                ControlFlow::Break(()) => Err(AccuracyError::Interrupted),
            }
        };

        let reference_run = |setup: &Setup, step| {
            run(setup, Integrator::LocatedVerlet, step, request).map_err(|error| match error {
                trial::Failure::Setup(error) => AccuracyError::TooCoarse(error),
                trial::Failure::Step(error) => AccuracyError::Reference(error),
            })
        };
        let base = reference_run(request.setup, finest / 2.0)?;
        if base.contact_steps == 0 {
            return Err(AccuracyError::NoContact {
                end_time: request.end_time,
            });
        }
        advance()?;
        let mut nudged = request.setup.clone();
        nudged.gravity *= 1.0 + NUDGE;
        let growth = growth(request, &base, &reference_run(&nudged, finest / 2.0)?);
        advance()?;

        let is_chaotic = growth > CHAOTIC_GROWTH;
        let (reference, runs) = if is_chaotic {
            let runs = (0..request.repeats)
                .map(|run| reference_run(&seeded(request.setup, REFERENCE_SEED, run), finest))
                .collect::<Result<Vec<_>, _>>()?;
            let reference = Reference::MeanOfSeeds {
                time_step: finest,
                runs: request.repeats,
            };
            (reference, runs)
        } else {
            let reference = Reference::FinestRun {
                time_step: finest / 2.0,
            };
            (reference, vec![base])
        };
        let scale = Scale::new(request, runs, is_chaotic)?;

        let mut trials = Vec::new();
        let mut refusal = None;
        for &integrator in &request.integrators {
            for &steps in &request.steps_per_contact {
                let repeats = if is_chaotic { request.repeats } else { 1 };
                let outcomes: Result<Vec<_>, _> = (0..repeats)
                    .map(|repeat| {
                        let setup = seeded(request.setup, 0, repeat);
                        run(&setup, integrator, shortest / steps, request)
                    })
                    .collect();
                match outcomes {
                    Ok(outcomes) => trials.push(Trial::new(
                        integrator,
                        shortest / steps,
                        steps,
                        &outcomes,
                        |outcomes| scale.errors(outcomes),
                    )),
                    Err(trial::Failure::Setup(error)) => refusal = Some(error),
                    // A step at which the physics fails is no candidate.
                    Err(trial::Failure::Step(_)) => {}
                }
                advance()?;
            }
        }
        match refusal {
            Some(error) if trials.is_empty() => Err(AccuracyError::TooCoarse(error)),
            _ => Ok(Self {
                reference,
                growth,
                quantities: scale.keys.clone(),
                exact: request.exact.iter().map(|(key, _)| key.clone()).collect(),
                trials,
            }),
        }
    }

    /// The trial of the fewest steps whose errors are all within a share, interval included [-].
    pub fn recommended(&self, error: f64) -> Option<&Trial> {
        self.trials
            .iter()
            .filter(|trial| trial.worst() <= error)
            .min_by_key(|trial| trial.steps)
    }
}

fn seeded(setup: &Setup, offset: u64, repeat: u32) -> Setup {
    Setup {
        seed: setup.seed.wrapping_add(offset + u64::from(repeat)),
        ..setup.clone()
    }
}

/// How many times a nudge has grown beyond what it moves a pellet in free fall.
fn growth(request: &AccuracyRequest, base: &Outcome, nudged: &Outcome) -> f64 {
    let fall = 0.5 * request.setup.gravity.norm() * request.end_time * request.end_time;
    let Some(distance) = base.distance(nudged) else {
        return f64::INFINITY;
    };
    if fall > 0.0 {
        distance / (NUDGE * fall)
    } else {
        0.0
    }
}

/// What errors are held against and measured by.
struct Scale {
    keys: Vec<String>,
    /// By quantity.
    values: Vec<Mean>,
    /// The single run whose places count, where the flow is not chaotic.
    places: Option<Outcome>,
}

/// Key of the places at the end; all others are keys of the summary.
const PLACES: &str = "places";

impl Scale {
    fn new(
        request: &AccuracyRequest,
        runs: Vec<Outcome>,
        is_chaotic: bool,
    ) -> Result<Self, AccuracyError> {
        if let Some((key, _)) = request
            .exact
            .iter()
            .find(|(key, _)| !trial::KEYS.contains(&key.as_str()))
        {
            return Err(AccuracyError::UnknownQuantity {
                key: key.clone(),
                known: trial::KEYS.join(", "),
            });
        }
        let mut keys = Vec::new();
        let mut values = Vec::new();
        for (place, key) in trial::KEYS.iter().enumerate() {
            let samples: Vec<f64> = runs.iter().map(|run| run.values[place]).collect();
            let known = request.exact.iter().find(|(exact, _)| exact == key);
            let value = known.map_or_else(|| mean(&samples), |&(_, value)| Mean::exact(value));
            // A quantity that is nothing has no relative error.
            if value.value.abs() > f64::MIN_POSITIVE {
                keys.push((*key).to_owned());
                values.push(value);
            }
        }
        let places = runs.into_iter().next().filter(|_| !is_chaotic);
        if places.is_some() {
            keys.push(PLACES.to_owned());
        }
        Ok(Self {
            keys,
            values,
            places,
        })
    }

    /// Errors relative to the reference, by quantity; places relative to a pellet's diameter.
    fn errors(&self, outcomes: &[Outcome]) -> Vec<Estimate> {
        let of_values = self.keys.iter().zip(&self.values).map(|(key, reference)| {
            let place = trial::KEYS.iter().position(|known| known == key);
            let samples: Vec<f64> = outcomes
                .iter()
                .map(|outcome| place.map_or(0.0, |place| outcome.values[place]))
                .collect();
            let found = mean(&samples);
            Estimate {
                value: (found.value - reference.value).abs() / reference.value.abs(),
                half_width: found.half_width.hypot(reference.half_width) / reference.value.abs(),
            }
        });
        let of_places = self.places.iter().zip(outcomes).map(|(places, outcome)| {
            let distance = places.distance(outcome).unwrap_or(f64::INFINITY);
            Estimate {
                value: distance / places.diameter,
                half_width: 0.0,
            }
        });
        of_values.chain(of_places).collect()
    }
}

/// A mean and half the width of its confidence interval, in the unit of the quantity.
pub(crate) struct Mean {
    pub(crate) value: f64,
    pub(crate) half_width: f64,
}

impl Mean {
    fn exact(value: f64) -> Self {
        Self {
            value,
            half_width: 0.0,
        }
    }
}

/// The mean of samples with its confidence interval, by Student's t.
pub(crate) fn mean(samples: &[f64]) -> Mean {
    let value = samples.mean();
    let count = samples.len() as f64;
    let half_width = StudentsT::new(0.0, 1.0, count - 1.0).map_or(0.0, |student| {
        student.inverse_cdf(0.5 * (1.0 + CONFIDENCE)) * samples.std_dev() / count.sqrt()
    });
    Mean { value, half_width }
}
