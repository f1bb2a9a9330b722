//! A scene apart from where it was read: its text and the files that it names.

use crate::errors;
use pelletflow_scene::{Scene, SceneError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::fs;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;

/// Name of the text among the files.
const NAME: &str = "scene.toml";

/// A scene that can be read on any machine.
#[derive(Debug, Clone)]
pub(crate) struct SceneCopy {
    /// The text, with all that was set.
    pub(crate) text: String,
    /// Files of meshes: where each lies, seen from the folder of the text, and what it holds.
    pub(crate) files: Vec<(PathBuf, Arc<[u8]>)>,
}

impl SceneCopy {
    /// Of a scene that was read.
    pub(crate) fn of(scene: Scene) -> Self {
        Self {
            text: scene.text,
            files: scene.files,
        }
    }

    /// Reads it anew.
    pub(crate) fn read(&self, py: Python<'_>) -> PyResult<Scene> {
        let scene = py.detach(|| {
            if self.files.is_empty() {
                return Ok(Scene::parse(&self.text, NAME, &[]));
            }
            // Meshes are read as files.
            let folder = tempfile::tempdir()?;
            for (name, bytes) in &self.files {
                let path = folder.path().join(name);
                if let Some(parent) = path.parent() {
                    fs::create_dir_all(parent)?;
                }
                fs::write(path, bytes)?;
            }
            let path = folder.path().join(NAME);
            fs::write(&path, &self.text)?;
            Ok(Scene::read(&path, &[]))
        });
        let scene: io::Result<Result<Scene, SceneError>> = scene;
        scene?.map_err(|error| errors::from_scene(py, error))
    }
}

impl<'py> IntoPyObject<'py> for SceneCopy {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let files = self.files.iter();
        let files: Vec<_> = files
            .map(|(path, bytes)| (path.clone(), PyBytes::new(py, bytes)))
            .collect();
        Ok((self.text, files).into_pyobject(py)?.into_any())
    }
}

impl<'py> FromPyObject<'_, 'py> for SceneCopy {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let (text, files): (String, Vec<(PathBuf, Vec<u8>)>) = object.extract()?;
        let files = files.into_iter();
        Ok(Self {
            text,
            files: files.map(|(path, bytes)| (path, bytes.into())).collect(),
        })
    }
}
