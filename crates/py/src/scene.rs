//! Scenes from Python: a path or a dictionary, and values to set.

use crate::errors;
use pelletflow_scene::{Override, Scene};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyMapping, PyString};
use serde::Serialize;
use serde_json::{Map, Number, Value};
use std::path::PathBuf;

/// Name of a scene that comes as a dictionary.
pub(crate) const NAME_OF_DICTIONARY: &str = "scene";

/// Method of a `Scene` that gives what it is made of.
const PARTS: &str = "_base_and_set";

/// Reads and validates a scene given as a path or a dictionary.
pub(crate) fn read(
    scene: &Bound<'_, PyAny>,
    set: Option<&Bound<'_, PyMapping>>,
) -> PyResult<Scene> {
    let py = scene.py();
    if scene.hasattr(PARTS)? {
        // A `Scene`: what it is made of, with what is set in it.
        let (base, own): (Bound<'_, PyAny>, Bound<'_, PyDict>) =
            scene.call_method0(PARTS)?.extract()?;
        if let Some(set) = set {
            own.update(set)?;
        }
        return read(&base, Some(own.as_mapping()));
    }
    let overrides = overrides(py, set)?;
    let result = if let Ok(table) = scene.cast::<PyMapping>() {
        let value = value_of(table.as_any(), "")?;
        py.detach(|| Scene::from_value(&value, NAME_OF_DICTIONARY, &overrides))
    } else {
        let path: PathBuf = scene.extract()?;
        py.detach(|| Scene::read(&path, &overrides))
    };
    result.map_err(|error| errors::from_scene(py, error))
}

/// Validates a scene: its name, title, hash, text with all that was set, and what was chosen for the user.
#[pyfunction]
#[pyo3(signature = (scene, set=None))]
pub(crate) fn scene<'py>(
    scene: &Bound<'py, PyAny>,
    set: Option<&Bound<'py, PyMapping>>,
) -> PyResult<Bound<'py, PyDict>> {
    let py = scene.py();
    let read = read(scene, set)?;
    let facts = PyDict::new(py);
    facts.set_item("name", read.name)?;
    facts.set_item("title", read.title)?;
    facts.set_item("hash", read.hash)?;
    facts.set_item("text", read.text)?;
    facts.set_item("notes", read.notes)?;
    Ok(facts)
}

/// The tables of a TOML text as dictionaries.
#[pyfunction]
pub(crate) fn toml_table<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    let table: toml::Table =
        toml::from_str(text).map_err(|error| errors::from_value(py, "", &error.to_string()))?;
    python_from(py, &table)
}

/// The JSON Schema of a scene.
#[pyfunction]
pub(crate) fn schema(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    python_from(py, &pelletflow_scene::schema())
}

/// A value of ours as Python's dictionaries, lists, numbers and texts.
pub(crate) fn python_from<'py>(
    py: Python<'py>,
    value: &impl Serialize,
) -> PyResult<Bound<'py, PyAny>> {
    let text = serde_json::to_string(value).expect("our summaries and ledgers have text keys only");
    py.import("json")?.call_method1("loads", (text,))
}

fn overrides(py: Python<'_>, set: Option<&Bound<'_, PyMapping>>) -> PyResult<Vec<Override>> {
    let Some(set) = set else {
        return Ok(Vec::new());
    };
    let mut overrides = Vec::new();
    for item in set.items()? {
        let (key, value): (String, Bound<'_, PyAny>) = item.extract()?;
        let text = toml_text(&value_of(&value, &key)?);
        let parsed: Result<Override, _> = format!("{key}={text}").parse();
        overrides.push(parsed.map_err(|error| errors::from_override(py, &error))?);
    }
    Ok(overrides)
}

/// A Python value as the scene knows values; `key` says where it stands.
fn value_of(value: &Bound<'_, PyAny>, key: &str) -> PyResult<Value> {
    if value.is_none() {
        return Ok(Value::Null);
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(Value::String(text.extract()?));
    }
    if value.is_instance_of::<PyBool>() {
        return Ok(Value::Bool(value.extract()?));
    }
    if let Ok(table) = value.cast::<PyMapping>() {
        let mut map = Map::new();
        for item in table.items()? {
            let (name, value): (String, Bound<'_, PyAny>) = item.extract()?;
            let place = if key.is_empty() {
                name.clone()
            } else {
                format!("{key}.{name}")
            };
            map.insert(name, value_of(&value, &place)?);
        }
        return Ok(Value::Object(map));
    }
    if let Some(number) = number_of(value) {
        return Ok(Value::Number(number));
    }
    // Lists, tuples and arrays alike.
    let Ok(items) = value.try_iter() else {
        let message = format!(
            "is {}; expected a finite number, a text, a truth value, a list or a dictionary",
            value.repr()?
        );
        return Err(errors::from_value(value.py(), key, &message));
    };
    items
        .enumerate()
        .map(|(index, item)| value_of(&item?, &format!("{key}[{index}]")))
        .collect::<PyResult<Vec<_>>>()
        .map(Value::Array)
}

/// Python's and NumPy's finite numbers; whole ones stay whole.
fn number_of(value: &Bound<'_, PyAny>) -> Option<Number> {
    if value.is_instance_of::<PyInt>() || value.hasattr("__index__").ok()? {
        return value.extract::<i64>().ok().map(Number::from);
    }
    value.extract::<f64>().ok().and_then(Number::from_f64)
}

/// A value as TOML writes it.
fn toml_text(value: &Value) -> String {
    match value {
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(toml_text).collect();
            format!("[{}]", items.join(", "))
        }
        Value::Object(table) => {
            let rows: Vec<String> = table
                .iter()
                .map(|(key, value)| format!("{} = {}", Value::from(key.as_str()), toml_text(value)))
                .collect();
            format!("{{{}}}", rows.join(", "))
        }
        // The rest is written alike in JSON and TOML.
        plain => plain.to_string(),
    }
}
