//! Breakage: which of the recorded hits break pellets of a strength, and where.

mod groups;
mod warnings;

pub use groups::{Group, Place};

use crate::hits::RecordedHits;
use groups::Groups;
use pelletflow_impact::{Blow, ImpactError, Interval, Scatter, Score, StrengthLaw, score};
use pelletflow_sim::{Hit, HitPartner};
use serde::Serialize;

/// What is asked of recorded hits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BreakageRequest {
    /// What breaks a pellet.
    pub law: StrengthLaw,
    /// Pressure that a pellet yields under; none where it stays elastic up to breakage [Pa].
    pub yield_pressure: Option<f64>,
    /// How many of the places where most breaks are told [-].
    pub places: usize,
}

/// Pellets broken by the hits of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Breakage {
    /// Pellets put in up to the last frame [-].
    pub pellets: u64,
    /// Hits of the run [-].
    pub hits: u64,
    /// How many of them are recorded in full, and scored [-].
    pub hits_recorded: u64,
    /// Force from which on every hit is recorded in full [N]; where there is none, only those are that no hit of one of
    /// their pellets had reached before.
    pub threshold_n: Option<f64>,
    /// Moment of the last record [s].
    pub end_s: f64,
    /// Whether the recording ends in the middle; what is told is then that before the cut.
    pub is_cut_off: bool,
    /// Whether some material was softer in the run than it really is.
    pub is_softened: bool,
    /// By the forces of the run.
    pub broken: Share,
    /// By the forces at true stiffness; none where breakage asks for no force.
    pub broken_at_true_stiffness: Option<Share>,
    /// By the forces at true stiffness of pellets that yield before they break; none where no yield pressure is given.
    pub broken_yielding: Option<Share>,
    /// Confidence of the intervals; none where the strength does not tell how many pellets were tested [-].
    pub confidence: Option<f64>,
    /// Standard deviation of the number broken, by the draw of each pellet's strength [-].
    pub luck_pellets: f64,
    /// By what made the force.
    pub by_cause: Vec<Group>,
    /// By what was hit.
    pub by_wall: Vec<Group>,
    /// By the size of the pellet.
    pub by_size: Vec<Group>,
    /// By place, the worst first.
    pub by_place: Vec<Place>,
    /// Side of the cubes of places [m].
    pub cube_side_m: f64,
    /// What the numbers do not know, in sentences.
    pub warnings: Vec<String>,
}

/// A share of the pellets.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Share {
    /// The share [-].
    pub share: f64,
    /// Between what the sample of the strength test leaves possible [-].
    pub interval: [f64; 2],
    /// As a number of pellets [-].
    pub pellets: f64,
}

impl Share {
    fn of(broken: Interval, pellets: u64) -> Self {
        let share = |broken: f64| (broken / pellets.max(1) as f64).min(1.0);
        Self {
            share: share(broken.best),
            interval: [share(broken.low), share(broken.high)],
            pellets: broken.best,
        }
    }
}

/// Tells which of the recorded hits break pellets.
///
/// Groups are told by the forces of the run; of a softened one by those at true stiffness.
///
/// # Errors
///
/// When a quantity of the strength is outside its bounds.
pub fn breakage(
    recorded: &RecordedHits,
    request: &BreakageRequest,
) -> Result<Breakage, ImpactError> {
    let law = &request.law;
    let as_simulated = Scored::new(law, recorded, |hit| hit.peak_force)?;
    let has_force = matches!(law, StrengthLaw::Load(_));
    let with_forces = |force: &dyn Fn(&Hit) -> f64| {
        has_force
            .then(|| as_simulated.with_forces(law, recorded, force))
            .transpose()
    };
    let at_true_stiffness = with_forces(&Hit::true_force)?;
    let yielding = match request.yield_pressure {
        Some(pressure) => with_forces(&|hit| hit.yielded_force(pressure))?,
        None => None,
    };
    let (told, force): (_, fn(&Hit) -> f64) = match &at_true_stiffness {
        Some(scored) if recorded.is_softened => (scored, Hit::true_force),
        _ => (&as_simulated, |hit| hit.peak_force),
    };
    let groups = Groups::new(recorded, told, force, request.places);
    let share = |scored: &Scored| Share::of(scored.score.broken(), recorded.pellets);
    Ok(Breakage {
        pellets: recorded.pellets,
        hits: recorded.classes.values().map(|class| class.count).sum(),
        hits_recorded: recorded.hits.len() as u64,
        threshold_n: Some(recorded.threshold).filter(|force| force.is_finite()),
        end_s: recorded.end,
        is_cut_off: recorded.is_cut_off,
        is_softened: recorded.is_softened,
        broken: share(&as_simulated),
        broken_at_true_stiffness: at_true_stiffness.as_ref().map(share),
        broken_yielding: yielding.as_ref().map(share),
        confidence: confidence(law),
        luck_pellets: told.score.luck,
        warnings: warnings::warnings(recorded, request, &as_simulated),
        by_cause: groups.by_cause,
        by_wall: groups.by_wall,
        by_size: groups.by_size,
        by_place: groups.by_place,
        cube_side_m: groups.cube_side,
    })
}

