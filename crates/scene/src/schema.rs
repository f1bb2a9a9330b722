//! The JSON Schema of a scene, made from the types that read it.

use crate::spec::SceneSpec;
use schemars::generate::SchemaSettings;
use schemars::transform::transform_subschemas;
use schemars::{JsonSchema, Schema};
use serde_json::Value;
use std::sync::LazyLock;

/// The schema, made once: it checks every scene.
pub(crate) static SCHEMA: LazyLock<Value> = LazyLock::new(schema_for::<SceneSpec>);

/// The schema of the types that read a file.
pub(crate) fn schema_for<Spec: JsonSchema>() -> Value {
    let mut settings = SchemaSettings::draft07();
    settings.transforms.push(Box::new(remove_null));
    settings
        .into_generator()
        .into_root_schema_for::<Spec>()
        .to_value()
}

/// The JSON Schema of a scene, draft 7. Quantities are a number in SI units or a text with a unit;
/// `x-quantity` tells what they measure.
pub fn schema() -> Value {
    SCHEMA.clone()
}

/// TOML has no null: a key is there or it is not.
fn remove_null(schema: &mut Schema) {
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|name| name != "null");
        if let [only] = types.as_slice() {
            let only = only.clone();
            schema.insert("type".into(), only);
        }
    }
    if let Some(Value::Array(choices)) = schema.get_mut("anyOf") {
        choices.retain(|choice| choice["type"] != "null");
        if let [only] = choices.as_slice() {
            let only = only.clone();
            schema.remove("anyOf");
            if let Value::Object(only) = only {
                // A description beside a reference would be ignored, so the reference is wrapped.
                if only.contains_key("$ref") && schema.as_object().is_some_and(|o| !o.is_empty()) {
                    schema.insert("allOf".into(), Value::Array(vec![Value::Object(only)]));
                } else if let Some(object) = schema.as_object_mut() {
                    for (key, value) in only {
                        object.entry(key).or_insert(value);
                    }
                }
            }
        }
    }
    if schema.get("default").is_some_and(Value::is_null) {
        schema.remove("default");
    }
    transform_subschemas(&mut remove_null, schema);
}
