//! `pelletflow score`.

mod answer;
mod groups;

use crate::args::score::{LawName, ScoreArguments, StrengthArgument};
use crate::commands::hit::bad_input;
use crate::exit::{Exit, Failure};
use crate::screen;
use answer::Answer;
use groups::Groups;
use pelletflow_impact::{Blow, Interval, Score, Strength, StrengthLaw, score};
use pelletflow_impact::{ImpactError, Scatter};
use pelletflow_log::RecordedHits;
use pelletflow_scene::StrengthCard;
use pelletflow_sim::{Hit, HitPartner};

/// Tells which of the recorded hits break pellets of a strength.
pub(crate) fn score_hits(arguments: &ScoreArguments) -> Result<Exit, Failure> {
    let (law, told) = law(arguments)?;
    let mut recorded = pelletflow_log::read_hits(&arguments.recording)?;
    recorded
        .hits
        .sort_by(|one, other| one.peak_time.total_cmp(&other.peak_time));
    let as_simulated = Scored::new(&law, &recorded, |hit| hit.peak_force)?;
    let at_true_stiffness = Scored::new(&law, &recorded, Hit::true_force)?;
    // Of a softened run, the forces at true stiffness tell where pellets break.
    let groups = if recorded.is_softened {
        Groups::new(
            &recorded,
            &at_true_stiffness,
            Hit::true_force,
            arguments.places,
        )
    } else {
        Groups::new(
            &recorded,
            &as_simulated,
            |hit| hit.peak_force,
            arguments.places,
        )
    };
    let answer = Answer::new(
        &recorded,
        &law,
        told,
        [&as_simulated, &at_true_stiffness],
        groups,
    );
    if arguments.json {
        screen::json(&answer.json())?;
    } else {
        screen::result(&answer.page())?;
    }
    Ok(Exit::Done)
}

/// Blows and the chance of each to break its pellet.
struct Scored {
    blows: Vec<Blow>,
    /// The hit that dealt each blow, by its place in the recording.
    hits: Vec<usize>,
    score: Score,
}

impl Scored {
    fn new(
        law: &StrengthLaw,
        recorded: &RecordedHits,
        force: impl Fn(&Hit) -> f64,
    ) -> Result<Self, Failure> {
        let mut blows = Vec::with_capacity(2 * recorded.hits.len());
        let mut hits = Vec::with_capacity(2 * recorded.hits.len());
        for (index, hit) in recorded.hits.iter().enumerate() {
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
        let score = score(law, &blows).map_err(|error| refused(&error))?;
        Ok(Self { blows, hits, score })
    }

    /// Pellets that break.
    fn broken(&self) -> Interval {
        self.score.broken()
    }

    /// Standard deviation of that number by the luck of the draw: each pellet's strength is its own.
    fn luck(&self) -> f64 {
        let mut chances = std::collections::BTreeMap::<u32, f64>::new();
        for (blow, chance) in self.blows.iter().zip(&self.score.best) {
            *chances.entry(blow.pellet).or_default() += chance;
        }
        let variance: f64 = chances.values().map(|chance| chance * (1.0 - chance)).sum();
        variance.max(0.0).sqrt()
    }
}

/// The law that is asked for and what tells it.
fn law(arguments: &ScoreArguments) -> Result<(StrengthLaw, String), Failure> {
    let path = match &arguments.strength {
        StrengthArgument::Load(load) => {
            if arguments.law == LawName::Energy {
                let message = "--law energy needs a fracture energy, and a load has none; give a card with [fracture_energy]";
                return Err(bad_input(message.into()));
            }
            let strength = Strength {
                scatter: Scatter::Fixed(*load),
                test_diameter: None,
                sample_size: None,
            };
            let told = format!("every pellet breaks at {} N", crate::table::chosen(*load));
            return Ok((StrengthLaw::Load(strength), told));
        }
        StrengthArgument::Card(path) => path,
    };
    let card = StrengthCard::read(path)?;
    let told = format!("{}: {}", card.name, card.source);
    let law = match (arguments.law, card.fracture_energy) {
        (LawName::Load, _) => StrengthLaw::Load(card.strength),
        (LawName::Energy, Some(energy)) => StrengthLaw::Energy(energy),
        (LawName::Energy, None) => {
            return Err(bad_input(format!(
                "{} has no [fracture_energy], which --law energy needs; `pelletflow card --drop` makes one of a drop test",
                path.display()
            )));
        }
    };
    Ok((law, told))
}

fn refused(error: &ImpactError) -> Failure {
    bad_input(error.to_string())
}
