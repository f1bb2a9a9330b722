//! The hardest hits of a run, told in words.

use crate::hits::wall_in_words;
use pelletflow_sim::{Hit, HitPartner};
use serde::{Deserialize, Serialize};

/// How many are marked [-].
pub const WORST_HITS: usize = 20;

/// The hardest hits so far, the hardest first.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct WorstHits {
    most: usize,
    hits: Vec<Hit>,
}

impl WorstHits {
    /// Room for a number of them [-].
    pub fn new(most: usize) -> Self {
        Self {
            most,
            hits: Vec::new(),
        }
    }

    /// Enters a hit; whether it is one of the hardest. Of two of the same force the first stays in front.
    pub fn enter(&mut self, hit: &Hit) -> bool {
        let place = self
            .hits
            .partition_point(|other| other.peak_force >= hit.peak_force);
        if place < self.most {
            self.hits.insert(place, *hit);
            self.hits.truncate(self.most);
        }
        place < self.most
    }

    /// The hits, the hardest first.
    pub fn as_slice(&self) -> &[Hit] {
        &self.hits
    }
}

/// What a hit was, in a line; `walls` names the walls of the scene.
pub(crate) fn in_words(hit: &Hit, walls: &[String]) -> String {
    let partner = match hit.partner {
        HitPartner::Pellet { id, .. } => format!("pellet {id}"),
        HitPartner::Wall(wall) => wall_in_words(walls, wall),
    };
    format!(
        "{:.4} N on pellet {} by {partner}, {}: {:.3} m/s at {:.0}°, {:.3} MPa, {} steps",
        hit.peak_force,
        hit.pellet,
        hit.cause.name(),
        hit.speed(),
        hit.angle().to_degrees(),
        hit.peak_pressure * 1.0e-6,
        hit.steps
    )
}
