//! Breakage: which of the recorded hits break pellets of a strength, and where.

mod groups;
mod warnings;

pub(crate) use groups::wall_name;
pub use groups::{Breaking, Group, Place};

use crate::hits::RecordedHits;
use groups::Groups;
use pelletflow_impact::{Blow, ImpactError, Interval, Scatter, Score, Scorer, StrengthLaw};
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

impl Breakage {
    /// The share to go by: of a softened run that at true stiffness.
    pub fn believed(&self) -> &Share {
        match &self.broken_at_true_stiffness {
            Some(share) if self.is_softened => share,
            _ => &self.broken,
        }
    }
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
    scored(recorded, request).map(|(breakage, _)| breakage)
}

/// The same, and how many pellets each of the recorded hits breaks [-]: at most two.
pub(crate) fn scored(
    recorded: &RecordedHits,
    request: &BreakageRequest,
) -> Result<(Breakage, Vec<f64>), ImpactError> {
    let law = &request.law;
    let mut scorer = Scorer::new(law)?;
    let mut blows = Blows::new(recorded);
    let as_simulated = blows.score(&mut scorer, |hit| hit.peak_force)?;
    let has_force = matches!(law, StrengthLaw::Load(_));
    let at_true_stiffness = has_force
        .then(|| blows.score(&mut scorer, Hit::true_force))
        .transpose()?;
    let yielding = request
        .yield_pressure
        .filter(|_| has_force)
        .map(|pressure| blows.score(&mut scorer, |hit| hit.yielded_force(pressure)))
        .transpose()?;
    let (told, force): (_, fn(&Hit) -> f64) = match &at_true_stiffness {
        Some(scored) if recorded.is_softened => (scored, Hit::true_force),
        _ => (&as_simulated, |hit| hit.peak_force),
    };
    let groups = Groups::new(&blows, told, force, request.places);
    let share = |score: &Score| Share::of(score.broken(), recorded.pellets);
    let mut broken_by = vec![0.0; recorded.hits.len()];
    for (&hit, chance) in blows.hits.iter().zip(&told.chances) {
        broken_by[hit as usize] += chance.best;
    }
    let breakage = Breakage {
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
        luck_pellets: told.luck,
        warnings: warnings::warnings(&blows, request, &as_simulated),
        by_cause: groups.by_cause,
        by_wall: groups.by_wall,
        by_size: groups.by_size,
        by_place: groups.by_place,
        cube_side_m: groups.cube_side,
    };
    Ok((breakage, broken_by))
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

/// The blows of recorded hits.
struct Blows<'a> {
    recorded: &'a RecordedHits,
    /// Hit by hit, those of two pellets twice; without forces.
    felt: Vec<Blow>,
    /// The hit that dealt each, by its place in the recording.
    hits: Vec<u32>,
    /// Places of blows, pellet by pellet and those of a pellet in order of time.
    lives: Vec<u32>,
}

impl<'a> Blows<'a> {
    fn new(recorded: &'a RecordedHits) -> Self {
        let mut blows = Vec::with_capacity(2 * recorded.hits.len());
        let mut hits = Vec::with_capacity(2 * recorded.hits.len());
        for (index, hit) in (0..).zip(&recorded.hits) {
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
                    force: 0.0,
                    energy,
                });
                hits.push(index);
            }
        }
        let mut lives: Vec<(u32, u32)> = blows.iter().map(|blow| blow.pellet).zip(0..).collect();
        lives.sort_unstable();
        // Hits end nearly in the order of their peaks, so that each life is nearly sorted.
        let moment = |place: u32| recorded.hits[hits[place as usize] as usize].peak_time;
        for life in lives.chunk_by_mut(|one, other| one.0 == other.0) {
            life.sort_by(|one, other| moment(one.1).total_cmp(&moment(other.1)));
        }
        Self {
            recorded,
            lives: lives.into_iter().map(|(_, place)| place).collect(),
            felt: blows,
            hits,
        }
    }

    /// The chance of each to break its pellet, by forces told of hits [N].
    fn score(
        &mut self,
        scorer: &mut Scorer,
        force: impl Fn(&Hit) -> f64,
    ) -> Result<Score, ImpactError> {
        for (blow, &hit) in self.felt.iter_mut().zip(&self.hits) {
            blow.force = force(&self.recorded.hits[hit as usize]);
        }
        scorer.score_in_order(&self.felt, &self.lives)
    }

    /// Every blow with the hit that dealt it.
    fn iter(&self) -> impl Iterator<Item = (&Blow, &'a Hit)> + '_ {
        let hit_of = |&hit: &u32| &self.recorded.hits[hit as usize];
        self.felt.iter().zip(self.hits.iter().map(hit_of))
    }
}
