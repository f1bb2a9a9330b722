//! What a report tells of pellets that break: what a score tells, and which hits the replay marks.

use super::html::{put, table};
use super::{ReportError, ReportStrength};
use crate::breakage::{Breakage, Group, Share, scored, wall_name};
use crate::figures::{LEAST_SHARE, chosen, count, number, percent};
use crate::hits::read_hits;
use crate::markup::escaped;
use pelletflow_impact::{Scatter, Strength, StrengthLaw};
use pelletflow_sim::Hit;
use std::path::Path;

/// Hits that are marked at most [-].
const MARKED: usize = 1500;
/// Risks whose loads are drawn among the hits, and how they are named [-].
const DRAWN_RISKS: [(f64, &str); 2] = [(0.05, "5 %"), (0.5, "half")];

/// Pellets broken by the hits of a recording.
pub(super) struct Broken<'a> {
    strength: &'a ReportStrength<'a>,
    breakage: Breakage,
    /// Names of the walls, by index.
    walls: Vec<String>,
    /// Mean diameter of the pellets that were hit; no number where none was [m].
    diameter: f64,
    /// Hits that may break a pellet and how many pellets each breaks [-], the likeliest first.
    marked: Vec<(Hit, f64)>,
    /// How many hits may [-].
    hits: usize,
}

impl<'a> Broken<'a> {
    /// Holds the hits of a recording against a strength.
    pub(super) fn read(
        recording: &Path,
        strength: &'a ReportStrength<'a>,
    ) -> Result<Self, ReportError> {
        let recorded = read_hits(recording)?;
        let (breakage, broken_by) = scored(&recorded, &strength.request)?;
        let chances = recorded.hits.iter().copied().zip(broken_by);
        let mut marked: Vec<(Hit, f64)> = chances
            .filter(|(_, broken)| *broken > LEAST_SHARE)
            .collect();
        marked.sort_by(|(_, one), (_, other)| other.total_cmp(one));
        let hits = marked.len();
        marked.truncate(MARKED);
        let diameters: f64 = recorded.hits.iter().map(|hit| hit.diameter).sum();
        Ok(Self {
            strength,
            breakage,
            diameter: diameters / recorded.hits.len() as f64,
            walls: recorded.walls,
            marked,
            hits,
        })
    }

    /// Hits that are marked, and how many pellets each breaks [-].
    pub(super) fn marked(&self) -> &[(Hit, f64)] {
        &self.marked
    }

    /// How many of the hits that may break a pellet are not marked, in words.
    pub(super) fn omission(&self) -> Option<String> {
        let [shown, of] = [self.marked.len(), self.hits].map(|hits| count(hits as u64));
        (shown != of)
            .then(|| format!("{shown} of {of} places where pellets may break, the likeliest"))
    }

    /// The share broken, and what it is a share of.
    pub(super) fn key_figure(&self) -> (String, String) {
        let share = self.breakage.believed();
        let interval = match self.breakage.confidence {
            Some(_) => format!(", {}", between(share)),
            None => String::new(),
        };
        (
            percent(share.share),
            format!("of the pellets break{interval}"),
        )
    }

    /// How many pellets a wall, or where there is none another pellet, breaks.
    pub(super) fn by(&self, wall: Option<usize>) -> String {
        let name = wall_name(&self.walls, wall);
        let group = self
            .breakage
            .by_wall
            .iter()
            .find(|group| group.name == name);
        pellets(group.map_or(0.0, |group| group.broken.pellets))
    }

    /// Forces that break a share of the pellets [N], named; none where it is no force of the run that breaks them, and
    /// where none was hit.
    pub(super) fn loads(&self) -> Vec<(String, f64)> {
        let StrengthLaw::Load(strength) = &self.strength.request.law else {
            return Vec::new();
        };
        if self.breakage.is_softened || self.diameter.is_nan() {
            return Vec::new();
        }
        loads(strength, self.diameter)
    }

