//! `[expect]`.

use crate::named::Named;
use crate::quantity::Share;
use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde_json::Value;

/// What a right run shows, by dotted key of its summary.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[schemars(transform = with_any_keys)]
pub(crate) struct ExpectSpec {
    /// Share by which a number may differ where an entry gives a plain number [-]; 1e-9 where none is given.
    pub(crate) tolerance: Option<Share>,
    /// Entries by key.
    #[serde(flatten)]
    pub(crate) entries: Named<EntrySpec>,
}

/// What one key of the summary is to be.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(transform = with_any_keys)]
pub(crate) enum EntrySpec {
    /// Equal to a number, but for the tolerance.
    Number(f64),
    /// Equal to a text.
    Text(String),
    /// Equal to true or false.
    Truth(bool),
    /// A number within bounds.
    Condition(ConditionSpec),
    /// The keys below this one.
    Nested(Named<EntrySpec>),
}

/// Bounds of a number: `{ min, max }`, or `{ value }` with `relative` or `absolute`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConditionSpec {
    /// Least value.
    pub(crate) min: Option<f64>,
    /// Greatest value.
    pub(crate) max: Option<f64>,
    /// Value.
    pub(crate) value: Option<f64>,
    /// Share of the value by which it may differ [-].
    pub(crate) relative: Option<Share>,
    /// Amount by which it may differ, in the unit of the value.
    #[schemars(extend("minimum" = 0.0))]
    pub(crate) absolute: Option<f64>,
    /// Whether the value is known exactly, so that `pelletflow accuracy` may hold errors against it; false where left out.
    pub(crate) exact: Option<bool>,
}

/// Keys of a summary hold dots, as names of tables may not.
fn with_any_keys(schema: &mut Schema) {
    schema.remove("propertyNames");
    if let Some(Value::Array(choices)) = schema.get_mut("anyOf") {
        for choice in choices.iter_mut().filter_map(Value::as_object_mut) {
            choice.remove("propertyNames");
        }
    }
}
