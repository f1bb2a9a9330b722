//! Recordings read back as tables.

use crate::batch::Batch;
use crate::errors;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pelletflow_log::{TableKind, color_on_scale, read_tables};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Facts of the run, whether the file ends in the middle, and the tables asked for.
type Read = (BTreeMap<String, String>, bool, Vec<Batch>);

/// Names of the kinds of tables.
#[pyfunction]
pub(crate) fn table_kinds() -> Vec<&'static str> {
    TableKind::ALL.map(TableKind::name).to_vec()
}

/// Reads a recording as the tables of some kinds; a kind that is none is left out.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: PathBuf, kinds: Vec<String>) -> PyResult<Read> {
    let kinds: Vec<TableKind> = TableKind::ALL
        .into_iter()
        .filter(|kind| kinds.iter().any(|name| name == kind.name()))
        .collect();
    let tables = py
        .detach(|| read_tables(&path, &kinds))
        .map_err(|error| errors::from_read(py, &error, &path))?;
    let batches = tables.tables.into_iter().map(Batch::from).collect();
    Ok((tables.facts, tables.is_cut_off, batches))
}

/// Colors of shares of the scale, shape (n, 3) [0 to 255].
#[pyfunction]
pub(crate) fn colors<'py>(
    py: Python<'py>,
    shares: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray2<u8>>> {
    let shares = shares.as_array();
    let channels = shares.iter().flat_map(|&share| color_on_scale(share));
    PyArray1::from_vec(py, channels.collect()).reshape([shares.len(), 3])
}
