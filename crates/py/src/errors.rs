//! Errors as the exceptions of `pelletflow.errors`.

use crate::scene::{NAME_OF_DICTIONARY, python_from};
use pelletflow_log::RunError;
use pelletflow_scene::{Mistake, Mistakes, OverrideError, Place, SceneError};
use pelletflow_sim::StepError;
use pyo3::prelude::*;
use pyo3::types::PyList;

/// A scene that cannot be had, as `SceneError`; an unreadable file is its cause.
pub(crate) fn from_scene(py: Python<'_>, error: SceneError) -> PyErr {
    match error {
        SceneError::Invalid(mistakes) => from_mistakes(py, &mistakes),
        SceneError::Unreadable { ref path, .. } => {
            let mistake = Mistake {
                file: path.display().to_string(),
                place: Place::Whole,
                key: String::new(),
                message: error.to_string(),
            };
            let raised = scene_error(py, &error.to_string(), [&mistake]);
            if let SceneError::Unreadable { source, .. } = error {
                raised.set_cause(py, Some(source.into()));
            }
            raised
        }
    }
}

/// The mistakes of a scene, as `SceneError`.
pub(crate) fn from_mistakes(py: Python<'_>, mistakes: &Mistakes) -> PyErr {
    scene_error(py, &mistakes.to_string(), mistakes)
}

/// A key of `set` that is none, as `SceneError`.
pub(crate) fn from_override(py: Python<'_>, error: &OverrideError) -> PyErr {
    scene_error(py, &error.to_string(), [])
}

/// A Python value that no scene can hold, as `SceneError`.
pub(crate) fn from_value(py: Python<'_>, key: &str, message: &str) -> PyErr {
    let mistake = Mistake {
        file: NAME_OF_DICTIONARY.into(),
        place: Place::Whole,
        key: key.into(),
        message: message.into(),
    };
    scene_error(py, &mistake.to_string(), [&mistake])
}

/// A run that did not end well, as `PhysicsError` or `OutputError`.
pub(crate) fn from_run(py: Python<'_>, error: &RunError) -> PyErr {
    let message = error.to_string();
    match error {
        RunError::Physics { summary, .. } => match python_from(py, summary) {
            Ok(summary) => raised(py, "PhysicsError", (message, summary)),
            Err(error) => error,
        },
        RunError::Output { path, source } => {
            let raised = raised(py, "OutputError", (message, path.as_path()));
            let cause = std::io::Error::new(source.kind(), source.to_string());
            raised.set_cause(py, Some(cause.into()));
            raised
        }
        RunError::Folder(_) => raised(py, "OutputError", (message,)),
    }
}

/// A step that went wrong, as `PhysicsError`.
pub(crate) fn from_step(py: Python<'_>, error: &StepError) -> PyErr {
    raised(py, "PhysicsError", (error.to_string(),))
}

fn scene_error<'a>(
    py: Python<'_>,
    message: &str,
    mistakes: impl IntoIterator<Item = &'a Mistake>,
) -> PyErr {
    let translated: PyResult<Vec<_>> = mistakes
        .into_iter()
        .map(|mistake| python_mistake(py, mistake))
        .collect();
    match translated.and_then(|mistakes| PyList::new(py, mistakes)) {
        Ok(mistakes) => raised(py, "SceneError", (message, mistakes)),
        Err(error) => error,
    }
}

fn python_mistake<'py>(py: Python<'py>, mistake: &Mistake) -> PyResult<Bound<'py, PyAny>> {
    let (line, column) = match mistake.place {
        Place::Line { line, column } => (Some(line), column),
        Place::Override(_) | Place::Whole => (None, None),
    };
    let fields = (&mistake.file, line, column, &mistake.key, &mistake.message);
    py.import("pelletflow.errors")?
        .getattr("Mistake")?
        .call1(fields)
}

/// An exception of `pelletflow.errors`, or what went wrong in making it.
fn raised<'py>(py: Python<'py>, name: &str, arguments: impl pyo3::call::PyCallArgs<'py>) -> PyErr {
    let made = py
        .import("pelletflow.errors")
        .and_then(|errors| errors.getattr(name))
        .and_then(|exception| exception.call1(arguments));
    match made {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}
