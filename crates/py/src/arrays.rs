//! Pellets as NumPy arrays, in order of their numbers.

use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
use pelletflow_sim::{PelletView, Simulation};
use pyo3::prelude::*;

/// One value per pellet, shape (n,) [unit of the value].
pub(crate) fn column<'py, T: Element>(
    py: Python<'py>,
    simulation: &Simulation,
    value: impl Fn(&PelletView) -> T,
) -> Bound<'py, PyArray1<T>> {
    let values = by_id(simulation).iter().map(value).collect();
    PyArray1::from_vec(py, values)
}

/// One vector per pellet, shape (n, 3) [unit of the vector].
pub(crate) fn rows<'py>(
    py: Python<'py>,
    simulation: &Simulation,
    vector: impl Fn(&PelletView) -> [f64; 3],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let pellets = by_id(simulation);
    let values = pellets.iter().flat_map(vector);
    PyArray1::from_iter(py, values).reshape([pellets.len(), 3])
}

/// Storage order changes; the order of numbers does not.
fn by_id(simulation: &Simulation) -> Vec<PelletView> {
    let mut pellets: Vec<PelletView> = simulation.pellets().collect();
    pellets.sort_unstable_by_key(|pellet| pellet.id);
    pellets
}
