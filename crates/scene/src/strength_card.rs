//! Strength cards: a crushing test as a TOML file.

use crate::draft::as_value;
use crate::key_path::KeyPath;
use crate::mistakes::{Findings, Mistakes};
use crate::schema::schema_for;
use crate::source::{Source, whole};
use crate::spec::strength_card::{DistributionSpec, StrengthCardSpec};
use crate::walk::walk;
use pelletflow_impact::{Scatter, Strength};
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
                let scatter = scatter(&spec, &mut findings);
                if let (Some(scatter), true) = (scatter, findings.is_empty()) {
                    let strength = Strength {
                        scatter,
                        test_diameter: spec.test_diameter.map(|size| size.0),
                        sample_size: spec.sample_size,
                    };
                    return Ok(Self {
                        name: spec.name,
                        source: spec.source,
                        strength,
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

/// The distribution that a card gives in one of its two ways.
fn scatter(spec: &StrengthCardSpec, findings: &mut Findings) -> Option<Scatter> {
    let mean = spec.mean.map(|force| force.0);
    let variation = spec.coefficient_of_variation.map(|share| share.0);
    let scale = spec.scale.map(|force| force.0);
    let made = match (spec.distribution, mean, variation, scale, spec.modulus) {
        (DistributionSpec::Fixed, Some(load), None, None, None) => Ok(Scatter::Fixed(load)),
        (DistributionSpec::LogNormal, Some(mean), Some(variation), None, None) => {
            Scatter::log_normal_from_mean(mean, variation)
        }
        (DistributionSpec::Weibull, Some(mean), Some(variation), None, None) => {
            Scatter::weibull_from_mean(mean, variation)
        }
        (DistributionSpec::Weibull, None, None, Some(scale), Some(modulus)) => {
            Ok(Scatter::Weibull { scale, modulus })
        }
        _ => {
            let expected = match spec.distribution {
                DistributionSpec::Fixed => "`mean` alone",
                DistributionSpec::LogNormal => "`mean` and `coefficient_of_variation`",
                DistributionSpec::Weibull => {
                    "either `mean` and `coefficient_of_variation`, or `scale` and `modulus`"
                }
            };
            findings.add(
                &KeyPath::of(["distribution"]),
                format!("this distribution is told by {expected}; give these and no others"),
            );
            return None;
        }
    };
    made.map_err(|error| findings.add(&KeyPath::of(["mean"]), error.to_string()))
        .ok()
}

#[cfg(test)]
mod tests {
    use super::*;

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
        ] {
            let card = CARD.replacen(good, bad, 1);
            let message = StrengthCard::parse(&card, "card.toml")
                .expect_err(bad)
                .to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
