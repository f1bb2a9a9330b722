//! A whole run with its recording.

use crate::errors;
use crate::scene::{python_from, read};
use pelletflow_log::{Earlier, Progress, Resumption, RunError, RunRequest, Summary};
use pelletflow_scene::Scene;
use pelletflow_sim::Simulation;
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Runs a scene to its end; the summary and the folder of the output.
#[pyfunction]
#[pyo3(signature = (scene, output, threads, set, unfinished, observer))]
pub(crate) fn run<'py>(
    scene: &Bound<'py, PyAny>,
    output: Option<PathBuf>,
    threads: Option<usize>,
    set: Option<&Bound<'py, PyMapping>>,
    unfinished: &str,
    observer: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, PathBuf)> {
    let py = scene.py();
    let scene = read(scene, set)?;
    let threads = threads.unwrap_or(0);
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
        contacts: scene.output.contacts,
        live: None,
    };

    let start = Start::new(py, unfinished, &scene, &request, threads)?;
    let observer = observer.map(|observer| observer.clone().unbind());
    // What stopped the run from Python's side: Ctrl-C, or an exception of the observer.
    let mut stopped = None;
    let outcome = py.detach(|| {
        let watch = &mut |progress: &Progress| match Python::attach(|py| {
            look(py, observer.as_ref(), progress)
        }) {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                stopped = Some(error);
                ControlFlow::Break(())
            }
        };
        match start {
            Start::Anew(mut simulation) => pelletflow_log::run(&mut simulation, &request, watch),
            Start::GoingOn(resumption) => {
                resumption.run(scene.model.clone(), threads, &request, watch)
            }
            Start::Over(summary) => Ok(*summary),
        }
    });
    let summary = outcome.map_err(|error| errors::from_run(py, &error))?;
    match stopped {
        Some(error) => Err(error),
        None => Ok((python_from(py, &summary)?, directory)),
    }
}

/// Where a run begins.
enum Start {
    Anew(Box<Simulation>),
    GoingOn(Box<Resumption>),
    /// It is over already.
    Over(Box<Summary>),
}

impl Start {
    /// What is made of an earlier run in the folder: `unfinished` is `refuse`, `resume` or `restart`.
    fn new(
        py: Python<'_>,
        unfinished: &str,
        scene: &Scene,
        request: &RunRequest,
        threads: usize,
    ) -> PyResult<Self> {
        let refused = |error: RunError| errors::from_run(py, &error);
        match unfinished {
            "refuse" => py
                .detach(|| pelletflow_log::admit(request.directory))
                .map_err(refused)?,
            "restart" => py
                .detach(|| pelletflow_log::discard(request.directory))
                .map_err(refused)?,
            "resume" => match py
                .detach(|| pelletflow_log::earlier(request))
                .map_err(refused)?
            {
                Earlier::Nothing => {}
                Earlier::Unfinished(resumption) => return Ok(Self::GoingOn(resumption)),
                Earlier::Finished(summary) => return Ok(Self::Over(summary)),
            },
            other => {
                let message =
                    format!("`{other}` is none; expected `refuse`, `resume` or `restart`");
                return Err(errors::from_input(py, &message, "unfinished"));
            }
        }
        let simulation = py
            .detach(|| Simulation::new(scene.model.clone(), threads))
            .map_err(|errors| errors::from_mistakes(py, &scene.locate(&errors)))?;
        Ok(Self::Anew(Box::new(simulation)))
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
