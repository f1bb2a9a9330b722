//! What a right run shows, held against its summary.

use crate::key_path::KeyPath;
use crate::mistakes::Findings;
use crate::named::Named;
use crate::number::show;
use crate::spec::expect::{ConditionSpec, EntrySpec, ExpectSpec};
use serde_json::Value;
use std::fmt;

/// Share by which equal numbers may differ where nothing is said: rounding, not physics [-].
const TOLERANCE: f64 = 1.0e-9;

/// The expectations of a scene.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Expectations(Vec<Expectation>);

/// How one expectation came out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExpectationOutcome {
    /// Dotted key of the summary, such as `mass.lost`.
    pub key: String,
    /// What was expected, ready to print.
    pub expected: String,
    /// What was found, ready to print; `nothing` where the summary has no such key.
    pub found: String,
    /// Whether the two agree.
    pub is_met: bool,
}

#[derive(Debug, Clone, PartialEq)]
struct Expectation {
    key: String,
    demand: Demand,
}

#[derive(Debug, Clone, PartialEq)]
enum Demand {
    Text(String),
    Truth(bool),
    Near {
        value: f64,
        within: f64,
        is_exact: bool,
    },
    Between {
        min: f64,
        max: f64,
    },
}

impl Expectations {
    pub(crate) fn resolve(spec: &ExpectSpec, findings: &mut Findings) -> Self {
        let tolerance = spec.tolerance.map_or(TOLERANCE, |share| share.0);
        let mut expectations = Vec::new();
        let path = KeyPath::of(["expect"]);
        collect(
            &spec.entries,
            "",
            &path,
            tolerance,
            &mut expectations,
            findings,
        );
        Self(expectations)
    }

    /// Whether nothing is expected.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Keys of the summary whose values are known exactly, with these, each in the unit of its key.
    pub fn exact(&self) -> Vec<(String, f64)> {
        self.0
            .iter()
            .filter_map(|Expectation { key, demand }| match demand {
                Demand::Near {
                    value,
                    is_exact: true,
                    ..
                } => Some((key.clone(), *value)),
                _ => None,
            })
            .collect()
    }

    /// Holds every expectation against a summary.
    pub fn check(&self, summary: &Value) -> Vec<ExpectationOutcome> {
        self.0
            .iter()
            .map(|Expectation { key, demand }| {
                let found = lookup(summary, key);
                ExpectationOutcome {
                    key: key.clone(),
                    expected: demand.to_string(),
                    found: found.map_or_else(|| "nothing".into(), |found| shown(found, demand)),
                    is_met: found.is_some_and(|found| demand.is_met_by(found)),
                }
            })
            .collect()
    }
}

fn collect(
    entries: &Named<EntrySpec>,
    prefix: &str,
    path: &KeyPath,
    tolerance: f64,
    expectations: &mut Vec<Expectation>,
    findings: &mut Findings,
) {
    for (key, entry) in entries.iter() {
        let path = path.key(key);
        let key = format!("{prefix}{key}");
        let demand = match entry {
            EntrySpec::Nested(entries) => {
                let prefix = format!("{key}.");
                collect(entries, &prefix, &path, tolerance, expectations, findings);
                continue;
            }
            EntrySpec::Text(text) => Demand::Text(text.clone()),
            EntrySpec::Truth(truth) => Demand::Truth(*truth),
            EntrySpec::Number(value) => Demand::Near {
                value: *value,
                within: tolerance * value.abs(),
                is_exact: false,
            },
            EntrySpec::Condition(condition) => match demand_of(condition, tolerance) {
                Ok(demand) => demand,
                Err(message) => {
                    findings.add(&path, message);
                    continue;
                }
            },
        };
        expectations.push(Expectation { key, demand });
    }
}

fn demand_of(condition: &ConditionSpec, tolerance: f64) -> Result<Demand, &'static str> {
    let has_bounds = condition.min.is_some() || condition.max.is_some();
    let has_margin = condition.relative.is_some() || condition.absolute.is_some();
    match condition.value {
        Some(_) if has_bounds => {
            Err("`value` goes with `relative` or `absolute`, not with `min` and `max`")
        }
        None if has_margin => Err("`relative` and `absolute` need a `value`"),
        None if condition.exact.is_some() => Err("`exact` needs a `value`"),
        Some(_) if condition.relative.is_some() && condition.absolute.is_some() => {
            Err("`relative` and `absolute` are both given; keep one")
        }
        Some(value) => Ok(Demand::Near {
            value,
            within: match (condition.absolute, &condition.relative) {
                (Some(absolute), _) => absolute,
                (None, Some(relative)) => relative.0 * value.abs(),
                (None, None) => tolerance * value.abs(),
            },
            is_exact: condition.exact == Some(true),
        }),
        None if !has_bounds => Err("nothing is expected; give `min`, `max` or `value`"),
        None => {
            let min = condition.min.unwrap_or(f64::NEG_INFINITY);
            let max = condition.max.unwrap_or(f64::INFINITY);
            if min > max {
                return Err("`min` is above `max`, so that nothing meets it; exchange them");
            }
            Ok(Demand::Between { min, max })
        }
    }
}

/// The value of a dotted key; a name of the summary may hold dots itself, so the longest match goes first.
fn lookup<'v>(value: &'v Value, key: &str) -> Option<&'v Value> {
    if let Some(index) = key.parse::<usize>().ok().filter(|_| value.is_array()) {
        return value.get(index);
    }
    if let Some(found) = value.get(key) {
        return Some(found);
    }
    key.rmatch_indices('.').find_map(|(dot, _)| {
        let (head, tail) = (&key[..dot], &key[dot + 1..]);
        let inner = match head.parse::<usize>() {
            Ok(index) if value.is_array() => value.get(index),
            _ => value.get(head),
        };
        lookup(inner?, tail)
    })
}

/// A value to print; its last digits are left out where the verdict is the same without them.
fn shown(value: &Value, demand: &Demand) -> String {
    match value {
        Value::Number(number) => {
            let rounded = number
                .as_f64()
                .and_then(|exact| format!("{exact:.6e}").parse::<f64>().ok())
                .filter(|&rounded| demand.is_met_by(&rounded.into()) == demand.is_met_by(value));
            rounded.map_or_else(|| number.to_string(), show)
        }
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

impl Demand {
    fn is_met_by(&self, found: &Value) -> bool {
        match self {
            Self::Text(text) => found.as_str() == Some(text),
            Self::Truth(truth) => found.as_bool() == Some(*truth),
            Self::Near { value, within, .. } => found
                .as_f64()
                .is_some_and(|found| (found - value).abs() <= *within),
            Self::Between { min, max } => found
                .as_f64()
                .is_some_and(|found| (*min..=*max).contains(&found)),
        }
    }
}

impl fmt::Display for Demand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Truth(truth) => write!(f, "{truth}"),
            Self::Near { value, within, .. } if *within <= TOLERANCE * value.abs() => {
                f.write_str(&show(*value))
            }
            Self::Near { value, within, .. } => write!(f, "{} ± {}", show(*value), show(*within)),
            Self::Between { min, max } if max.is_infinite() => write!(f, "at least {}", show(*min)),
            Self::Between { min, max } if min.is_infinite() => write!(f, "at most {}", show(*max)),
            Self::Between { min, max } => write!(f, "{} to {}", show(*min), show(*max)),
        }
    }
}
