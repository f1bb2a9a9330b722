//! What `pelletflow card` tells of the fits.

use super::drops::Drops;
use super::refused;
use crate::exit::Failure;
use crate::table::{self, chosen, number};
use pelletflow_impact::strength::CONFIDENCE;
use pelletflow_impact::{CrushFit, Interval, Scatter};
use pelletflow_scene::StrengthCard;
use serde_json::{Value, json};
use std::path::Path;

/// Risks whose loads are told [-].
const RISKS: [f64; 4] = [0.001, 0.01, 0.05, 0.5];

/// Number of pellets below which the width of the interval is told in words [-].
const FEW: u32 = 10;

/// The fits and the card made of one of them.
pub(super) struct Answer {
    pub(super) card: StrengthCard,
    pub(super) fits: [CrushFit; 2],
    pub(super) chosen: usize,
    pub(super) drops: Option<Drops>,
}

/// Name of a distribution.
fn name(scatter: Scatter) -> &'static str {
    match scatter {
        Scatter::Weibull { .. } => "Weibull",
        Scatter::LogNormal { .. } => "log-normal",
        Scatter::Fixed(_) => "fixed",
    }
}

impl Answer {
    pub(super) fn law_name(&self) -> &'static str {
        name(self.card.strength.scatter)
    }

    /// Load of a risk for pellets of the size of the test.
    fn load(&self, risk: f64) -> Result<Interval, Failure> {
        let strength = &self.card.strength;
        let diameter = strength.test_diameter.unwrap_or(1.0);
        strength
            .load(risk, diameter)
            .map_err(|error| refused(&error))
    }

    fn count(&self) -> u32 {
        self.card.strength.sample_size.unwrap_or_default()
    }

    pub(super) fn page(&self, output: Option<&Path>) -> Result<String, Failure> {
        let mut parts = vec![self.head(), self.fit_table(), self.load_table()?];
        if let Some(drops) = &self.drops {
            parts.push(drops.page()?);
        }
        if let Some(tumble) = &self.card.tumble {
            parts.push(format!(
                "tumble index {} %: kept in the card as a note on attrition; no breakage is worked out from it",
                number(100.0 * tumble.tumble_index)
            ));
        }
        let warnings = self.warnings()?;
        if !warnings.is_empty() {
            let lines = warnings.iter().map(|warning| format!("warning: {warning}"));
            parts.push(lines.collect::<Vec<_>>().join("\n"));
        }
        parts.push(match output {
            Some(path) => format!(
                "{0} written; go on with: pelletflow safe-speed --strength-card {0} --pellet fired-pellet",
                path.display()
            ),
            None => "no card written; give -o FILE".into(),
        });
        Ok(parts.join("\n\n"))
    }

    fn head(&self) -> String {
        let size = self.card.strength.test_diameter.map_or_else(
            || "diameters unknown: the load is taken for any size".into(),
            |diameter| format!("at {} mm", number(1.0e3 * diameter)),
        );
        format!("{}: {}; {size}", self.card.name, self.card.source)
    }

    fn fit_table(&self) -> String {
        let rows = self.fits.iter().enumerate().map(|(index, fit)| {
            let [center, shape] = match fit.strength.scatter {
                Scatter::Weibull { .. } => ["63 % under", "modulus"],
                _ => ["half under", "deviation"],
            };
            let mark = if index == self.chosen { " *" } else { "" };
            [
                format!("{}{mark}", name(fit.strength.scatter)),
                format!("{center} {} N", number(fit.center.best)),
                between(fit.center),
                format!("{shape} {}", number(fit.shape.best)),
                between(fit.shape),
                number(fit.goodness.distance),
                number(fit.goodness.p_value),
            ]
        });
        let header = [
            "distribution",
            "load",
            "interval",
            "shape",
            "interval",
            "A² [-]",
            "p [-]",
        ];
        let table = table::listing(header, &[5, 6], rows);
        format!(
            "{table}\n\n* goes into the card; intervals of {} %; A² is the distance of Anderson and Darling, p the share of \
             samples of the distribution that lie farther from it",
            chosen(100.0 * CONFIDENCE)
        )
    }

    fn load_table(&self) -> Result<String, Failure> {
        let rows = RISKS
            .map(|risk| {
                let load = self.load(risk)?;
                Ok([
                    format!("{} %", chosen(100.0 * risk)),
                    number(load.best),
                    format!("{} N", between(load)),
                ])
            })
            .into_iter()
            .collect::<Result<Vec<_>, Failure>>()?;
        Ok(table::listing(
            ["breaks", "load [N]", "interval"],
            &[0, 1],
            rows,
        ))
    }

    fn warnings(&self) -> Result<Vec<String>, Failure> {
        let mut warnings = Vec::new();
        if self.count() < FEW {
            let load = self.load(0.01)?;
            warnings.push(format!(
                "{} pellets are few: the load that breaks 1 % lies anywhere from {} to {} N, a factor of {}; crush 60 \
                 (ISO 4700)",
                self.count(),
                number(load.low),
                number(load.high),
                number(load.high / load.low)
            ));
        }
        let fit = &self.fits[self.chosen];
        if fit.goodness.is_doubtful() {
            warnings.push(format!(
                "the loads do not look {}: of a hundred such sheets {} lie farther from it; look for two kinds of pellets \
                 in one sheet, and do not trust small risks",
                self.law_name(),
                number(100.0 * fit.goodness.p_value)
            ));
        }
        let lowest = 1.0 / f64::from(self.count().max(1));
        if lowest > RISKS[0] {
            warnings.push(format!(
                "{} pellets show no risk below {} %: smaller ones rest on the shape of the distribution",
                self.count(),
                number(100.0 * lowest)
            ));
        }
        Ok(warnings)
    }

    pub(super) fn json(&self) -> Result<Value, Failure> {
        let fits = self.fits.iter().map(|fit| {
            json!({
                "distribution": name(fit.strength.scatter).to_lowercase(),
                "center_n": fit.center.best,
                "center_interval_n": [fit.center.low, fit.center.high],
                "shape": fit.shape.best,
                "shape_interval": [fit.shape.low, fit.shape.high],
                "distance": fit.goodness.distance,
                "p_value": fit.goodness.p_value,
            })
        });
        let loads = RISKS
            .map(|risk| {
                let load = self.load(risk)?;
                Ok(json!({
                    "risk": risk,
                    "load_n": load.best,
                    "load_interval_n": [load.low, load.high],
                }))
            })
            .into_iter()
            .collect::<Result<Value, Failure>>()?;
        let tumble = self.card.tumble.map(|tumble| {
            json!({"tumble_index": tumble.tumble_index, "abrasion_index": tumble.abrasion_index})
        });
        Ok(json!({
            "name": self.card.name,
            "source": self.card.source,
            "sample_size": self.count(),
            "test_diameter_m": self.card.strength.test_diameter,
            "distribution": self.law_name().to_lowercase(),
            "fits": fits.collect::<Value>(),
            "loads": loads,
            "drops": self.drops.as_ref().map(Drops::json).transpose()?,
            "tumble": tumble,
            "warnings": self.warnings()?,
        }))
    }
}

/// The bounds of an interval.
pub(super) fn between(value: Interval) -> String {
    format!("{} to {}", number(value.low), number(value.high))
}
