//! The schema held against a scene: every departure is found, and stand-ins let the later checks go on.

mod bounds;
mod leaf;
mod table;

use crate::key_path::KeyPath;
use crate::mistakes::Findings;
use serde_json::Value as Schema;
use toml_edit::Value;

/// Checks a scene against its schema. Values that are wrong are replaced by stand-ins, so that what
/// else is wrong can be found; whole numbers written with a point become integers.
pub(crate) fn walk(schema: &Schema, scene: &mut Value) -> Findings {
    let mut walker = Walker {
        root: schema,
        findings: Findings::default(),
    };
    walker.visit(schema, scene, &KeyPath::root());
    walker.findings
}

struct Walker<'s> {
    root: &'s Schema,
    findings: Findings,
}

impl<'s> Walker<'s> {
    fn visit(&mut self, schema: &'s Schema, value: &mut Value, path: &KeyPath) {
        match self.form(schema) {
            Form::Quantity(schema) => self.quantity(schema, value, path),
            Form::Choice(names) => self.choice(&names, value, path),
            Form::Kinds(kinds) => self.kind(kinds, value, path),
            Form::Alternatives(alternatives) => self.alternative(alternatives, value, path),
            Form::Table(schema) => self.table(schema, value, path),
            Form::List(schema) => self.list(schema, value, path),
            Form::Number(schema) => self.number(schema, value, path),
            Form::Text => self.text(value, path),
            Form::Truth => self.truth(value, path),
        }
    }

    /// What a schema asks for, behind its references.
    fn form(&self, schema: &'s Schema) -> Form<'s> {
        let schema = self.behind_references(schema);
        if schema.get("x-quantity").is_some() {
            return Form::Quantity(schema);
        }
        if let Some(names) = names_of_choice(schema) {
            return Form::Choice(names);
        }
        if let Some(kinds) = schema["oneOf"].as_array() {
            return Form::Kinds(kinds);
        }
        if let Some(alternatives) = schema["anyOf"].as_array() {
            return Form::Alternatives(alternatives);
        }
        match schema["type"].as_str() {
            Some("object") => Form::Table(schema),
            Some("array") => Form::List(schema),
            Some("number" | "integer") => Form::Number(schema),
            Some("boolean") => Form::Truth,
            _ => Form::Text,
        }
    }

    fn behind_references(&self, schema: &'s Schema) -> &'s Schema {
        let mut schema = schema;
        loop {
            if let Some(reference) = schema["$ref"].as_str() {
                schema = self
                    .root
                    .pointer(reference.trim_start_matches('#'))
                    .expect("the generator defines what it refers to");
            } else if let Some([only]) = schema["allOf"].as_array().map(Vec::as_slice) {
                schema = only;
            } else {
                return schema;
            }
        }
    }

    /// The alternative that a value looks like; its type decides, and between tables their keys.
    fn alternative(&mut self, alternatives: &'s [Schema], value: &mut Value, path: &KeyPath) {
        let fitting: Vec<(&Schema, Form)> = alternatives
            .iter()
            .map(|schema| (schema, self.form(schema)))
            .filter(|(_, form)| form.takes(value))
            .collect();
        let keyed = fitting.iter().find(|(_, form)| form.knows_a_key_of(value));
        if let Some((schema, _)) = keyed.or(fitting.last()) {
            self.visit(schema, value, path);
        } else {
            let expected: Vec<String> = alternatives
                .iter()
                .map(|schema| self.form(schema).expected())
                .collect();
            let message = leaf::wrong_type(path, value, &expected.join(" or "));
            self.findings.add(path, message);
        }
    }
}

/// What a schema asks for.
enum Form<'s> {
    Quantity(&'s Schema),
    Choice(Vec<&'s str>),
    /// Tables told apart by their `kind`.
    Kinds(&'s [Schema]),
    Alternatives(&'s [Schema]),
    Table(&'s Schema),
    List(&'s Schema),
    Number(&'s Schema),
    Text,
    Truth,
}

impl Form<'_> {
    fn takes(&self, value: &Value) -> bool {
        match self {
            Self::Quantity(_) => value.is_integer() || value.is_float() || value.is_str(),
            Self::Choice(_) | Self::Text => value.is_str(),
            Self::Kinds(_) | Self::Table(_) => value.is_inline_table(),
            Self::List(_) => value.is_array(),
            Self::Number(_) => value.is_integer() || value.is_float(),
            Self::Truth => value.is_bool(),
            Self::Alternatives(_) => true,
        }
    }

    fn knows_a_key_of(&self, value: &Value) -> bool {
        let (Self::Table(schema), Some(table)) = (self, value.as_inline_table()) else {
            return false;
        };
        table
            .iter()
            .any(|(key, _)| schema["properties"].get(key).is_some())
    }

    fn expected(&self) -> String {
        match self {
            Self::Quantity(schema) => leaf::phrase(schema),
            Self::Choice(_) | Self::Text => "a text".into(),
            Self::Kinds(_) | Self::Table(_) | Self::Alternatives(_) => "a table".into(),
            Self::List(_) => "a list".into(),
            Self::Number(_) => "a number".into(),
            Self::Truth => "true or false".into(),
        }
    }
}

/// The names of an enumeration; each may have a description of its own.
fn names_of_choice(schema: &Schema) -> Option<Vec<&str>> {
    if let Some(names) = schema["enum"].as_array() {
        return names.iter().map(Schema::as_str).collect();
    }
    let choices = schema["oneOf"].as_array()?;
    let names: Option<Vec<Vec<&str>>> = choices
        .iter()
        .map(|choice| match choice["const"].as_str() {
            Some(name) => Some(vec![name]),
            None => choice["enum"]
                .as_array()
                .and_then(|names| names.iter().map(Schema::as_str).collect()),
        })
        .collect();
    names.map(|names| names.concat())
}
