//! The skin: how far beyond the bodies the neighbor lists reach.
//!
//! A wide one spares searches, a thin one candidates that do not touch (docs/decisions/0012).

use super::closed_in;
use crate::inlet;
use crate::model::Model;
use crate::state::State;

/// Skin before any motion was seen, over the mean diameter [-].
const FIRST: f64 = 0.1;
/// Thinnest that is chosen, over the same [-].
const THINNEST: f64 = 0.03;
/// Widest that is chosen, over the same [-].
const WIDEST: f64 = 0.4;
/// Steps that a pellet's search costs, in units of what a skin wider by a diameter adds to a step [-].
const SEARCH_COST: f64 = 15.0;
/// Ratio of the skin that would be best to the present one, up to which this is kept [-].
const KEPT: f64 = 1.2;
/// Skin that lasts from one fed pellet to the next, over what the mean motion asks for [-].
const FEED_MARGIN: f64 = 1.25;

/// How the skin is chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SkinChoice {
    /// As the scene says [m].
    Fixed(f64),
    /// By the motion seen.
    Tuned {
        /// Diameter of a pellet of mean volume, of the finest kind: most pairs are of such [m].
        diameter: f64,
        /// Widest that the walls and the box allow, over that diameter [-].
        widest: f64,
    },
}

impl SkinChoice {
    /// By the motion seen, of pellets of a mean diameter [m].
    pub(crate) fn tuned(diameter: f64) -> Self {
        Self::Tuned {
            diameter,
            widest: WIDEST,
        }
    }

    /// The same, never wider than at first.
    pub(crate) fn narrowed(self) -> Self {
        match self {
            Self::Fixed(_) => self,
            Self::Tuned { diameter, .. } => Self::Tuned {
                diameter,
                widest: FIRST,
            },
        }
    }

    /// Before any motion was seen [m]; `held` is the gap up to which bodies hold on to each other [m].
    pub(crate) fn first(self, held: f64) -> f64 {
        match self {
            Self::Fixed(skin) => skin,
            Self::Tuned { diameter, .. } => FIRST * diameter + held,
        }
    }

    /// Widest that may come [m].
    pub(crate) fn widest(self, held: f64) -> f64 {
        match self {
            Self::Fixed(skin) => skin,
            Self::Tuned { diameter, widest } => widest * diameter + held,
        }
    }
}

/// Skin of the lists about to be made [m]: what would have cost least since the last search.
///
/// Over a step, bodies close in on each other by `c`. A skin `s` lasts `s / c` steps, so that a step costs
/// `SEARCH_COST c / s + s / d`, which is least at `s² = SEARCH_COST c d`.
/// It follows from the state alone, so that neither a restart nor the threads change it.
pub(super) fn next(model: &Model, state: &State) -> f64 {
    let (choice, held) = (model.skin_choice(), model.holding_gap());
    let SkinChoice::Tuned { diameter, widest } = choice else {
        return choice.first(held);
    };
    if state.skin == 0.0 {
        return choice.first(held);
    }
    if state.steps_since_search == 0 {
        return state.skin;
    }
    let closing = closed_in(model, state, 0.0, 0) / state.steps_since_search as f64;
    let cheapest = (SEARCH_COST * closing * diameter).sqrt();
    // A fed pellet asks for a search anyway: a skin that lasts longer spares none.
    let fed = FEED_MARGIN * closing * inlet::steps_per_pellet(model, state);
    let best = cheapest
        .min(fed)
        .clamp(THINNEST * diameter, widest * diameter);
    let present = state.skin - held;
    if (present / KEPT..=present * KEPT).contains(&best) {
        state.skin
    } else {
        best + held
    }
}
