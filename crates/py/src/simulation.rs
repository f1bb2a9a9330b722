//! A run in memory, stepped by hand.

use crate::arrays;
use crate::errors;
use crate::scene::{python_from, read};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyMapping;
use std::time::{Duration, Instant};

/// Time between two looks for Ctrl-C, about.
const LOOK_INTERVAL: Duration = Duration::from_millis(50);

/// A run in memory, stepped by hand.
///
/// The arrays are copies with one row per pellet inside, in order of `ids`.
#[pyclass(module = "pelletflow")]
pub(crate) struct Simulation {
    inner: pelletflow_sim::Simulation,
}

#[pymethods]
impl Simulation {
    #[new]
    #[pyo3(signature = (scene, *, threads=None, set=None))]
    fn new(
        scene: &Bound<'_, PyAny>,
        threads: Option<usize>,
        set: Option<&Bound<'_, PyMapping>>,
    ) -> PyResult<Self> {
        let py = scene.py();
        let scene = read(scene, set)?;
        let inner = pelletflow_sim::Simulation::new(scene.model.clone(), threads.unwrap_or(0))
            .map_err(|errors| errors::from_mistakes(py, &scene.locate(&errors)))?;
        Ok(Self { inner })
    }

    /// Advance by `n` time steps [-].
    ///
    /// Other Python threads run meanwhile, and Ctrl-C stops it between two steps.
    #[pyo3(signature = (n=1))]
    fn step(&mut self, py: Python<'_>, n: u64) -> PyResult<()> {
        let inner = &mut self.inner;
        let mut left = n;
        let mut slice = 1;
        while left > 0 {
            let steps = slice.min(left);
            let started = Instant::now();
            py.detach(|| inner.advance(steps))
                .map_err(|error| errors::from_step(py, &error))?;
            py.check_signals()?;
            left -= steps;
            // The state does not depend on how steps are sliced, so the slices may follow the clock.
            slice = if started.elapsed() < LOOK_INTERVAL {
                slice.saturating_mul(2)
            } else {
                (slice / 2).max(1)
            };
        }
        Ok(())
    }

    /// Simulated time [s].
    #[getter]
    fn time(&self) -> f64 {
        self.inner.time()
    }

    /// Time step [s].
    #[getter]
    fn time_step(&self) -> f64 {
        self.inner.model().time_step().seconds
    }

    /// Steps taken [-].
    #[getter]
    fn step_count(&self) -> u64 {
        self.inner.step_count()
    }

    /// Threads at work [-].
    #[getter]
    fn threads(&self) -> usize {
        self.inner.threads()
    }

    /// Permanent numbers, rising, in order of insertion, shape (n,) [-].
    #[getter]
    fn ids<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        arrays::column(py, &self.inner, |pellet| pellet.id)
    }

    /// Centers in the world, shape (n, 3) [m].
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::rows(py, &self.inner, |pellet| pellet.position.into())
    }

    /// Velocities, shape (n, 3) [m/s].
    #[getter]
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::rows(py, &self.inner, |pellet| pellet.velocity.into())
    }

    /// Spins in the world, shape (n, 3) [rad/s].
    #[getter]
    fn spins<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::rows(py, &self.inner, |pellet| pellet.spin.into())
    }

    /// Radii, shape (n,) [m].
    #[getter]
    fn radii<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::column(py, &self.inner, |pellet| pellet.radius)
    }

    /// Masses, shape (n,) [kg].
    #[getter]
    fn masses<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::column(py, &self.inner, |pellet| pellet.mass)
    }

    /// Where every pellet went: inserted = inside + discharged + lost.
    ///
    /// Each a dictionary of `count` [-] and `mass` [kg]; `by_inlet` and `by_outlet` list them
    /// in order of the scene.
    #[getter]
    fn mass_ledger<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        python_from(py, &self.inner.mass_ledger())
    }

    /// Where the energy went at the start of the last step [J].
    #[getter]
    fn energy_ledger<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        python_from(py, &self.inner.energy_ledger())
    }

    /// Hash of the state, 32 hexadecimal digits: equal only for equal bits.
    #[getter]
    fn state_hash(&self) -> String {
        self.inner.state_hash()
    }
}
