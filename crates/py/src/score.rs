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

/// Pellets broken by the hits of a recording, for each of `count` strengths.
#[pyfunction]
pub(crate) fn scores<'py>(
    py: Python<'py>,
    path: PathBuf,
    strengths: Strengths<'py>,
    yield_pressure: Option<PyReadonlyArray1<'py, f64>>,
    count: usize,
    places: usize,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let laws = strengths.all(py, count)?.into_iter().map(StrengthLaw::Load);
    let pressures = yield_pressure.map(|values| values.as_array().to_vec());
    let requests: Vec<_> = laws
        .enumerate()
        .map(|(index, law)| BreakageRequest {
            law,
            yield_pressure: pressures.as_ref().map(|pressures| pressures[index]),
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
) -> PyResult<Vec<Bound<'_, PyAny>>> {
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

/// Yield pressure that a card tells [Pa].
#[pyfunction]
pub(crate) fn card_yield_pressure(py: Python<'_>, card: PathBuf) -> PyResult<Option<f64>> {
    let card = StrengthCard::read(&card).map_err(|error| errors::from_card(py, error))?;
    Ok(card.yield_pressure)
}

fn read_recorded(py: Python<'_>, path: &Path) -> PyResult<RecordedHits> {
    py.detach(|| read_hits(path))
        .map_err(|error| errors::from_read(py, &error, path))
}

fn answers<'py>(
    py: Python<'py>,
    recorded: &RecordedHits,
    requests: &[BreakageRequest],
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    requests
        .iter()
        .enumerate()
        .map(|(index, request)| {
            let answer = py
                .detach(|| breakage(recorded, request))
                .map_err(|error| errors::from_impact(py, &error, index))?;
            python_from(py, &answer)
        })
        .collect()
}
