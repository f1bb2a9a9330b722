//! Values set in place of a scene's: `walls.gate.opens_at="2 s"`.

use crate::key_path::KeyPath;
use crate::mistakes::Findings;
use serde::Serialize;
use std::fmt;
use std::str::FromStr;
use toml_edit::{DocumentMut, Item, Key, Table, Value};

/// A key of a scene and the value that it is to have in place of the file's.
///
/// ```
/// let set: pelletflow_scene::Override = "time.end=2 s".parse()?;
/// assert_eq!(set.key(), "time.end");
/// # Ok::<(), pelletflow_scene::OverrideError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Override {
    key: String,
    keys: Vec<String>,
    value: Value,
}

/// An override that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum OverrideError {
    /// There is no `=` in it.
    #[error("`{0}` has no `=`; write KEY=VALUE, for example time.end=\"2 s\"")]
    NoEquals(String),
    /// What stands before the `=` is no dotted key.
    #[error("`{0}` is not a dotted key such as walls.gate.opens_at")]
    NotAKey(String),
    /// The value of a key is nothing that a scene can hold.
    #[error("`{0}` is set to nothing; give it a value, or leave it out")]
    NoValue(String),
}

/// The parts of a dotted key, as TOML reads it: a name in quotes may hold dots.
///
/// # Errors
/// It is no dotted key.
pub fn parts_of(key: &str) -> Result<Vec<String>, OverrideError> {
    let parts = Key::parse(key).map_err(|_| OverrideError::NotAKey(key.into()))?;
    Ok(parts.iter().map(|part| part.get().to_owned()).collect())
}

/// The overrides that count, in order of their keys.
///
/// A later one takes the place of those before it that set its key, or a key in it.
/// What is left sets independent keys, or keys in a table that another one sets as a whole, which comes first: the text
/// that they make does not depend on the order in which they were given.
pub(crate) fn counting(overrides: &[Override]) -> Vec<&Override> {
    let mut counting: Vec<&Override> = Vec::new();
    for set in overrides {
        counting.retain(|earlier| !earlier.keys.starts_with(&set.keys));
        counting.push(set);
    }
    counting.sort_by(|one, other| one.keys.cmp(&other.keys));
    counting
}

impl FromStr for Override {
    type Err = OverrideError;

    fn from_str(text: &str) -> Result<Self, OverrideError> {
        // A quoted key may hold an equals sign, so the first one after a whole key counts.
        let equals: Vec<usize> = text.match_indices('=').map(|(index, _)| index).collect();
        if equals.is_empty() {
            return Err(OverrideError::NoEquals(text.into()));
        }
        equals
            .into_iter()
            .find_map(|index| {
                let keys = Key::parse(&text[..index]).ok()?;
                Some(Self::new(&keys, &text[..index], &text[index + 1..]))
            })
            .ok_or_else(|| {
                let key = text.split('=').next().unwrap_or_default();
                OverrideError::NotAKey(key.into())
            })
    }
}

impl fmt::Display for Override {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.key, self.value.to_string().trim())
    }
}

impl Override {
    /// A key and its value as JSON has it.
    ///
    /// # Errors
    /// The key is no dotted key, or the value is null or holds it: a key is left out by not setting it.
    pub fn of_value(key: &str, value: &serde_json::Value) -> Result<Self, OverrideError> {
        let value = value
            .serialize(toml_edit::ser::ValueSerializer::new())
            .map_err(|_| OverrideError::NoValue(key.into()))?;
        Ok(Self {
            key: key.trim().to_owned(),
            keys: parts_of(key)?,
            value,
        })
    }

    fn new(keys: &[Key], key: &str, value: &str) -> Self {
        let value = value.trim();
        Self {
            key: key.trim().to_owned(),
            keys: keys.iter().map(|key| key.get().to_owned()).collect(),
            // The shell eats quotes, so a text that is not TOML stands for itself.
            value: value.parse().unwrap_or_else(|_| Value::from(value)),
        }
    }

    /// The dotted key, as it was written.
    pub fn key(&self) -> &str {
        &self.key
    }

    pub(crate) fn path(&self) -> KeyPath {
        KeyPath::of(self.keys.iter().map(String::as_str))
    }

    /// Sets the value in a document, making the tables on the way.
    pub(crate) fn apply(&self, document: &mut DocumentMut, findings: &mut Findings) {
        let (last, tables) = self.keys.split_last().expect("a parsed key has a part");
        let mut item = document.as_item_mut();
        for key in tables {
            item = match step_into(item, key) {
                Ok(inner) => inner,
                Err(message) => return findings.add(&self.path(), message),
            };
        }
        let set = if item.is_array() {
            element(item, last).map(|element| *element = self.value.clone())
        } else if let Some(table) = item.as_table_like_mut() {
            // Decor of a replaced value, such as a comment behind it, is kept.
            let mut value = self.value.clone();
            if let Some(old) = table.get(last).and_then(Item::as_value) {
                *value.decor_mut() = old.decor().clone();
            }
            table.insert(last, Item::Value(value));
            Ok(())
        } else {
            Err(format!("`{last}` cannot be set: its parent is not a table"))
        };
        if let Err(message) = set {
            findings.add(&self.path(), message);
        }
    }
}

fn step_into<'d>(item: &'d mut Item, key: &str) -> Result<&'d mut Item, String> {
    if item.is_array() {
        return Err(format!(
            "`{key}` lies inside a list of lists or tables; set the whole list"
        ));
    }
    let is_inline = item.is_inline_table();
    let table = item
        .as_table_like_mut()
        .ok_or_else(|| format!("`{key}` cannot be set: its parent is not a table"))?;
    Ok(table.entry(key).or_insert_with(|| {
        if is_inline {
            Item::Value(toml_edit::InlineTable::new().into())
        } else {
            let mut table = Table::new();
            table.set_implicit(true);
            Item::Table(table)
        }
    }))
}

fn element<'d>(item: &'d mut Item, index: &str) -> Result<&'d mut Value, String> {
    let list = item.as_array_mut().ok_or("not a list")?;
    let count = list.len();
    index
        .parse::<usize>()
        .ok()
        .and_then(|index| list.get_mut(index))
        .ok_or_else(|| format!("`{index}` is no place in a list of {count}; count from 0"))
}
