//! Scenes from Python: a path or a dictionary, and values to set.

use crate::errors;
use pelletflow_scene::{Override, Scene, SceneError, text_of_file, text_of_tables};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyInt, PyMapping, PyString};
use serde::Serialize;
use serde_json::{Map, Number, Value};
use std::path::PathBuf;

/// Name of a scene that comes as a dictionary.
pub(crate) const NAME_OF_DICTIONARY: &str = "scene";

/// Method of a `Scene` that gives what it is made of.
const PARTS: &str = "_base_and_set";

/// A scene as Python gives it, with what is set in it; Python is needed no more to read it.
pub(crate) struct Given {
    base: Base,
    overrides: Vec<Override>,
}

enum Base {
    File(PathBuf),
    Tables(Value),
}

impl Given {
    /// Takes a path, a dictionary or a `Scene`, and values to set; these come last.
    pub(crate) fn new(
        scene: &Bound<'_, PyAny>,
        set: Option<&Bound<'_, PyMapping>>,
    ) -> PyResult<Self> {
        let mut given = if scene.hasattr(PARTS)? {
            let (base, own): (Bound<'_, PyAny>, Bound<'_, PyDict>) =
                scene.call_method0(PARTS)?.extract()?;
            Self::new(&base, Some(own.as_mapping()))?
        } else {
            let base = if let Ok(table) = scene.cast::<PyMapping>() {
                Base::Tables(value_of(table.as_any(), "")?)
            } else {
                Base::File(scene.extract()?)
            };
            Self {
                base,
                overrides: Vec::new(),
            }
        };
        if let Some(set) = set {
            given.overrides.extend(overrides(set)?);
        }
        Ok(given)
    }

    /// Reads and validates the scene.
    pub(crate) fn read(&self) -> Result<Scene, SceneError> {
        self.read_under(&self.overrides)
    }

    /// Reads and validates the scene with one more value set.
    pub(crate) fn read_with(&self, set: Override) -> Result<Scene, SceneError> {
        let overrides: Vec<_> = self.overrides.iter().cloned().chain([set]).collect();
        self.read_under(&overrides)
    }

    fn read_under(&self, overrides: &[Override]) -> Result<Scene, SceneError> {
        match &self.base {
            Base::File(path) => Scene::read(path, overrides),
            Base::Tables(tables) => Scene::from_value(tables, NAME_OF_DICTIONARY, overrides),
        }
    }

    /// The text of the scene, not validated.
    fn text(&self) -> Result<String, SceneError> {
        match &self.base {
            Base::File(path) => text_of_file(path, &self.overrides),
            Base::Tables(tables) => text_of_tables(tables, NAME_OF_DICTIONARY, &self.overrides),
        }
    }
}

/// Reads and validates a scene given as a path, a dictionary or a `Scene`.
pub(crate) fn read(
    scene: &Bound<'_, PyAny>,
    set: Option<&Bound<'_, PyMapping>>,
) -> PyResult<Scene> {
    let py = scene.py();
    let given = Given::new(scene, set)?;
    py.detach(|| given.read())
        .map_err(|error| errors::from_scene(py, error))
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
    facts.set_item("seed", read.setup.seed)?;
    Ok(facts)
}

/// The tables of a scene with what is set in them, not validated.
#[pyfunction]
#[pyo3(signature = (scene, set=None))]
pub(crate) fn scene_tables<'py>(
    scene: &Bound<'py, PyAny>,
    set: Option<&Bound<'py, PyMapping>>,
) -> PyResult<Bound<'py, PyAny>> {
    let py = scene.py();
    let given = Given::new(scene, set)?;
    let text = py.detach(|| given.text());
    let text = text.map_err(|error| errors::from_scene(py, error))?;
    let tables: toml::Table =
        toml::from_str(&text).map_err(|error| errors::from_value(py, "", &error.to_string()))?;
    python_from(py, &tables)
}

/// A value as a scene holds it: dictionaries, lists, numbers, texts and truth values, shared with nothing.
#[pyfunction]
pub(crate) fn scene_value<'py>(
    key: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    python_from(value.py(), &value_of(value, key)?)
}

/// The parts of a dotted key.
#[pyfunction]
pub(crate) fn parts_of(py: Python<'_>, key: &str) -> PyResult<Vec<String>> {
    pelletflow_scene::parts_of(key).map_err(|error| errors::from_override(py, key, &error))
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

/// Values to set, in order.
fn overrides(set: &Bound<'_, PyMapping>) -> PyResult<Vec<Override>> {
    set.items()?
        .iter()
        .map(|item| {
            let (key, value): (String, Bound<'_, PyAny>) = item.extract()?;
            Override::of_value(&key, &value_of(&value, &key)?)
                .map_err(|error| errors::from_override(set.py(), &key, &error))
        })
        .collect()
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
