//! Single values: quantities, numbers, texts.

use super::{Walker, bounds};
use crate::key_path::KeyPath;
use crate::number::show;
use crate::suggest;
use crate::units::{self, Kind, UnitError};
use serde_json::Value as Schema;
use toml_edit::Value;

/// Taken for a quantity that is missing or wrong, so that the checks can go on.
const STAND_IN: f64 = 1.0;

/// Largest whole number that may be written with a point or an exponent: of larger ones not all have a number of their own.
const LARGEST_WHOLE: f64 = 1e15;

/// What to take for a missing key; tables and lists have no stand-in.
pub(super) fn stand_in(schema: &Schema) -> Option<Value> {
    if schema.get("x-quantity").is_some() {
        return Some(STAND_IN.into());
    }
    match schema["type"].as_str()? {
        "number" => Some(STAND_IN.into()),
        "integer" => Some(whole_stand_in(true)),
        "string" => Some("".into()),
        _ => None,
    }
}

impl Walker<'_> {
    pub(super) fn quantity(&mut self, schema: &Schema, value: &mut Value, path: &KeyPath) {
        if let Err(message) = check_quantity(schema, value, path) {
            self.findings.add(path, message);
            *value = STAND_IN.into();
        }
    }

    pub(super) fn number(&mut self, schema: &Schema, value: &mut Value, path: &KeyPath) {
        let is_whole = schema["type"] == "integer";
        let expected = if is_whole {
            "a whole number"
        } else {
            "a number"
        };
        let Some(number) = plain_number(value) else {
            let message = wrong_type(path, value, expected);
            self.findings.add(path, message);
            *value = whole_stand_in(is_whole);
            return;
        };
        let key = path.last_key();
        let shown = show(number);
        let message = if !number.is_finite() {
            Some(format!("`{key}` is {shown}; expected {expected}"))
        } else if is_whole && number.fract() != 0.0 {
            Some(format!("`{key}` is {shown}; expected a whole number"))
        } else if is_whole && value.is_float() && number.abs() > LARGEST_WHOLE {
            let largest = show(LARGEST_WHOLE);
            Some(format!("`{key}` is {shown}; expected at most {largest}"))
        } else {
            bounds::broken(schema, number, "")
                .map(|expected| format!("`{key}` is {shown}; expected {expected}"))
        };
        if let Some(message) = message {
            self.findings.add(path, message);
            *value = whole_stand_in(is_whole);
        } else if is_whole && value.is_float() {
            *value = (number as i64).into();
        }
    }

    pub(super) fn choice(&mut self, names: &[&str], value: &mut Value, path: &KeyPath) {
        let message = match value.as_str() {
            Some(name) if names.contains(&name) => return,
            Some(name) => {
                let key = path.last_key();
                format!("unknown {key} `{name}`; {}", suggest::instead(name, names))
            }
            None => wrong_type(path, value, &suggest::list(names.iter().copied())),
        };
        self.findings.add(path, message);
        *value = names.first().copied().unwrap_or_default().into();
    }

    pub(super) fn text(&mut self, value: &mut Value, path: &KeyPath) {
        if !value.is_str() {
            let message = wrong_type(path, value, "a text in quotes");
            self.findings.add(path, message);
            *value = "".into();
        }
    }

    pub(super) fn truth(&mut self, value: &mut Value, path: &KeyPath) {
        if !value.is_bool() {
            let message = wrong_type(path, value, "true or false");
            self.findings.add(path, message);
            *value = true.into();
        }
    }
}

fn whole_stand_in(is_whole: bool) -> Value {
    if is_whole { 1.into() } else { STAND_IN.into() }
}

fn plain_number(value: &Value) -> Option<f64> {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|integer| integer as f64))
}

fn check_quantity(schema: &Schema, value: &Value, path: &KeyPath) -> Result<(), String> {
    let key = path.last_key();
    let kinds = kinds(schema);
    let phrase = phrase(schema);
    let example = kinds[0].example();
    let (number, kind) = match value {
        Value::String(text) => {
            let text = text.value();
            units::parse(text, &kinds).map_err(|error| match error {
                UnitError::NoUnit => format!(
                    "`{key}` is {phrase}; \"{text}\" has no unit; write for example \"{example}\", or {text} without \
                     quotes for {}",
                    kinds[0].si()
                ),
                _ => format!("`{key}` is {phrase}; `{text}` {error}; write for example \"{example}\""),
            })?
        }
        other => plain_number(other)
            .map(|number| (number, kinds[0]))
            .ok_or_else(|| {
                let expected = format!("{phrase}, for example \"{example}\"");
                wrong_type(path, other, &expected)
            })?,
    };
    let shown = value.clone().decorated("", "");
    if !number.is_finite() {
        return Err(format!(
            "`{key}` is {shown}; expected a finite number, for example \"{example}\""
        ));
    }
    match bounds::broken(schema, number, kind.si()) {
        None => Ok(()),
        Some(expected) => Err(format!("`{key}` is {shown}; expected {expected}")),
    }
}

fn kinds(schema: &Schema) -> Vec<Kind> {
    let names = schema["x-quantity"].as_array().expect("a list of kinds");
    names
        .iter()
        .filter_map(|name| Kind::named(name.as_str()?))
        .collect()
}

/// What a quantity is, in a sentence: `a mass flow or a number per time`.
pub(super) fn phrase(schema: &Schema) -> String {
    let phrases: Vec<&str> = kinds(schema).iter().map(|kind| kind.phrase()).collect();
    phrases.join(" or ")
}

/// How to write a key that is missing.
pub(super) fn example(key: &str, schema: &Schema) -> String {
    if let Some(example) = schema["examples"][0].as_str() {
        return format!("write for example `{key} = \"{example}\"`");
    }
    if let Some(only) = schema.get("const") {
        return format!("write `{key} = {only}`");
    }
    let value = match schema["type"].as_str() {
        Some("number") => "a number",
        Some("integer") => "a whole number",
        Some("string") => "a name in quotes",
        Some("array") => "a list",
        Some("boolean") => "true or false",
        _ => "a table",
    };
    match schema["description"].as_str() {
        Some(description) => {
            let first = description.lines().next().unwrap_or_default();
            format!("expected {value}: {}", first.trim_end_matches('.'))
        }
        None => format!("expected {value}"),
    }
}

pub(super) fn wrong_type(path: &KeyPath, value: &Value, expected: &str) -> String {
    let found = match value {
        Value::String(text) => format!("the text \"{}\"", text.value()),
        Value::Integer(_) | Value::Float(_) => {
            format!("the number {}", value.clone().decorated("", ""))
        }
        Value::Boolean(truth) => format!("{}", truth.value()),
        Value::Datetime(date) => format!("the date {}", date.value()),
        Value::Array(_) => "a list".into(),
        Value::InlineTable(_) => "a table".into(),
    };
    format!("`{}` is {found}; expected {expected}", path.last_key())
}
