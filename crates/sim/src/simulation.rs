//! Model, state and workspace together.

use crate::books::Books;
use crate::contact_view::ContactView;
use crate::error::{SetupError, StepError};
use crate::fill;
use crate::hash;
use crate::hit::{self, Hit, HitLedger};
use crate::inlet;
use crate::ledger::{ContactStatistics, EnergyLedger, MassLedger, PelletTally};
use crate::meter::{self, MeterReading, PatchTable};
use crate::model::Model;
use crate::pellet::PelletView;
use crate::profile::Stage;
use crate::skipped::{self, Skipped};
use crate::state::{State, vector};
use crate::step::{prescribe_walls, step};
use crate::workspace::Workspace;
use pelletflow_core::Pose;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// A run in memory.
#[derive(Debug)]
pub struct Simulation {
    model: Model,
    state: State,
    workspace: Workspace,
    /// Threads; none where one is enough.
    pool: Option<ThreadPool>,
    /// Whether somebody looks at contacts.
    shows_contacts: bool,
}

/// A wall at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallView {
    /// Index of the wall in the setup [-].
    pub index: usize,
    /// Where it is: `world_from_body`.
    pub pose: Pose,
    /// Whether it is there.
    pub is_present: bool,
}

/// Wall-clock time of one part of the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// Which part.
    pub name: &'static str,
    /// Time spent so far [s].
    pub seconds: f64,
}

impl Simulation {
    /// Places the fills and readies the first step; `threads` of 0 means one per core [-].
    ///
    /// # Errors
    /// Every fill that does not fit, with its key; or threads that the system refuses.
    pub fn new(model: Model, threads: usize) -> Result<Self, Vec<SetupError>> {
        let pool = start_threads(threads).map_err(|error| {
            vec![SetupError::new(
                "threads",
                format!("{threads} threads cannot be started: {error}; ask for fewer"),
            )]
        })?;
        let mut workspace = Workspace {
            is_parallel: pool.is_some(),
            ..Workspace::default()
        };
        prescribe_walls(&model, 0.0, &mut workspace.walls);
        let mut state = State {
            books: Books::new(&model),
            meters: meter::records(&model),
            ..State::default()
        };
        for pellet in fill::place(&model, &workspace.walls)? {
            inlet::insert(&model, &mut state, &pellet);
        }
        Ok(Self {
            model,
            state,
            workspace,
            pool,
            shows_contacts: false,
        })
    }

