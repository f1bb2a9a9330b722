//! What two scenes say differently, key by key.

use crate::key_path::KeyPath;
use std::collections::BTreeMap;
use std::fmt;
use toml_edit::{Document, Item, TableLike, Value};

/// A key to which two scenes give different values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Dotted key, as in `time.end`.
    pub key: String,
    /// Its value in the first scene, as TOML; none where the key is not there.
    pub first: Option<String>,
    /// The same in the second.
    pub second: Option<String>,
}

/// The keys to which the texts of two scenes give different values, in order of the alphabet.
///
/// Comments and the order of keys make no difference. A text that is no TOML has no keys.
pub fn differences(first: &str, second: &str) -> Vec<Difference> {
    let (first, second) = (values_of(first), values_of(second));
    let keys = first
        .keys()
        .chain(second.keys().filter(|key| !first.contains_key(*key)));
    let mut differences: Vec<Difference> = keys
        .filter(|key| first.get(*key) != second.get(*key))
        .map(|key| Difference {
            key: key.clone(),
            first: first.get(key).cloned(),
            second: second.get(key).cloned(),
        })
        .collect();
    differences.sort_by(|a, b| a.key.cmp(&b.key));
    differences
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = |value: &Option<String>| value.clone().unwrap_or_else(|| "not given".into());
        write!(
            f,
            "{}: {}, now {}",
            self.key,
            value(&self.first),
            value(&self.second)
        )
    }
}

/// Every value of a text by its dotted key.
fn values_of(text: &str) -> BTreeMap<String, String> {
    let mut values = BTreeMap::new();
    if let Ok(document) = Document::parse(text) {
        enter_table(&KeyPath::of([""; 0]), document.as_table(), &mut values);
    }
    values
}

fn enter_table(path: &KeyPath, table: &dyn TableLike, values: &mut BTreeMap<String, String>) {
    for (key, item) in table.iter() {
        enter(&path.key(key), item, values);
    }
}

fn enter(path: &KeyPath, item: &Item, values: &mut BTreeMap<String, String>) {
    match item {
        Item::None => {}
        Item::Table(table) => enter_table(path, table, values),
        Item::Value(Value::InlineTable(table)) => enter_table(path, table, values),
        Item::ArrayOfTables(tables) => {
            for (index, table) in tables.iter().enumerate() {
                enter_table(&path.index(index), table, values);
            }
        }
        Item::Value(value) => {
            let bare = value.clone().decorated("", "");
            values.insert(path.to_string(), bare.to_string());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::differences;

    #[test]
    fn the_keys_that_differ_are_named_with_both_values() {
        let first = "[time]\nend = \"2 s\" # long\n[walls.cone]\nshape = { plane = { normal = [0, 0, 1] } }\n";
        let second =
            "[walls]\ncone.shape.plane.normal = [0, 1, 0]\n[time]\nend = \"3 s\"\nstep = 1e-5";
        let lines: Vec<String> = differences(first, second)
            .iter()
            .map(ToString::to_string)
            .collect();
        let expected = [
            "time.end: \"2 s\", now \"3 s\"",
            "time.step: not given, now 0.00001",
            "walls.cone.shape.plane.normal: [0, 0, 1], now [0, 1, 0]",
        ];
        assert_eq!(lines, expected);
    }

    #[test]
    fn comments_and_order_make_no_difference() {
        let first = "a = 1\nb = 2\n";
        let second = "# two of them\nb = 2\na = 1 # one\n";
        assert_eq!(differences(first, second), []);
    }
}
