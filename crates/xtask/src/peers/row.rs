//! One line of the result.

use super::case::{Case, Target};
use super::race::Spread;
use serde_json::{Value, json};

/// What a case gave.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) case: Case,
    /// Our speed [million pellet-steps/s].
    pub(crate) ours: f64,
    /// What it is held against.
    pub(crate) other: String,
    /// The speed of that [million pellet-steps/s].
    pub(crate) theirs: Option<f64>,
    /// The figure that has a target.
    pub(crate) ratio: Spread,
    pub(crate) error: AnswerError,
}

/// How far off the answers are.
#[derive(Debug, Clone)]
pub(crate) struct AnswerError {
    /// Ours, in a measure of its own [-].
    pub(crate) ours: f64,
    /// Theirs in the same measure [-], where it says something.
    pub(crate) theirs: Option<f64>,
    /// What it is the error of.
    pub(crate) of: String,
}

impl Row {
    /// For programs.
    pub(crate) fn json(&self) -> Value {
        let (bound, target, unit) = match self.case.target {
            Target::AtLeast(least) => ("at least", least, ""),
            Target::AtMost(most, unit) => ("at most", most, unit),
        };
        json!({
            "case": self.case.name,
            "ours": self.ours,
            "other": self.other,
            "theirs": self.theirs,
            "ratio": self.ratio.median,
            "least": self.ratio.least,
            "greatest": self.ratio.greatest,
            "target": target,
            "bound": bound,
            "unit": unit,
            "met": self.case.target.is_met(self.ratio.median),
            "error": self.error.ours,
            "error_theirs": self.error.theirs,
            "error_of": self.error.of,
        })
    }

    /// For people.
    pub(crate) fn cells(&self) -> [String; 9] {
        let Spread {
            median,
            least,
            greatest,
        } = self.ratio;
        let (target, unit) = match self.case.target {
            Target::AtLeast(least) => (format!("≥ {least}"), ""),
            Target::AtMost(most, unit) => (format!("≤ {most} {unit}"), unit),
        };
        let met = if self.case.target.is_met(median) {
            "yes"
        } else {
            "no"
        };
        let theirs = self.theirs.map_or(String::new(), three_digits);
        let spread = format!(
            "{} {unit} ({} to {})",
            three_digits(median),
            three_digits(least),
            three_digits(greatest)
        );
        [
            format!("`{}`", self.case.name),
            three_digits(self.ours),
            self.other.clone(),
            theirs,
            spread.replace("  ", " "),
            target.trim().to_owned(),
            met.to_owned(),
            format!("{:.1e}", self.error.ours)
                + &self
                    .error
                    .theirs
                    .map_or(String::new(), |theirs| format!(" / {theirs:.1e}")),
            self.error.of.clone(),
        ]
    }
}

/// A number with three digits that count.
fn three_digits(number: f64) -> String {
    let digits = if number.abs() >= 100.0 {
        0
    } else if number.abs() >= 10.0 {
        1
    } else if number.abs() >= 1.0 {
        2
    } else {
        3
    };
    format!("{number:.digits$}")
}
