//! Impacts on one wall, patch by patch.

use super::patch::{self, PatchTable, Patches};
use super::touch::WallTouch;
use super::{Instrument, Values, Watched};
use crate::ledger::MOST_COUNTED;
use crate::model::Model;
use crate::setup::Setup;
use crate::state::State;
use serde::{Deserialize, Serialize};

/// Impacts on one wall and their energy, patch by patch.
///
/// An impact is a contact from first touch to release. It counts at first touch, by the motion of the pellet's center
/// relative to the wall's surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallImpacts {
    /// Index of the wall [-].
    pub wall: usize,
    /// Width of the patches [m].
    pub cell: f64,
    /// Speed of approach, along the normal, up to which a touch is no impact [m/s].
    pub least_speed: f64,
}

/// Impacts of one patch or of all.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Impacts {
    count: u64,
    /// Of the motion along the normal [J].
    normal_energy: f64,
    /// Of the motion along the surface [J].
    tangential_energy: f64,
    /// Of the fastest [m/s].
    greatest_speed: f64,
}

impl Impacts {
    fn add(&mut self, touch: &WallTouch) {
        let (approach, along) = (touch.approach_speed(), touch.tangential_speed());
        self.count += 1;
        self.normal_energy += 0.5 * touch.mass() * approach.powi(2);
        self.tangential_energy += 0.5 * touch.mass() * along.powi(2);
        self.greatest_speed = self.greatest_speed.max(approach);
    }

    fn energy(&self) -> f64 {
        self.normal_energy + self.tangential_energy
    }

    fn values(&self) -> Values {
        vec![
            ("impacts", self.count as f64),
            ("normal_energy_j", self.normal_energy),
            ("tangential_energy_j", self.tangential_energy),
            ("greatest_speed_m_per_s", self.greatest_speed),
        ]
    }
}

impl Instrument for WallImpacts {
    type Record = (Impacts, Patches<Impacts>);

    const NAME: &'static str = "wall-impacts";

    fn fits(&self, (all, patches): &Self::Record, _pellets: usize) -> bool {
        let mut received = patches.iter().chain([all]);
        received.all(|impacts| impacts.count <= MOST_COUNTED)
    }

    fn mistakes(&self, setup: &Setup) -> Vec<(&'static str, String)> {
        let mut mistakes = super::unknown("wall", self.wall, setup.walls.len());
        mistakes.extend(patch::mistakes(self.cell));
        if !(self.least_speed.is_finite() && self.least_speed >= 0.0) {
            let message = format!("is {} m/s; expected 0 or more", self.least_speed);
            mistakes.push(("least_speed", message));
        }
        mistakes
    }

    fn wall(&self) -> Option<usize> {
        Some(self.wall)
    }

    fn watch(&self, (all, patches): &mut Self::Record, step: &Watched) {
        let pose = &step.walls[self.wall].pose;
        for touch in step.touches_of(self.wall) {
            if touch.is_first && touch.approach_speed() > self.least_speed {
                all.add(touch);
                patches.at(touch, self.cell, pose).add(touch);
            }
        }
    }

    fn values(&self, (all, _): &Self::Record, _model: &Model, _state: &State) -> Values {
        all.values()
    }

    fn patches(&self, (_, patches): &Self::Record) -> Option<PatchTable> {
        Some(patches.table(self.cell, Impacts::energy, Impacts::values))
    }
}
