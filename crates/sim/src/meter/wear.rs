//! Wear of one wall by impacts and by sliding, patch by patch.
//!
//! Impacts erode as Finnie (1960) found for ductile surfaces: a pellet of mass m that arrives with the speed v at the
//! angle α to the surface cuts out `V = c m v² f(α)`, with `f = sin 2α − 3 sin² α` up to `tan α = 1/3`, where it
//! leaves while it still cuts, and `f = cos² α / 3` beyond, where it stops sliding before it leaves.
//! In his letters `c = 1/(p ψ K)` with `K = 2`: a flow pressure p and a ratio ψ of the lengths of contact and of cut.
//! Sliding wears as Archard (1953) found: `V = k F s` for a normal force F over a way s of slip. With F s is meant the
//! work of friction over the coefficient of friction: a pellet that sways on the spring of its contact without
//! slipping wears nothing.

use super::patch::{self, PatchTable, Patches};
use super::touch::WallTouch;
use super::{Instrument, Values, Watched};
use crate::model::Model;
use crate::setup::Setup;
use crate::state::State;
use serde::{Deserialize, Serialize};

/// Wear of one wall by impacts and by sliding, patch by patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wear {
    /// Index of the wall [-].
    pub wall: usize,
    /// Width of the patches [m].
    pub cell: f64,
    /// Archard's coefficient over the hardness of the wall; 0 where sliding does not wear [1/Pa].
    pub archard: f64,
    /// Finnie's constant `1/(p ψ K)`: volume cut out over `m v² f(α)`; 0 where impacts do not wear [1/Pa].
    pub finnie: f64,
    /// Speed of approach up to which a touch is no impact [m/s].
    pub least_speed: f64,
}

/// Wear of one patch or of all.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Worn {
    /// By sliding [m³].
    sliding: f64,
    /// By impacts [m³].
    impact: f64,
    /// Work of friction [J].
    sliding_work: f64,
}

/// Finnie's share of the energy that cuts, at an angle to the surface given by speeds across and along it [m/s]; in [-].
fn cutting_share(approach: f64, along: f64) -> f64 {
    let square = approach * approach + along * along;
    if 3.0 * approach <= along {
        (2.0 * approach * along - 3.0 * approach * approach) / square
    } else {
        along * along / (3.0 * square)
    }
}

impl Wear {
    /// What a contact wears off in one step [s].
    fn of(&self, touch: &WallTouch, time_step: f64) -> Worn {
        let mut worn = Worn::default();
        if touch.friction > 0.0 {
            worn.sliding_work = touch.friction_power() * time_step;
            worn.sliding = self.archard * worn.sliding_work / touch.friction;
        }
        let approach = touch.approach_speed();
        if touch.is_first && approach > self.least_speed {
            let along = touch.tangential_speed();
            let square = approach * approach + along * along;
            let share = cutting_share(approach, along);
            worn.impact = self.finnie * touch.mass() * square * share;
        }
        worn
    }

    /// Depth of a patch, as if it were a face of its cell [m].
    fn depth(&self, worn: &Worn) -> f64 {
        worn.volume() / (self.cell * self.cell)
    }
}

impl Worn {
    fn add(&mut self, other: &Self) {
        self.sliding += other.sliding;
        self.impact += other.impact;
        self.sliding_work += other.sliding_work;
    }

    fn volume(&self) -> f64 {
        self.sliding + self.impact
    }

    fn values(&self, depth: (&'static str, f64)) -> Values {
        vec![
            depth,
            ("volume_m3", self.volume()),
            ("sliding_volume_m3", self.sliding),
            ("impact_volume_m3", self.impact),
            ("sliding_work_j", self.sliding_work),
        ]
    }
}

impl Instrument for Wear {
    type Record = (Worn, Patches<Worn>);

    const NAME: &'static str = "wear";

    fn mistakes(&self, setup: &Setup) -> Vec<(&'static str, String)> {
        let mut mistakes = super::unknown("wall", self.wall, setup.walls.len());
        mistakes.extend(patch::mistakes(self.cell));
        let of_sliding = ("archard", self.archard, "1/Pa");
        let of_impacts = ("finnie", self.finnie, "1/Pa");
        for (key, value, unit) in [
            of_sliding,
            of_impacts,
            ("least_speed", self.least_speed, "m/s"),
        ] {
            if !(value.is_finite() && value >= 0.0) {
                mistakes.push((key, format!("is {value} {unit}; expected 0 or more")));
            }
        }
        if self.archard == 0.0 && self.finnie == 0.0 {
            let message = "is missing, and so is `finnie`; give at least one, such as `archard = \"1e-13 1/Pa\"`";
            mistakes.push(("archard", message.into()));
        }
        mistakes
    }

    fn wall(&self) -> Option<usize> {
        Some(self.wall)
    }

    fn watch(&self, (all, patches): &mut Self::Record, step: &Watched) {
        let pose = &step.walls[self.wall].pose;
        for touch in step.touches_of(self.wall) {
            let worn = self.of(touch, step.time_step());
            if worn != Worn::default() {
                all.add(&worn);
                patches.at(touch, self.cell, pose).add(&worn);
            }
        }
    }

    fn values(&self, (all, patches): &Self::Record, _model: &Model, _state: &State) -> Values {
        let deepest = patches
            .iter()
            .map(|worn| self.depth(worn))
            .fold(0.0, f64::max);
        all.values(("greatest_depth_m", deepest))
    }

    fn patches(&self, (_, patches): &Self::Record) -> Option<PatchTable> {
        let row = |worn: &Worn| worn.values(("depth_m", self.depth(worn)));
        Some(patches.table(self.cell, |worn| self.depth(worn), row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cutting_share_is_continuous_and_greatest_near_seventeen_degrees() {
        let share =
            |degrees: f64| cutting_share(degrees.to_radians().sin(), degrees.to_radians().cos());
        let bend = (1.0_f64 / 3.0).atan().to_degrees();
        // Both branches meet at tan α = 1/3 with the value cos² α / 3 = 0.3; they turn by less than 10 per radian.
        assert!((share(bend - 1.0e-9) - 0.3).abs() < 1.0e-9);
        assert!((share(bend + 1.0e-9) - 0.3).abs() < 1.0e-9);
        let steepest = (0..900).max_by(|a, b| {
            let at = |tenth: &i32| share(f64::from(*tenth) / 10.0);
            at(a).total_cmp(&at(b))
        });
        // d/dα (sin 2α − 3 sin² α) = 0 at tan 2α = 2/3: 16.845°.
        assert_eq!(steepest, Some(168));
        assert_eq!(share(0.0), 0.0);
    }
}
