//! `pelletflow score`.

mod page;

use crate::args::score::{LawName, ScoreArguments, StrengthArgument};
use crate::commands::hit::bad_input;
use crate::exit::{Exit, Failure};
use crate::screen;
use page::page;
use pelletflow_impact::{Scatter, Strength, StrengthLaw};
use pelletflow_log::{BreakageRequest, breakage, read_hits};
use pelletflow_scene::StrengthCard;
use serde_json::json;

/// Tells which of the recorded hits break pellets of a strength.
pub(crate) fn score_hits(arguments: &ScoreArguments) -> Result<Exit, Failure> {
    let asked = Asked::new(&arguments.strength, arguments.law)?;
    let recorded = read_hits(&arguments.recording)?;
    let request = asked.request(arguments.places);
    let breakage = breakage(&recorded, &request).map_err(|error| bad_input(error.to_string()))?;
    if arguments.json {
        let mut answer = json!(breakage);
        answer["strength"] = json!(asked.told);
        screen::json(&answer)?;
    } else {
        screen::result(&page(&breakage, &asked.told))?;
    }
    Ok(Exit::Done)
}

/// What is to break pellets.
pub(crate) struct Asked {
    pub(crate) law: StrengthLaw,
    pub(crate) yield_pressure: Option<f64>,
    /// What tells it, in words.
    pub(crate) told: String,
}

impl Asked {
    /// What is asked of hits, of which so many places are told [-].
    pub(crate) fn request(&self, places: usize) -> BreakageRequest {
        BreakageRequest {
            law: self.law,
            yield_pressure: self.yield_pressure,
            places,
        }
    }

    pub(crate) fn new(strength: &StrengthArgument, law: LawName) -> Result<Self, Failure> {
        match (strength, law) {
            (StrengthArgument::Load(_), LawName::Energy) => {
                let message = "--law energy needs a fracture energy, and a load has none; give a card with [fracture_energy]";
                Err(bad_input(message.into()))
            }
            (StrengthArgument::Load(load), LawName::Load) => Ok(Self {
                law: StrengthLaw::Load(Strength {
                    scatter: Scatter::Fixed(*load),
                    test_diameter: None,
                    sample_size: None,
                }),
                yield_pressure: None,
                told: format!("every pellet breaks at {} N", crate::table::chosen(*load)),
            }),
            (StrengthArgument::Card(path), law) => {
                let card = StrengthCard::read(path)?;
                let law = match (law, card.fracture_energy) {
                    (LawName::Load, _) => StrengthLaw::Load(card.strength),
                    (LawName::Energy, Some(energy)) => StrengthLaw::Energy(energy),
                    (LawName::Energy, None) => {
                        return Err(bad_input(format!(
                            "{} has no [fracture_energy], which --law energy needs; `pelletflow card --drop` makes one of a drop test",
                            path.display()
                        )));
                    }
                };
                Ok(Self {
                    law,
                    yield_pressure: card.yield_pressure,
                    told: format!("{}: {}", card.name, card.source),
                })
            }
        }
    }
}
