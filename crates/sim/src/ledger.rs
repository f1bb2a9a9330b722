//! The books of mass and energy, and what contacts have done.

use crate::tally::Tally;
use serde::{Deserialize, Serialize};

/// Greatest count that is believed of what is read back [-]: no run comes near, and beyond it numbers on a page are no
/// longer exact.
pub const MOST_COUNTED: u64 = 1 << f64::MANTISSA_DIGITS;

/// A number of pellets and their mass.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PelletTally {
    /// How many [-].
    pub count: u64,
    /// Their mass [kg].
    pub mass: f64,
}

/// Where every pellet went: inserted = inside + discharged + lost.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct MassLedger {
    /// Put in by fills and inlets.
    pub inserted: PelletTally,
    /// Now inside.
    pub inside: PelletTally,
    /// Left through an outlet.
    pub discharged: PelletTally,
    /// Left elsewhere.
    pub lost: PelletTally,
    /// Fed by each inlet.
    pub by_inlet: Vec<PelletTally>,
    /// Left through each outlet.
    pub by_outlet: Vec<PelletTally>,
}

/// Where the energy went, all in joules.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct EnergyLedger {
    /// Of motion and spin, now [J].
    pub kinetic: f64,
    /// In gravity, now, from the origin [J].
    pub potential: f64,
    /// In contact springs, now [J].
    pub elastic: f64,
    /// Turned into heat so far [J].
    pub dissipated: f64,
    /// Brought in by inserted pellets, less that taken out by those that left [J].
    pub carried_in: f64,
    /// Done by moving walls and belts so far [J].
    pub wall_work: f64,
    /// What the books miss: kinetic + potential + elastic + dissipated − `carried_in` − `wall_work` [J].
    pub residual: f64,
    /// Energy that went through the books, the greatest so far, against which the residual is small or not [J].
    pub throughput: f64,
}

/// What contacts have done.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactStatistics {
    /// Contacts open now [-].
    pub open: u64,
    /// Contacts per pellet now, each counted at both its pellets and a wall's at one [-].
    pub mean_coordination: f64,
    /// Greatest normal force so far [N].
    pub max_force: f64,
    /// Greatest overlap over the smaller radius so far [-].
    pub max_overlap_ratio: f64,
    /// Contacts that opened and closed again so far [-].
    pub finished: u64,
    /// Steps that those lasted, on average [-]; 0 where none finished.
    pub mean_steps: f64,
    /// Steps that the shortest of those lasted [-]; 0 where none finished.
    pub fewest_steps: u64,
    /// Contacts evaluated so far, summed over steps [-].
    pub contact_steps: u64,
}

impl ContactStatistics {
    /// Enters what the contacts did in one step, among a number of pellets.
    pub(crate) fn enter(&mut self, step: &Tally, pellets: usize) {
        self.open = step.open;
        let ends = 2 * step.open - step.open_with_walls;
        self.mean_coordination = ends as f64 / pellets.max(1) as f64;
        self.max_force = step.max_force;
        self.max_overlap_ratio = step.max_overlap_ratio;
        self.contact_steps += step.open;
        if step.finished > 0 {
            let total = self.mean_steps * self.finished as f64 + step.finished_steps as f64;
            self.finished += step.finished;
            self.mean_steps = total / self.finished as f64;
            let fewest = u64::from(step.fewest_steps);
            self.fewest_steps = if self.fewest_steps == 0 {
                fewest
            } else {
                self.fewest_steps.min(fewest)
            };
        }
    }
}