/// Confidence of the intervals that a law's sample leaves [-].
fn confidence(law: &StrengthLaw) -> Option<f64> {
    let sample_size = match law {
        StrengthLaw::Load(strength) => match strength.scatter {
            Scatter::Fixed(_) => None,
            _ => strength.sample_size,
        },
        StrengthLaw::Energy(energy) => energy.sample_size,
    };
    sample_size.map(|_| pelletflow_impact::strength::CONFIDENCE)
}

/// Blows and the chance of each to break its pellet.
struct Scored {
    blows: Vec<Blow>,
    /// The hit that dealt each blow, by its place in the recording.
    hits: Vec<u32>,
    score: Score,
}

impl Scored {
    fn new(
        law: &StrengthLaw,
        recorded: &RecordedHits,
        force: impl Fn(&Hit) -> f64,
    ) -> Result<Self, ImpactError> {
        let mut in_time: Vec<u32> = (0..recorded.hits.len() as u32).collect();
        in_time.sort_by(|&one, &other| {
            let moment = |index: u32| recorded.hits[index as usize].peak_time;
            moment(one).total_cmp(&moment(other))
        });
        let mut blows = Vec::with_capacity(2 * recorded.hits.len());
        let mut hits = Vec::with_capacity(2 * recorded.hits.len());
        for index in in_time {
            let hit = &recorded.hits[index as usize];
            // A wall is so much stiffer that the pellet takes up all; two pellets share alike.
            let (energy, other) = match hit.partner {
                HitPartner::Wall(_) => (hit.approach_energy(), None),
                HitPartner::Pellet { id, diameter, mass } => {
                    (0.5 * hit.approach_energy(), Some((id, diameter, mass)))
                }
            };
            let own = (hit.pellet, hit.diameter, hit.mass);
            for (pellet, diameter, mass) in std::iter::once(own).chain(other) {
                blows.push(Blow {
                    pellet,
                    diameter,
                    mass,
                    force: force(hit),
                    energy,
                });
                hits.push(index);
            }
        }
        let score = score(law, &blows)?;
        Ok(Self { blows, hits, score })
    }

    /// The same blows with other forces [N].
    fn with_forces(
        &self,
        law: &StrengthLaw,
        recorded: &RecordedHits,
        force: &dyn Fn(&Hit) -> f64,
    ) -> Result<Self, ImpactError> {
        let mut blows = self.blows.clone();
        for (blow, &hit) in blows.iter_mut().zip(&self.hits) {
            blow.force = force(&recorded.hits[hit as usize]);
        }
        let score = score(law, &blows)?;
        Ok(Self {
            blows,
            hits: self.hits.clone(),
            score,
        })
    }

    /// Blows with the hits that dealt them.
    fn dealt<'a>(
        &'a self,
        recorded: &'a RecordedHits,
    ) -> impl Iterator<Item = (&'a Blow, &'a Hit)> {
        let hit_of = |&index: &u32| &recorded.hits[index as usize];
        self.blows.iter().zip(self.hits.iter().map(hit_of))
    }
}
