//! Tables and lists: their keys, their kinds, their lengths.

use super::{Walker, leaf};
use crate::key_path::KeyPath;
use crate::named::is_plain_name;
use crate::suggest;
use serde_json::Value as Schema;
use toml_edit::{InlineTable, Value};

impl<'s> Walker<'s> {
    pub(super) fn table(&mut self, schema: &'s Schema, value: &mut Value, path: &KeyPath) {
        let Value::InlineTable(table) = value else {
            let message = leaf::wrong_type(path, value, "a table");
            self.findings.add(path, message);
            *value = InlineTable::new().into();
            return;
        };
        let mut unknown = Vec::new();
        for (key, value) in table.iter_mut() {
            let key = key.get();
            let path = path.key(key);
            if let Some(schema) = schema["properties"].get(key) {
                self.visit(schema, value, &path);
            } else if schema["additionalProperties"].is_object() {
                if schema.get("propertyNames").is_some() && !is_plain_name(key) {
                    self.findings.add(
                        &path,
                        format!("`{key}` cannot be a name; use letters, digits, `-` and `_`"),
                    );
                }
                self.visit(&schema["additionalProperties"], value, &path);
            } else {
                unknown.push(key.to_owned());
                self.unknown_key(schema, key, &path);
            }
        }
        for key in &unknown {
            table.remove(key);
        }
        self.required(schema, table, &unknown, path);
    }

    fn unknown_key(&mut self, schema: &Schema, key: &str, path: &KeyPath) {
        let known: Vec<&str> = schema["properties"]
            .as_object()
            .map(|properties| properties.keys().map(String::as_str).collect())
            .unwrap_or_default();
        let message = format!("unknown key `{key}`; {}", suggest::instead(key, &known));
        self.findings.add(path, message);
    }

    /// Asks for the keys that must be there, but for those that only seem to be misspelt.
    fn required(
        &mut self,
        schema: &'s Schema,
        table: &mut InlineTable,
        unknown: &[String],
        path: &KeyPath,
    ) {
        let required = schema["required"].as_array().map_or(&[][..], Vec::as_slice);
        for key in required.iter().filter_map(Schema::as_str) {
            if table.contains_key(key) {
                continue;
            }
            let property = self.behind_references(&schema["properties"][key]);
            let is_misspelt = unknown
                .iter()
                .any(|other| suggest::nearest(other, [key]).is_some());
            if !is_misspelt {
                let example = leaf::example(key, property);
                self.findings
                    .add(&path.key(key), format!("`{key}` is missing; {example}"));
            }
            if let Some(stand_in) = leaf::stand_in(property) {
                table.insert(key, stand_in);
            }
        }
    }

    /// A table that its `kind` tells from others.
    pub(super) fn kind(&mut self, kinds: &'s [Schema], value: &mut Value, path: &KeyPath) {
        let names: Vec<&str> = kinds
            .iter()
            .filter_map(|kind| kind["properties"]["kind"]["const"].as_str())
            .collect();
        let Some(table) = value.as_inline_table() else {
            let expected = format!("a table with `kind`, one of {}", suggest::list(names));
            let message = leaf::wrong_type(path, value, &expected);
            self.findings.add(path, message);
            return;
        };
        let path_of_kind = path.key("kind");
        match table.get("kind") {
            None => self.findings.add(
                &path_of_kind,
                format!("`kind` is missing; expected {}", suggest::list(names)),
            ),
            Some(Value::String(name)) => {
                let name = name.value().as_str();
                if let Some(place) = names.iter().position(|known| *known == name) {
                    self.table(&kinds[place], value, path);
                } else {
                    let cure = suggest::instead(name, &names);
                    self.findings
                        .add(&path_of_kind, format!("unknown kind `{name}`; {cure}"));
                }
            }
            Some(other) => {
                let message = leaf::wrong_type(&path_of_kind, other, &suggest::list(names));
                self.findings.add(&path_of_kind, message);
            }
        }
    }

    pub(super) fn list(&mut self, schema: &'s Schema, value: &mut Value, path: &KeyPath) {
        let least = schema["minItems"].as_u64().unwrap_or(0) as usize;
        let most = schema["maxItems"].as_u64().map(|most| most as usize);
        let expected = match most {
            Some(most) if most == least => format!("a list of {least} values"),
            _ if least > 0 => format!("a list of at least {least}"),
            _ => "a list".into(),
        };
        let Value::Array(list) = value else {
            let message = leaf::wrong_type(path, value, &expected);
            self.findings.add(path, message);
            return;
        };
        if list.len() < least || most.is_some_and(|most| list.len() > most) {
            let key = path.last_key();
            let message = format!("`{key}` has {} values; expected {expected}", list.len());
            self.findings.add(path, message);
        }
        for (index, item) in list.iter_mut().enumerate() {
            self.visit(&schema["items"], item, &path.index(index));
        }
    }
}
