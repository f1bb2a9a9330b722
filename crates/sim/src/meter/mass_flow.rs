//! Mass discharged through one outlet, and its rate.

use super::{Instrument, Values, averaged};
use crate::model::Model;
use crate::setup::Setup;
use crate::state::State;

/// Mass discharged through one outlet, and its rate; the books hold all of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MassFlow {
    /// Index of the outlet [-].
    pub outlet: usize,
}

impl Instrument for MassFlow {
    type Record = ();

    const NAME: &'static str = "mass-flow";

    fn mistakes(&self, setup: &Setup) -> Vec<(&'static str, String)> {
        super::unknown("outlet", self.outlet, setup.outlets.len())
    }

    fn values(&self, (): &(), model: &Model, state: &State) -> Values {
        let books = &state.books;
        let since = state.steps_since_search as f64 * model.time_step().seconds;
        let tally = &books.by_outlet[self.outlet];
        vec![
            (
                "mass_flow_kg_per_s",
                averaged(books.outlet_flow[self.outlet], 0.0, since),
            ),
            ("mass_kg", tally.mass),
            ("pellets", tally.count as f64),
        ]
    }
}
