//! All that a restart needs, in the form in which it is written.
//!
//! A run that goes on from a snapshot takes the same steps as one that was never interrupted, to the last bit, on any
//! number of threads. Neighbor lists are no part of it: they follow from where the pellets were at the last search.

mod contacts;
mod fit;

use crate::model::Model;
use crate::neighbors;
use crate::pair_contacts;
use crate::simulation::{Simulation, start_threads, within};
use crate::state::State;
use crate::step::prescribe_walls;
use crate::workspace::Workspace;
use contacts::KeptContacts;
use rayon::ThreadPoolBuildError;
use serde::{Deserialize, Serialize};

/// A simulation between two steps, apart from its model; written and read by any format of serde that keeps every bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// All but the contacts.
    state: State,
    /// Contacts that remember something, chunk by chunk.
    contacts: Vec<KeptContacts>,
    /// Steps taken in free flight [-].
    free_steps: u64,
}

/// A snapshot that a simulation cannot go on from.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RestoreError {
    /// It is of another scene, or damaged.
    #[error("the snapshot does not fit the scene: {0}; take the scene that it was made with")]
    Misfit(String),
    /// The system refuses threads.
    #[error("{threads} threads cannot be started: {source}; ask for fewer")]
    Threads {
        /// Threads asked for [-].
        threads: usize,
        /// Why.
        source: ThreadPoolBuildError,
    },
}

impl Snapshot {
    /// Steps taken [-].
    pub fn step(&self) -> u64 {
        self.state.step
    }

    /// Pellets inside [-].
    pub fn pellet_count(&self) -> usize {
        self.state.pellets.len()
    }
}

impl Simulation {
    /// All that a restart needs, copied.
    pub fn snapshot(&self) -> Snapshot {
        let State {
            step,
            pellets,
            contacts,
            searched_position,
            skin,
            moved_since_search,
            steps_since_search,
            books,
            hits,
            meters,
        } = self.state();
        Snapshot {
            state: State {
                step: *step,
                pellets: pellets.clone(),
                contacts: Vec::new(),
                searched_position: searched_position.clone(),
                skin: *skin,
                moved_since_search: *moved_since_search,
                steps_since_search: *steps_since_search,
                books: books.clone(),
                hits: hits.clone(),
                meters: meters.clone(),
            },
            contacts: contacts.iter().map(KeptContacts::of).collect(),
            free_steps: self.workspace().free_steps,
        }
    }

    /// A simulation that goes on from a snapshot of the same model; `threads` of 0 means one per core [-].
    ///
    /// The forces that pellets show are those of the next step: none before it.
    ///
    /// # Errors
    /// The snapshot is of another scene, or the system refuses threads.
    pub fn restore(model: Model, threads: usize, snapshot: Snapshot) -> Result<Self, RestoreError> {
        let Snapshot {
            mut state,
            contacts,
            free_steps,
        } = snapshot;
        fit::check(&model, &state).map_err(RestoreError::Misfit)?;
        if free_steps > state.step {
            let reason = "it flew for more steps than it took";
            return Err(RestoreError::Misfit(reason.into()));
        }
        let pool =
            start_threads(threads).map_err(|source| RestoreError::Threads { threads, source })?;
        let mut workspace = Workspace {
            is_parallel: pool.is_some(),
            free_steps,
            ..Workspace::default()
        };
        // Walls were where they were when the lists were made.
        let searched_step = state.step - state.steps_since_search;
        let time = searched_step as f64 * model.time_step().seconds;
        prescribe_walls(&model, time, &mut workspace.walls);
        within(pool.as_ref(), || {
            neighbors::list_again(&model, &state, &mut workspace);
        });
        state.contacts = contacts::put_back(&model, &workspace.lists, state.step, contacts)
            .ok_or_else(|| RestoreError::Misfit("it lists other contacts".into()))?;
        pair_contacts::note_lists(&state, &mut workspace);
        Ok(Self::of_parts(model, state, workspace, pool))
    }
}
