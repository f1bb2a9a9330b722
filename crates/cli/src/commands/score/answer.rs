//! What `pelletflow score` says.

use super::Scored;
use super::groups::{Group, Groups};
use crate::table::{self, chosen, count, number};
use pelletflow_impact::strength::CONFIDENCE;
use pelletflow_impact::{Interval, Scatter, StrengthLaw};
use pelletflow_log::RecordedHits;
use serde_json::{Value, json};

/// Fewest steps of a hit whose peak force holds to some percent [-].
const FEW_STEPS: u64 = 8;

/// Share below which no distribution can be believed [-].
const LEAST_SHARE: f64 = 1.0e-6;

/// Shares of pellets broken, and what they rest on.
pub(super) struct Answer<'a> {
    recorded: &'a RecordedHits,
    told: String,
    has_energy: bool,
    has_damage: bool,
    has_interval: bool,
    as_simulated: &'a Scored,
    at_true_stiffness: &'a Scored,
    groups: Groups,
}

impl<'a> Answer<'a> {
    pub(super) fn new(
        recorded: &'a RecordedHits,
        law: &StrengthLaw,
        told: String,
        [as_simulated, at_true_stiffness]: [&'a Scored; 2],
        groups: Groups,
    ) -> Self {
        let (has_energy, has_damage, has_interval) = match law {
            StrengthLaw::Load(strength) => {
                let is_fixed = matches!(strength.scatter, Scatter::Fixed(_));
                (false, false, !is_fixed && strength.sample_size.is_some())
            }
            StrengthLaw::Energy(energy) => (
                true,
                energy.damage_constant.is_some(),
                energy.sample_size.is_some(),
            ),
        };
        Self {
            recorded,
            told,
            has_energy,
            has_damage,
            has_interval,
            as_simulated,
            at_true_stiffness,
            groups,
        }
    }

    /// Pellets that came into the run; all that were hit where the recording does not tell.
    fn pellets(&self) -> f64 {
        self.recorded.pellets.max(1) as f64
    }

    fn share(&self, broken: Interval) -> Interval {
        broken.map(|broken| (broken / self.pellets()).min(1.0))
    }

    /// Standard deviation of the number broken, by the luck of the draw of each pellet's strength, by the forces told [-].
    fn luck(&self) -> f64 {
        if self.recorded.is_softened {
            self.at_true_stiffness.luck()
        } else {
            self.as_simulated.luck()
        }
    }

    /// Hits in the sketch that are not recorded in full.
    fn unrecorded(&self) -> u64 {
        let classes = self.recorded.classes.values();
        classes.map(|class| class.count - class.kept).sum()
    }

    fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        if self.recorded.is_cut_off {
            warnings.push(format!(
                "the recording is cut off at {} s: hits after that are missing, and so are those then open",
                number(self.recorded.end)
            ));
        }
        if self.recorded.is_softened && !self.has_energy {
            warnings.push(
                "the run is softened: force grows as the power 2/5 of the modulus; of arrivals believe the line at true stiffness"
                    .into(),
            );
        }
        let breaking = |index: usize| self.as_simulated.score.best[index] > 0.0;
        let coarse = self
            .as_simulated
            .hits
            .iter()
            .enumerate()
            .filter(|&(blow, &hit)| breaking(blow) && self.recorded.hits[hit].steps < FEW_STEPS);
        let coarse = coarse.count();
        if coarse > 0 {
            warnings.push(format!(
                "{coarse} of the blows that may break a pellet lasted fewer than {FEW_STEPS} steps: their force is uncertain by some percent"
            ));
        }
        let unrecorded = self.unrecorded();
        if self.has_damage && unrecorded > 0 {
            warnings.push(format!(
                "{} weaker hits are not recorded in full and leave no damage here; lower `output.hits_above` to have them in it",
                count(unrecorded)
            ));
        }
        if !self.has_interval {
            warnings.push("no interval: the strength does not tell its sample size".into());
        }
        warnings.push(
            "slow crushing is not an impact, and the force is that of the contact law: read the limits of breakage in the guide"
                .into(),
        );
        warnings
    }

