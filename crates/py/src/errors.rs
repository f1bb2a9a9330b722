//! Errors as the exceptions of `pelletflow.errors`.

use crate::scene::{NAME_OF_DICTIONARY, python_from};
use pelletflow_impact::ImpactError;
use pelletflow_log::{ReadError, RunError, SafeSettingError};
use pelletflow_scene::{Mistake, Mistakes, OverrideError, Place, SceneError, StrengthCardError};
use pelletflow_sim::StepError;
use pyo3::exceptions::PyFileNotFoundError;
use pyo3::prelude::*;
use pyo3::types::PyList;
use std::path::Path;

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

/// A key that cannot be set, as `SceneError`.
pub(crate) fn from_override(py: Python<'_>, key: &str, error: &OverrideError) -> PyErr {
    from_value(py, key, &error.to_string())
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

/// A recording that cannot be read, as `RecordingError`; what the file system said is its cause.
pub(crate) fn from_read(py: Python<'_>, error: &ReadError, path: &Path) -> PyErr {
    let raised = raised(py, "RecordingError", (error.to_string(), path));
    match error {
        ReadError::Io { source, .. } => {
            let cause = std::io::Error::new(source.kind(), source.to_string());
            raised.set_cause(py, Some(cause.into()));
        }
        ReadError::Missing { .. } => {
            let cause = PyFileNotFoundError::new_err(error.to_string());
            raised.set_cause(py, Some(cause));
        }
        _ => {}
    }
    raised
}

/// A quantity outside its bounds, the `index`-th of an array, as `InputError`.
pub(crate) fn from_impact(py: Python<'_>, error: &ImpactError, index: usize) -> PyErr {
    let message = format!("{error} (place {index} of the arrays, counted from 0)");
    match *error {
        ImpactError::OutOfBounds {
            quantity,
            value,
            expected,
            ..
        } => raised(py, "InputError", (message, quantity, value, expected)),
        _ => raised(py, "InputError", (message,)),
    }
}

/// What was asked for and cannot be had, as `InputError`; `key` says what of it.
pub(crate) fn from_input(py: Python<'_>, message: &str, key: &str) -> PyErr {
    raised(py, "InputError", (message, key))
}

/// A strength card that cannot be had, as `SceneError`; an unreadable file is its cause.
pub(crate) fn from_card(py: Python<'_>, error: StrengthCardError) -> PyErr {
    match error {
        StrengthCardError::Invalid(mistakes) => from_mistakes(py, &mistakes),
        StrengthCardError::Unreadable { path, source } => {
            from_scene(py, SceneError::Unreadable { path, source })
        }
    }
}

/// A search for a safe setting that found nothing, as the error of its cause.
pub(crate) fn from_safe_setting(py: Python<'_>, error: &SafeSettingError) -> PyErr {
    let message = error.to_string();
    match error {
        SafeSettingError::Setup { .. } => scene_error(py, &message, []),
        SafeSettingError::Run { .. } => raised(py, "PhysicsError", (message,)),
        SafeSettingError::NotCrossed { .. } => from_input(py, &message, "range"),
        _ => raised(py, "InputError", (message,)),
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