    /// Advances by one time step.
    ///
    /// # Errors
    /// The physics failed; the run cannot go on.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.advance(1)
    }

    /// Advances by a number of time steps; several at once spare the threads a wake-up each [-].
    ///
    /// # Errors
    /// The physics failed; the run cannot go on.
    pub fn advance(&mut self, steps: u64) -> Result<(), StepError> {
        let Self {
            model,
            state,
            workspace,
            pool,
            shows_contacts,
        } = self;
        let run = || {
            for chunk in &mut workspace.chunks {
                chunk.kept.clear();
            }
            let mut left = steps;
            while left > 0 {
                workspace.keeps_contacts = *shows_contacts && left == 1;
                left -= step(model, state, workspace, left)?;
            }
            // Of steps in free flight too: there are none.
            workspace.keeps_contacts = *shows_contacts && steps > 0;
            Ok(())
        };
        let outcome = within(pool.as_ref(), run);
        if outcome.is_err() {
            workspace.keeps_contacts = false;
        }
        outcome
    }

    /// The three owners of data put together.
    pub(crate) fn of_parts(
        model: Model,
        state: State,
        workspace: Workspace,
        pool: Option<ThreadPool>,
    ) -> Self {
        Self {
            model,
            state,
            workspace,
            pool,
            shows_contacts: false,
        }
    }

    /// The scratch.
    pub(crate) fn workspace(&self) -> &Workspace {
        &self.workspace
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        self.state.step as f64 * self.model.time_step().seconds
    }

    /// Steps taken [-].
    pub fn step_count(&self) -> u64 {
        self.state.step
    }

    /// Threads at work [-].
    pub fn threads(&self) -> usize {
        self.pool
            .as_ref()
            .map_or(1, ThreadPool::current_num_threads)
    }

    /// Pellets inside [-].
    pub fn pellet_count(&self) -> usize {
        self.state.pellets.len()
    }

    /// Pellets inside, in storage order, which changes; sort by id where order matters.
    pub fn pellets(&self) -> impl ExactSizeIterator<Item = PelletView> + '_ {
        let pellets = &self.state.pellets;
        (0..pellets.len()).map(move |index| PelletView {
            id: pellets.id[index],
            kind: usize::from(pellets.kind[index]),
            radius: pellets.position[index][3],
            mass: pellets.mass(index),
            position: vector(&pellets.position[index]),
            velocity: vector(&pellets.velocity[index]),
            spin: vector(&pellets.spin[index]),
            max_normal_force: self.workspace.load(index, pellets.len()).force[3],
        })
    }

    /// Has the last step of each [`advance`](Self::advance) keep its contacts from now on, or no more.
    pub fn show_contacts(&mut self, is_shown: bool) {
        self.shows_contacts = is_shown;
    }

    /// Contacts as the last step found them, before it moved the pellets, each pair of pellets once; in storage order,
    /// which changes: sort them by [`ContactView::by_number`] where order matters.
    ///
    /// They are not known unless they are [shown](Self::show_contacts), before the first step, and after one that failed.
    pub fn contacts(&self) -> Option<impl Iterator<Item = ContactView> + '_> {
        let kept = self.workspace.chunks.iter().flat_map(|chunk| &chunk.kept);
        let contacts = kept.map(|contact| contact.view(&self.state.pellets.id));
        self.workspace.keeps_contacts.then_some(contacts)
    }

    /// Walls, in the order of the setup.
    pub fn walls(&self) -> impl ExactSizeIterator<Item = WallView> + '_ {
        let time = self.time();
        self.model
            .setup()
            .walls
            .iter()
            .enumerate()
            .map(move |(index, wall)| {
                let now = wall.at(time);
                WallView {
                    index,
                    pose: now.pose,
                    is_present: now.is_present,
                }
            })
    }

    /// Where every pellet went.
    pub fn mass_ledger(&self) -> MassLedger {
        let books = &self.state.books;
        let discharged = books
            .by_outlet
            .iter()
            .fold(PelletTally::default(), |sum, outlet| PelletTally {
                count: sum.count + outlet.count,
                mass: sum.mass + outlet.mass,
            });
        MassLedger {
            inserted: books.inserted,
            inside: books.inside,
            discharged,
            lost: books.lost,
            by_inlet: books.by_inlet.clone(),
            by_outlet: books.by_outlet.clone(),
        }
    }

    /// Where the energy went, at the start of the last step.
    pub fn energy_ledger(&self) -> EnergyLedger {
        let energy = &self.state.books.energy;
        EnergyLedger {
            kinetic: energy.kinetic,
            potential: energy.potential,
            elastic: energy.stored(),
            dissipated: energy.dissipated(),
            carried_in: energy.carried_in,
            wall_work: energy.wall_work,
            residual: energy.residual(),
            throughput: energy.throughput(),
        }
    }

    /// What contacts have done.
    pub fn contact_statistics(&self) -> ContactStatistics {
        self.state.books.contacts
    }

    /// Takes the hits kept in full that have ended since the last call, in the order in which they did.
    ///
    /// Whoever follows hits takes them now and then: until then they are held in memory.
    pub fn take_hits(&mut self) -> Vec<Hit> {
        self.state.hits.take_rows()
    }

    /// The sketch of all hits, those still open told as if they ended now; rows of these alone.
    pub fn hits_with_open(&self) -> HitLedger {
        hit::open(&self.model, &self.state, &self.workspace.lists)
    }

    /// What the meters read, in the order of the setup.
    pub fn meter_readings(&self) -> Vec<MeterReading> {
        meter::readings(&self.model, &self.state)
    }

    /// What each patch of a wall received so far, by name of the meter that keeps patches.
    pub fn patch_tables(&self) -> Vec<(String, PatchTable)> {
        meter::patch_tables(&self.model, &self.state)
    }

    /// Wall-clock time of each part of the step so far.
    pub fn phases(&self) -> Vec<Phase> {
        let profile = &self.workspace.profile;
        Stage::ALL
            .iter()
            .map(|&stage| Phase {
                name: stage.name(),
                seconds: profile.seconds(stage),
            })
            .collect()
    }

    /// Work that was left out so far.
    pub fn skipped(&self) -> Vec<Skipped> {
        skipped::list(&self.model, &self.state, &self.workspace)
    }

    /// Sum of pellets over all steps taken [-].
    pub fn particle_steps(&self) -> u64 {
        self.state.books.particle_steps
    }

    /// Hash of the state in order of pellet number, as 32 hexadecimal digits: equal only for equal bits.
    pub fn state_hash(&self) -> String {
        hash::of(&self.state)
    }
}

/// A pool of a number of threads, 0 meaning one per core; none where that is one.
pub(crate) fn start_threads(threads: usize) -> Result<Option<ThreadPool>, ThreadPoolBuildError> {
    if threads == 1 {
        return Ok(None);
    }
    let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
    Ok((pool.current_num_threads() > 1).then_some(pool))
}

/// Does some work on the threads of a pool, or here where there is none.
pub(crate) fn within<R: Send>(pool: Option<&ThreadPool>, work: impl FnOnce() -> R + Send) -> R {
    match pool {
        Some(pool) => pool.install(work),
        None => work(),
    }
}
