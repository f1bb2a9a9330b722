//! Breakage of recorded hits, for many strengths at once.

use crate::errors;
use crate::impact::Strengths;
use crate::scene::python_from;
use numpy::PyReadonlyArray1;
use pelletflow_impact::StrengthLaw;
use pelletflow_log::{BreakageRequest, RecordedHits, breakage, read_hits};
use pelletflow_scene::StrengthCard;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// The share to go by, with its least and its most, and all that was found.
type Answer<'py> = (f64, [f64; 2], Bound<'py, PyAny>);

/// Pellets broken by the hits of a recording, for each of `count` strengths.
#[pyfunction]
pub(crate) fn scores<'py>(
    py: Python<'py>,
    path: PathBuf,
    strengths: Strengths<'py>,
    yield_pressure: Option<PyReadonlyArray1<'py, f64>>,
    count: usize,
    places: usize,
) -> PyResult<Vec<Answer<'py>>> {
    let told = strengths.all(py, count)?;
    let pressures = yield_pressure.map(|values| values.as_array().to_vec());
    let own = told.yield_pressure;
    let requests: Vec<_> = told
        .strengths
        .into_iter()
        .enumerate()
        .map(|(index, strength)| BreakageRequest {
            law: StrengthLaw::Load(strength),
            yield_pressure: pressures.as_ref().map_or(own, |given| Some(given[index])),
            places,
        })
        .collect();
    let recorded = read_recorded(py, &path)?;
    answers(py, &recorded, &requests)
}

/// The same by the fracture energy of a card.
#[pyfunction]
pub(crate) fn score_energy(
    py: Python<'_>,
    path: PathBuf,
    card: PathBuf,
    places: usize,
) -> PyResult<Vec<Answer<'_>>> {
    let read = StrengthCard::read(&card).map_err(|error| errors::from_card(py, error))?;
    let Some(energy) = read.fracture_energy else {
        let message = format!(
            "{} has no [fracture_energy]; `pelletflow card --drop` makes one of a drop test",
            card.display()
        );
        return Err(errors::from_input(py, &message, "strength_card"));
    };
    let request = BreakageRequest {
        law: StrengthLaw::Energy(energy),
        yield_pressure: read.yield_pressure,
        places,
    };
    answers(py, &read_recorded(py, &path)?, &[request])
}

fn read_recorded(py: Python<'_>, path: &Path) -> PyResult<RecordedHits> {
    py.detach(|| read_hits(path))
        .map_err(|error| errors::from_read(py, &error, path))
}

fn answers<'py>(
    py: Python<'py>,
    recorded: &RecordedHits,
    requests: &[BreakageRequest],
) -> PyResult<Vec<Answer<'py>>> {
    requests
        .iter()
        .enumerate()
        .map(|(index, request)| {
            let answer = py
                .detach(|| breakage(recorded, request))
                .map_err(|error| errors::from_impact(py, &error, index))?;
            let share = answer.believed();
            Ok((share.share, share.interval, python_from(py, &answer)?))
        })
        .collect()
}
