//! One hard case: a scene, how long it runs, and what it must show.

use crate::common::simulation;
use pelletflow::sim::{PelletView, Setup, Simulation, StepError, StepRequest};

/// Share of the energy that went through the ledger, of which more than this missed is a break [-]: a tenth of what stops
/// a run by default.
const MISSED_ENERGY: f64 = 0.02;

/// A hard case.
pub(crate) struct Case {
    /// What is hard about it.
    pub(crate) name: &'static str,
    /// The scene, with the step of the default.
    pub(crate) setup: fn() -> Setup,
    /// Simulated time of a whole run [s].
    pub(crate) time: f64,
    /// Share of that time that a quick run takes [-].
    pub(crate) quick: f64,
    /// What a run that went to its end must show, or what of that broke.
    pub(crate) holds: fn(&Course) -> Result<(), String>,
}

/// A run that went to its end, its pellets in the order of their numbers.
pub(crate) struct Course {
    pub(crate) start: Vec<PelletView>,
    pub(crate) middle: Vec<PelletView>,
    pub(crate) end: Vec<PelletView>,
    pub(crate) simulation: Simulation,
}

/// A step and what came of it.
pub(crate) struct Trial {
    /// The step [s].
    pub(crate) step: f64,
    /// Time of the shortest contact expected, by Hertz [s].
    pub(crate) contact_time: f64,
    /// What broke, if anything did.
    pub(crate) broke: Option<String>,
}

impl Case {
    /// Runs a share of the case's time [-], with the default step times a factor [-].
    pub(crate) fn run(&self, share: f64, factor: f64) -> Trial {
        let simulation = self.started(factor);
        let time_step = simulation.model().time_step();
        let (step, contact_time) = (time_step.seconds, time_step.shortest_contact);
        let half = (0.5 * share * self.time / step).ceil() as u64;
        let broke = match Course::of(simulation, half) {
            Ok(course) => (self.holds)(&course).and(course.missed_energy()).err(),
            Err(error) => Some(kind_of(&error).into()),
        };
        Trial {
            step,
            contact_time,
            broke,
        }
    }

    /// The case before its first step, which is the default times a factor [-].
    pub(crate) fn started(&self, factor: f64) -> Simulation {
        let mut setup = (self.setup)();
        if factor != 1.0 {
            let default = simulation(setup.clone()).model().time_step().seconds;
            setup.step = StepRequest::Unchecked(factor * default);
        }
        simulation(setup)
    }
}

impl Course {
    fn of(mut simulation: Simulation, half: u64) -> Result<Self, StepError> {
        let start = by_number(&simulation);
        simulation.advance(half)?;
        let middle = by_number(&simulation);
        simulation.advance(half)?;
        Ok(Self {
            start,
            middle,
            end: by_number(&simulation),
            simulation,
        })
    }

    /// Fails where contacts have made or lost more energy than they may.
    fn missed_energy(&self) -> Result<(), String> {
        let energy = self.simulation.energy_ledger();
        let missed = energy.residual / energy.throughput;
        expect(missed.abs() < MISSED_ENERGY, || {
            format!("energy {:+.0} %", 100.0 * missed)
        })
    }
}

/// The pellets in the order of their numbers.
pub(crate) fn by_number(simulation: &Simulation) -> Vec<PelletView> {
    let mut pellets: Vec<_> = simulation.pellets().collect();
    pellets.sort_by_key(|pellet| pellet.id);
    pellets
}

/// What stopped a run, in a word or two.
fn kind_of(error: &StepError) -> &'static str {
    match error {
        StepError::NotFinite { .. } => "not finite",
        StepError::StepTooLarge { .. } => "too fast",
        StepError::Overlap { .. } => "overlap",
        StepError::Lost { .. } => "lost a pellet",
        StepError::Energy { .. } => "energy",
        StepError::GateClosed { .. } => "gate",
        _ => "feeder",
    }
}

/// Every pellet is inside the domain, also one that has moved since the last search for neighbors.
pub(crate) fn holds_its_pellets(course: &Course) -> Result<(), String> {
    let bounds = course.simulation.model().setup().domain.bounds;
    let is_inside = |pellet: &PelletView| {
        (0..3).all(|axis| {
            let along = pellet.position[axis];
            along >= bounds.min[axis] && along <= bounds.max[axis]
        })
    };
    let is_whole = course.end.len() == course.start.len() && course.end.iter().all(is_inside);
    expect(is_whole, || "lost a pellet".into())
}

/// Fails with a word where something does not hold.
pub(crate) fn expect(holds: bool, broken: impl Fn() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(broken()) }
}
