//! Strength cards: a crushing test, and what goes with it, as a TOML file.

mod parts;
mod writing;

pub use parts::{Provenance, Tumble};

use crate::draft::as_value;
use crate::key_path::KeyPath;
use crate::mistakes::Mistakes;
use crate::schema::schema_for;
use crate::source::{Source, whole};
use crate::spec::strength_card::StrengthCardSpec;
use crate::walk::walk;
use pelletflow_impact::{DropLevel, FractureEnergy, Strength};
use serde::Deserialize;
use serde::de::IntoDeserializer;
use std::io;
use std::path::{Path, PathBuf};

/// What a crushing test found, with its name and its source.
#[derive(Debug, Clone, PartialEq)]
pub struct StrengthCard {
    /// Name of the pellets.
    pub name: String,
    /// Where the numbers come from.
    pub source: String,
    /// The strength.
    pub strength: Strength,
    /// Pressure in the middle of a contact that the pellet yields under; none where it stays elastic up to breakage
    /// [Pa].
    pub yield_pressure: Option<f64>,
    /// How the numbers were found.
    pub provenance: Option<Provenance>,
    /// What breaks in a blow.
    pub fracture_energy: Option<FractureEnergy>,
    /// What a drop test found.
    pub drops: Vec<DropLevel>,
    /// What a tumble test found.
    pub tumble: Option<Tumble>,
}

/// A strength card that cannot be had.
#[derive(Debug, thiserror::Error)]
pub enum StrengthCardError {
    /// The file could not be read.
    #[error("{}: cannot be read: {source}; name a TOML file with the strength of pellets", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why not.
        source: io::Error,
    },
    /// The file was read, and something in it is wrong.
    #[error(transparent)]
    Invalid(#[from] Mistakes),
}

impl StrengthCard {
    /// Reads a card from a file.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or there are mistakes in it; all that were found.
    pub fn read(path: &Path) -> Result<Self, StrengthCardError> {
        let text = Source::read(path).map_err(|source| StrengthCardError::Unreadable {
            path: path.to_owned(),
            source,
        })??;
        Ok(Self::parse(&text, &path.display().to_string())?)
    }

