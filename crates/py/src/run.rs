//! A whole run with its recording.

use crate::errors;
use crate::scene::{python_from, read};
use pelletflow_log::{Progress, RunRequest};
use pelletflow_sim::Simulation;
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Runs a scene to its end; the summary and the folder of the output.
#[pyfunction]
#[pyo3(signature = (scene, output, threads, set, observer))]
pub(crate) fn run<'py>(
    scene: &Bound<'py, PyAny>,
    output: Option<PathBuf>,
    threads: Option<usize>,
    set: Option<&Bound<'py, PyMapping>>,
    observer: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, PathBuf)> {
    let py = scene.py();
    let scene = read(scene, set)?;
    let mut simulation = Simulation::new(scene.model.clone(), threads.unwrap_or(0))
        .map_err(|errors| errors::from_mistakes(py, &scene.locate(&errors)))?;
    let directory = output.unwrap_or_else(|| Path::new("out").join(&scene.name));
    let request = RunRequest {
        directory: &directory,
        scene_name: &scene.name,
        scene_title: &scene.title,
        scene_text: &scene.text,
        scene_hash: &scene.hash,
        scene_files: &scene.files,
        plan: &scene.plan,
        spheres_up_to: scene.output.spheres_up_to,
    };

    let observer = observer.map(|observer| observer.clone().unbind());
    // What stopped the run from Python's side: Ctrl-C, or an exception of the observer.
    let mut stopped = None;
    let outcome = py.detach(|| {
        pelletflow_log::run(
            &mut simulation,
            &request,
            &mut |progress| match Python::attach(|py| look(py, observer.as_ref(), progress)) {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => {
                    stopped = Some(error);
                    ControlFlow::Break(())
                }
            },
        )
    });
    let summary = outcome.map_err(|error| errors::from_run(py, &error))?;
    match stopped {
        Some(error) => Err(error),
        None => Ok((python_from(py, &summary)?, directory)),
    }
}

fn look(py: Python<'_>, observer: Option<&Py<PyAny>>, progress: &Progress) -> PyResult<()> {
    py.check_signals()?;
    let Some(observer) = observer else {
        return Ok(());
    };
    let values = (
        progress.time,
        progress.end_time,
        progress.step,
        progress.pellets,
        progress.max_force,
        progress.discharged,
        progress.lost,
    );
    observer.call1(py, values).map(drop)
}
