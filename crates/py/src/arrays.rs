//! Pellets as NumPy arrays, in order of their numbers.
//!
//! Each is a copy made in one pass: pellets lie in memory along a curve in space that a step may lay anew, so that an
//! array that shared this memory would show other pellets after the next step, or none.

use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
use pelletflow_sim::{Pellets, Row, Simulation};
use pyo3::prelude::*;

/// One value per pellet, shape (n,) [unit of the value].
pub(crate) fn column<'py, T: Element>(
    py: Python<'py>,
    simulation: &Simulation,
    value: impl Fn(&Pellets, usize) -> T,
) -> Bound<'py, PyArray1<T>> {
    let pellets = &simulation.state().pellets;
    let values = by_id(pellets).into_iter();
    PyArray1::from_vec(py, values.map(|index| value(pellets, index)).collect())
}

/// One vector per pellet, shape (n, 3) [unit of the vector].
pub(crate) fn vectors<'py>(
    py: Python<'py>,
    simulation: &Simulation,
    rows: impl Fn(&Pellets) -> &[Row],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let pellets = &simulation.state().pellets;
    let rows = rows(pellets);
    let mut values = Vec::with_capacity(3 * rows.len());
    for index in by_id(pellets) {
        values.extend_from_slice(&rows[index][..3]);
    }
    PyArray1::from_vec(py, values).reshape([rows.len(), 3])
}

/// Places in storage, whose order changes, in the order of numbers, which does not.
fn by_id(pellets: &Pellets) -> Vec<usize> {
    let mut order: Vec<usize> = (0..pellets.len()).collect();
    order.sort_unstable_by_key(|&index| pellets.id[index]);
    order
}
