//! What was left out of a run because it changes nothing, and what that saved.

use crate::model::Model;
use crate::state::State;
use crate::workspace::Workspace;
use pelletflow_core::contact::{TangentialLaw, TurningLaw};

/// Work that was left out.
#[derive(Debug, Clone, PartialEq)]
pub struct Skipped {
    /// What was skipped.
    pub what: &'static str,
    /// Why it could be.
    pub reason: String,
    /// What it saved, in words with a number.
    pub saved: String,
}

/// Everything left out so far.
pub(crate) fn list(model: &Model, state: &State, workspace: &Workspace) -> Vec<Skipped> {
    let setup = model.setup();
    let laws = &setup.laws;
    let mut skipped = Vec::new();
    if !model.has_rotation() {
        skipped.push(Skipped {
            what: "rotation",
            reason: "no tangential and no rolling law turns a pellet".into(),
            saved: format!("spin of {} pellet-steps", state.books.particle_steps),
        });
    }
    if laws.tangential == TangentialLaw::None {
        skipped.push(Skipped {
            what: "tangential history",
            reason: "the tangential law is `none`".into(),
            saved: format!(
                "friction of {} contact-steps",
                state.books.contacts.contact_steps
            ),
        });
    }
    if laws.rolling == TurningLaw::None {
        skipped.push(Skipped {
            what: "rolling resistance",
            reason: "the rolling law is `none`".into(),
            saved: format!(
                "rolling torque of {} contact-steps",
                state.books.contacts.contact_steps
            ),
        });
    }
    if laws.twisting == TurningLaw::None {
        skipped.push(Skipped {
            what: "twisting resistance",
            reason: "the twisting law is `none`".into(),
            saved: format!(
                "twisting torque of {} contact-steps",
                state.books.contacts.contact_steps
            ),
        });
    }
    if setup.pellets.len() == 1 {
        skipped.push(Skipped {
            what: "pair table",
            reason: "all pellets are of one kind".into(),
            saved: format!(
                "two look-ups in {} contact-steps",
                state.books.contacts.contact_steps
            ),
        });
    }
    if setup.skips.distant_walls && !setup.walls.is_empty() && !state.pellets.is_empty() {
        let all = state.pellets.len() * setup.walls.len();
        // A wall that is touched at several places is listed once for each.
        let near: usize = workspace
            .lists
            .iter()
            .map(|list| list.near_walls.chunk_by(PartialEq::eq).count())
            .sum();
        skipped.push(Skipped {
            what: "distant walls",
            reason: "a wall is evaluated only within reach of the neighbor list".into(),
            saved: format!(
                "{:.1} % of the wall distances, at the end",
                100.0 * (1.0 - near as f64 / all as f64)
            ),
        });
    }
    if workspace.free_steps > 0 {
        skipped.push(Skipped {
            what: "contacts in free flight",
            reason: "no pellet was near anything".into(),
            saved: format!(
                "contacts of {} of {} steps",
                workspace.free_steps, state.step
            ),
        });
    }
    skipped
}