    /// What breaks, by cause, partner, size and place.
    pub(super) fn html(&self) -> String {
        let breakage = &self.breakage;
        let share = breakage.believed();
        let mut told = format!(
            "{}. Of {} pellets {} break, {}",
            self.strength.told,
            count(breakage.pellets),
            pellets(share.pellets),
            percent(share.share),
        );
        if let Some(confidence) = breakage.confidence {
            put(
                &mut told,
                format_args!(
                    " ({}: what the sample of the strength test leaves, {} %)",
                    between(share),
                    chosen(100.0 * confidence)
                ),
            );
        }
        if let Some(yielding) = &breakage.broken_yielding {
            let share = percent(yielding.share);
            put(&mut told, format_args!("; if they yield first, {share}"));
        }
        let side = chosen(1.0e3 * breakage.cube_side_m);
        let place = format!("cube of {side} mm around [m]");
        let groups = [
            ("cause", &breakage.by_cause),
            ("hit by", &breakage.by_wall),
            ("size", &breakage.by_size),
        ];
        let groups = groups
            .into_iter()
            .flat_map(|(what, groups)| groups.iter().map(move |group| (what, group)));
        let places = breakage.by_place.iter();
        let places = places.map(|found| (place.as_str(), &found.group));
        let rows: Vec<Vec<String>> = groups.chain(places).map(row).collect();
        let header = ["", "", "pellets broken", "share", "between", "worst [N]"];
        let told = escaped(&told);
        let mut html = format!("<h3>What breaks</h3><p>{told}.</p>");
        for warning in &breakage.warnings {
            let warning = escaped(warning);
            put(&mut html, format_args!("<p class=\"notice\">{warning}</p>"));
        }
        html.push_str(&table(&header, 2, &rows));
        html
    }
}

fn row((what, group): (&str, &Group)) -> Vec<String> {
    let broken = &group.broken;
    vec![
        what.to_owned(),
        group.name.clone(),
        pellets(broken.pellets),
        percent(broken.share),
        between(broken),
        number(group.worst_force_n),
    ]
}

/// A number of pellets that a chance makes, to hundredths.
fn pellets(expected: f64) -> String {
    number((100.0 * expected).round() / 100.0)
}

fn between(share: &Share) -> String {
    let [low, high] = share.interval;
    format!("{} to {}", percent(low), percent(high))
}

/// Forces that break a share of the pellets of a diameter [m], named [N].
fn loads(strength: &Strength, diameter: f64) -> Vec<(String, f64)> {
    // A strength that scored hits has a load at every risk.
    let load = |risk: f64| Some(strength.load(risk, diameter).ok()?.best);
    if let Scatter::Fixed(_) = strength.scatter {
        let named = |load| ("breaks a pellet".to_owned(), load);
        return load(0.5).map(named).into_iter().collect();
    }
    let drawn = DRAWN_RISKS.into_iter();
    drawn
        .filter_map(|(risk, name)| Some((format!("breaks {name}"), load(risk)?)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_card_is_drawn_by_its_quantiles_at_the_size_of_the_pellets() {
        let strength = Strength {
            scatter: Scatter::Weibull {
                scale: 1000.0,
                modulus: 3.0,
            },
            test_diameter: Some(0.010),
            sample_size: Some(60),
        };
        let drawn = loads(&strength, 0.012);
        // Weibull (1951): F = 1 − exp(−(P/P₀)^m), and d^(2 − 3/m) of the weakest link.
        let size = 1.2_f64.powf(2.0 - 3.0 / 3.0);
        for ((name, load), (risk, expected)) in drawn
            .iter()
            .zip([(0.05, "breaks 5 %"), (0.5, "breaks half")])
        {
            let exact = 1000.0 * size * (-(1.0_f64 - risk).ln()).powf(1.0 / 3.0);
            assert!((load - exact).abs() < 1.0e-9 * exact, "{load} {exact}");
            assert_eq!(name, expected);
        }
        assert_eq!(drawn.len(), 2);
    }

    #[test]
    fn a_load_is_drawn_once() {
        let strength = Strength {
            scatter: Scatter::Fixed(80.0),
            test_diameter: None,
            sample_size: None,
        };
        assert_eq!(
            loads(&strength, 0.012),
            [("breaks a pellet".to_owned(), 80.0)]
        );
    }
}
