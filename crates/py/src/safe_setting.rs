//! The value of a setting of a scene at which a share of the pellets breaks.

use crate::errors;
use crate::impact::Strengths;
use crate::scene::{Given, python_from};
use pelletflow_impact::StrengthLaw;
use pelletflow_log::{BreakageRequest, SafeSettingRequest};
use pelletflow_scene::Setting;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use std::ops::ControlFlow;

/// What is sought, and how closely.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Search {
    vary: Option<String>,
    range: [f64; 2],
    unit: String,
    risk: f64,
    tolerance: f64,
    seeds: u32,
    threads: Option<usize>,
    places: usize,
}

/// Seeks the value of a setting at which the share asked for breaks, by whole runs in memory.
///
/// The observer is told how many runs are done and which part of this one.
#[pyfunction]
#[pyo3(signature = (scene, set, strengths, search, observer))]
pub(crate) fn safe_setting<'py>(
    scene: &Bound<'py, PyAny>,
    set: Option<&Bound<'py, PyMapping>>,
    strengths: Strengths<'py>,
    search: Search,
    observer: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let py = scene.py();
    let given = Given::new(scene, set)?;
    let base = py.detach(|| given.read());
    let base = base.map_err(|error| errors::from_scene(py, error))?;
    let setting = Setting::of_scene(&base, search.vary.as_deref(), &search.unit)
        .map_err(|error| errors::from_input(py, &error.to_string(), "vary"))?;
    let told = strengths.all(py, 1)?;
    let request = SafeSettingRequest {
        breakage: BreakageRequest {
            law: StrengthLaw::Load(told.strengths[0]),
            yield_pressure: told.yield_pressure,
            places: search.places,
        },
        risk: search.risk,
        range: search.range,
        tolerance: search.tolerance,
        seeds: search.seeds,
        threads: search.threads.unwrap_or(0),
    };
    // What stopped the search from Python's side: Ctrl-C, or an exception of the observer.
    let mut stopped = None;
    let found = py.detach(|| {
        pelletflow_log::safe_setting(
            &request,
            &mut |value| {
                let set = setting.set(value).map_err(|error| error.to_string())?;
                let scene = given.read_with(set).map_err(|error| error.to_string())?;
                Ok((scene.setup, scene.plan))
            },
            &mut |done, part| match Python::attach(|py| look(py, observer.as_ref(), done, part)) {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => {
                    stopped = Some(error);
                    ControlFlow::Break(())
                }
            },
        )
    });
    if let Some(error) = stopped {
        return Err(error);
    }
    let found = found.map_err(|error| errors::from_safe_setting(py, &error))?;
    let runs: Vec<_> = found
        .runs
        .iter()
        .map(|run| {
            let share = run.breakage.believed();
            (run.value, share.share, share.interval, run.breakage.hits)
        })
        .collect();
    let answer = PyDict::new(py);
    answer.set_item("key", setting.key)?;
    answer.set_item("unit", setting.unit)?;
    answer.set_item("value", found.value)?;
    answer.set_item("interval", found.interval)?;
    answer.set_item("seed_half_width", found.seed_half_width)?;
    answer.set_item("seed_shares", found.seed_shares)?;
    answer.set_item("is_monotone", found.is_monotone)?;
    answer.set_item("runs", runs)?;
    answer.set_item("breakage", python_from(py, &found.breakage)?)?;
    Ok(answer)
}

fn look(py: Python<'_>, observer: Option<&Py<PyAny>>, done: usize, part: f64) -> PyResult<()> {
    py.check_signals()?;
    match observer {
        Some(observer) => observer.call1(py, (done, part)).map(drop),
        None => Ok(()),
    }
}