    pub(super) fn page(&self) -> String {
        let total = |name: &str, scored: &Scored| {
            let share = self.share(scored.broken());
            [
                name.to_owned(),
                percent(share.best),
                format!("{} to {}", percent(share.low), percent(share.high)),
                if share.best < LEAST_SHARE {
                    "0".into()
                } else {
                    number(scored.broken().best)
                },
            ]
        };
        let mut totals = vec![total("broken, by the forces of the run", self.as_simulated)];
        if !self.has_energy {
            totals.push(total(
                "broken, by those at true stiffness",
                self.at_true_stiffness,
            ));
        }
        let forces = if self.recorded.is_softened {
            "at true stiffness"
        } else {
            "of the run"
        };
        let mut sections = vec![
            format!(
                "{}\n{} pellets, {} hits, {} of them recorded in full",
                self.told,
                count(self.recorded.pellets),
                count(
                    self.recorded
                        .classes
                        .values()
                        .map(|class| class.count)
                        .sum()
                ),
                count(self.recorded.hits.len() as u64),
            ),
            table::listing(["", "share", "interval", "pellets"], &[1, 2, 3], totals),
        ];
        sections.push(format!("by the forces {forces}:"));
        for (title, groups) in [
            ("cause", &self.groups.by_cause),
            ("hit by", &self.groups.by_wall),
            ("size", &self.groups.by_size),
        ] {
            sections.push(self.listing(title, groups.iter()));
        }
        if !self.groups.by_place.is_empty() {
            let places: Vec<Group> = self
                .groups
                .by_place
                .iter()
                .map(|place| Group {
                    name: place.middle.map(|at| format!("{at:.3}")).join(", "),
                    ..place.group.clone()
                })
                .collect();
            let title = format!(
                "place: middle of a cube of {} m [m]",
                chosen(self.groups.cube_side)
            );
            sections.push(self.listing(&title, places.iter()));
        }
        let basis = if self.has_interval {
            format!(
                "interval: what the sample of the strength test leaves, {} %; ",
                chosen(100.0 * CONFIDENCE)
            )
        } else {
            String::new()
        };
        sections.push(format!(
            "{basis}the draw of {} strengths adds ± {} pellets (standard deviation)",
            count(self.recorded.pellets),
            number((10.0 * self.luck()).round() / 10.0)
        ));
        let warnings: Vec<String> = self
            .warnings()
            .iter()
            .map(|warning| format!("warning: {warning}"))
            .collect();
        sections.push(warnings.join("\n"));
        sections.join("\n\n")
    }

    fn listing<'g>(&self, title: &str, groups: impl Iterator<Item = &'g Group>) -> String {
        let rows = groups.map(|group| {
            let share = self.share(group.broken);
            [
                group.name.clone(),
                percent(share.best),
                format!("{} to {}", percent(share.low), percent(share.high)),
                count(group.blows),
                number(group.worst_force),
            ]
        });
        let header = [title, "broken", "interval", "blows", "worst [N]"];
        table::listing(header, &[1, 2, 3, 4], rows)
    }

    pub(super) fn json(&self) -> Value {
        let share = |broken: Interval| {
            let share = self.share(broken);
            json!({ "share": share.best, "interval": [share.low, share.high], "pellets": broken.best })
        };
        let group = |group: &Group| {
            let mut row = share(group.broken);
            row["name"] = json!(group.name);
            row["blows"] = json!(group.blows);
            row["worst_force_n"] = json!(group.worst_force);
            row
        };
        let groups = |groups: &[Group]| Value::Array(groups.iter().map(group).collect());
        let places = self.groups.by_place.iter().map(|place| {
            let mut row = group(&place.group);
            row["middle_m"] = json!(place.middle);
            row
        });
        let threshold = self.recorded.threshold;
        json!({
            "strength": self.told,
            "pellets": self.recorded.pellets,
            "hits": self.recorded.classes.values().map(|class| class.count).sum::<u64>(),
            "hits_recorded": self.recorded.hits.len(),
            "threshold_n": threshold.is_finite().then_some(threshold),
            "end_s": self.recorded.end,
            "is_cut_off": self.recorded.is_cut_off,
            "broken": share(self.as_simulated.broken()),
            "broken_at_true_stiffness": share(self.at_true_stiffness.broken()),
            "luck_pellets": self.luck(),
            "by_cause": groups(&self.groups.by_cause),
            "by_wall": groups(&self.groups.by_wall),
            "by_size": groups(&self.groups.by_size),
            "by_place": places.collect::<Vec<_>>(),
            "cube_side_m": self.groups.cube_side,
            "warnings": self.warnings(),
        })
    }
}

/// A share as it stands in a table: what is next to nothing is no number.
fn percent(share: f64) -> String {
    if share > 0.0 && share < LEAST_SHARE {
        format!("< {} %", chosen(100.0 * LEAST_SHARE))
    } else {
        format!("{} %", number(100.0 * share))
    }
}