    /// Reads a card from text; `label` names it in messages.
    ///
    /// # Errors
    ///
    /// The mistakes found in it.
    pub fn parse(text: &str, label: &str) -> Result<Self, Mistakes> {
        if text.trim().is_empty() {
            let message = "the strength card is empty; `pelletflow safe-speed --help` shows one";
            return Err(whole(label, message.into()));
        }
        let source = Source::new(label, text)?;
        let mut value = as_value(source.document().clone().into_mut());
        let mut findings = walk(&schema_for::<StrengthCardSpec>(), &mut value);
        let card = StrengthCardSpec::deserialize(value.into_deserializer());
        match card {
            Ok(spec) => {
                let scatter = parts::scatter(&spec, &mut findings);
                let fracture_energy = spec
                    .fracture_energy
                    .as_ref()
                    .and_then(|energy| parts::fracture_energy(energy, &mut findings));
                let drops = parts::drops(&spec, &mut findings);
                if let (Some(scatter), true) = (scatter, findings.is_empty()) {
                    return Ok(Self {
                        name: spec.name,
                        source: spec.source,
                        strength: Strength {
                            scatter,
                            test_diameter: spec.test_diameter.map(|size| size.0),
                            sample_size: spec.sample_size,
                        },
                        yield_pressure: spec.yield_pressure.map(|pressure| pressure.0),
                        provenance: spec.provenance.map(Provenance::from),
                        fracture_energy,
                        drops,
                        tumble: spec.tumble.map(Tumble::from),
                    });
                }
            }
            // The walk has named the cause, unless schema and types disagree.
            Err(error) if findings.is_empty() => {
                findings.add(&KeyPath::root(), error.message().trim());
            }
            Err(_) => {}
        }
        Err(source.locate(findings))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pelletflow_impact::{Goodness, MedianEnergy, Scatter};

    const CARD: &str = "\
name = \"works A\"
source = \"60 pellets, ISO 4700\"
distribution = \"log-normal\"
mean = \"2.45 kN\"
coefficient_of_variation = \"30 %\"
test_diameter = \"11.25 mm\"
sample_size = 60
";

    #[test]
    fn a_card_with_units_is_the_strength_it_tells() {
        let card = StrengthCard::parse(CARD, "card.toml").expect("a good card");
        assert_eq!(card.name, "works A");
        assert_eq!(card.strength.test_diameter, Some(0.01125));
        assert_eq!(card.strength.sample_size, Some(60));
        let scatter = Scatter::log_normal_from_mean(2450.0, 0.3);
        assert_eq!(Ok(card.strength.scatter), scatter);
    }

    fn full_card() -> StrengthCard {
        StrengthCard {
            name: "works \"A\"".into(),
            source: "60 pellets, ISO 4700\nsecond line".into(),
            strength: Strength {
                scatter: Scatter::LogNormal {
                    median: 2_346.789_123_456_7,
                    deviation: 0.1 + 0.2,
                },
                test_diameter: Some(0.011_25),
                sample_size: Some(60),
            },
            yield_pressure: Some(61.5e6),
            provenance: Some(Provenance {
                file: Some("loads.csv".into()),
                date: Some("2024-07-01".into()),
                method: Some("crushing between plates".into()),
                fit: Some("maximum likelihood".into()),
                center_interval: Some([2200.0, 2500.5]),
                shape_interval: Some([0.25, 0.37]),
                goodness: Some(Goodness {
                    distance: 0.31,
                    p_value: 0.55,
                }),
            }),
            fracture_energy: Some(FractureEnergy {
                median: MedianEnergy::BySize {
                    large: 80.0,
                    stiffness_ratio: 0.0,
                    diameter: 0.012,
                    exponent: 1.5,
                },
                deviation: 0.5,
                truncation: Some(4.0),
                damage_constant: Some(5.0),
                sample_size: Some(120),
            }),
            drops: vec![DropLevel {
                speed: 9.9,
                dropped: 40,
                broken: 3,
            }],
            tumble: Some(Tumble {
                tumble_index: 0.945,
                abrasion_index: Some(0.045),
            }),
        }
    }

    #[test]
    fn a_card_that_is_written_reads_back_as_the_same_to_the_last_bit() {
        let full = full_card();
        let bare = StrengthCard {
            yield_pressure: None,
            provenance: None,
            fracture_energy: None,
            drops: Vec::new(),
            tumble: None,
            ..full.clone()
        };
        for scatter in [
            full.strength.scatter,
            Scatter::Fixed(2450.0),
            Scatter::Weibull {
                scale: 1.0 / 3.0e-4,
                modulus: 4.0,
            },
        ] {
            for card in [&full, &bare] {
                let mut card = card.clone();
                card.strength.scatter = scatter;
                let text = card.to_toml();
                assert_eq!(StrengthCard::parse(&text, "card.toml"), Ok(card), "{text}");
            }
        }
    }

    #[test]
    fn mistakes_in_a_card_are_told_with_line_and_cure() {
        for (good, bad, expected) in [
            (CARD, "", "card.toml: the strength card is empty"),
            (
                "2.45 kN",
                "2.45 kg",
                "card.toml:4: mean: `mean` is a force; `2.45 kg` is a mass",
            ),
            (
                "2.45 kN",
                "0 kN",
                "card.toml:4: mean: `mean` is \"0 kN\"; expected more than 0 N",
            ),
            (
                "log-normal",
                "normal",
                "unknown distribution `normal`; did you mean `log-normal`?",
            ),
            (
                "log-normal",
                "fixed",
                "this distribution is told by `mean` alone",
            ),
            ("test_diameter", "diameter", "unknown key `diameter`"),
            ("sample_size = 60", "sample_size = 1", "expected at least 2"),
            (
                "mean = \"2.45 kN\"",
                "median = \"2.45 kN\"",
                "or `median` and `deviation`; give these and no others",
            ),
            (
                "sample_size = 60",
                "[fracture_energy]\ndeviation = 0.5",
                "card.toml:7: fracture_energy: the median is told by `median` alone, or by `large`",
            ),
            (
                "sample_size = 60",
                "[[drops]]\nspeed = 9\ndropped = 3\nbroken = 4",
                "number of pellets broken is 4; expected at most the number dropped",
            ),
        ] {
            let card = CARD.replacen(good, bad, 1);
            let message = StrengthCard::parse(&card, "card.toml")
                .expect_err(bad)
                .to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
