//! A run in memory, stepped by hand.

use crate::arrays;
use crate::batch::Batch;
use crate::errors;
use crate::scene::{python_from, read};
use crate::scene_copy::SceneCopy;
use numpy::{PyArray1, PyArray2};
use pelletflow_log::{hits_table, snapshot_from_bytes, snapshot_to_bytes};
use pelletflow_scene::Scene;
use pelletflow_sim::{Model, Pellets};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyDict, PyMapping};
use std::time::{Duration, Instant};

/// Time between two looks for Ctrl-C, about.
const LOOK_INTERVAL: Duration = Duration::from_millis(50);

/// A run in memory, stepped by hand.
///
/// The arrays are copies, with one row per pellet inside, in order of `ids`: what was taken before
/// a step is not changed by it.
///
/// >>> import pelletflow as pf
/// >>> simulation = pf.Simulation("chute.toml", threads=1)
/// >>> simulation.step(10)
/// >>> simulation.step_count
/// 10
#[pyclass(module = "pelletflow")]
pub(crate) struct Simulation {
    inner: pelletflow_sim::Simulation,
    scene: SceneCopy,
    /// Threads asked for; none where it is left to the machine.
    threads: Option<usize>,
}

/// What a pickled simulation is made of: the scene, threads asked for, whether hits are followed, and the state.
type Pickled<'py> = (SceneCopy, Option<usize>, bool, Bound<'py, PyBytes>);

/// The model of a scene, in which hits are followed where somebody takes them: else they would pile up.
fn model_of(scene: &Scene, hits: bool) -> Model {
    let model = scene.model.clone();
    if hits { model } else { model.without_hits() }
}

/// A simulation that was pickled.
#[pyfunction]
pub(crate) fn restored(
    py: Python<'_>,
    scene: SceneCopy,
    threads: Option<usize>,
    hits: bool,
    state: &[u8],
) -> PyResult<Simulation> {
    let snapshot = snapshot_from_bytes(state)
        .map_err(|error| errors::from_input(py, &error.to_string(), "Simulation"))?;
    let scene = scene.read(py)?;
    let inner = py.detach(|| {
        let model = model_of(&scene, hits);
        pelletflow_sim::Simulation::restore(model, threads.unwrap_or(0), snapshot)
    });
    let inner = inner.map_err(|error| errors::from_input(py, &error.to_string(), "Simulation"))?;
    Ok(Simulation {
        inner,
        scene: SceneCopy::of(scene),
        threads,
    })
}

impl Simulation {
    /// Advances by a number of steps, in slices between which it looks for Ctrl-C.
    fn advance(&mut self, py: Python<'_>, n: u64) -> PyResult<()> {
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
}

#[pymethods]
impl Simulation {
    #[new]
    #[pyo3(signature = (scene, *, threads=None, set=None, hits=false))]
    fn new(
        scene: &Bound<'_, PyAny>,
        threads: Option<usize>,
        set: Option<&Bound<'_, PyMapping>>,
        hits: bool,
    ) -> PyResult<Self> {
        let py = scene.py();
        let scene = read(scene, set)?;
        if hits && scene.setup.hits.is_none() {
            let message = "hits is True, and the scene says `hits = false` in [output]; leave one of them out";
            return Err(errors::from_input(py, message, "hits"));
        }
        let inner = py
            .detach(|| {
                let model = model_of(&scene, hits);
                pelletflow_sim::Simulation::new(model, threads.unwrap_or(0))
            })
            .map_err(|errors| errors::from_mistakes(py, &scene.locate(&errors)))?;
        Ok(Self {
            inner,
            scene: SceneCopy::of(scene),
            threads,
        })
    }

    /// Advance by `n` time steps [-], and call `callback` with the simulation after every `every` of them.
    ///
    /// Other Python threads run meanwhile, and Ctrl-C stops it between two steps.
    /// A callback that returns False stops it too.
    #[pyo3(signature = (n=1, *, callback=None, every=1))]
    fn step(
        slf: &Bound<'_, Self>,
        n: u64,
        callback: Option<&Bound<'_, PyAny>>,
        every: u64,
    ) -> PyResult<()> {
        let py = slf.py();
        if every == 0 {
            let message = "every is 0; expected at least 1 step between two calls";
            return Err(errors::from_input(py, message, "every"));
        }
        let Some(callback) = callback else {
            return slf.try_borrow_mut()?.advance(py, n);
        };
        let mut left = n;
        while left > 0 {
            let steps = every.min(left);
            slf.try_borrow_mut()?.advance(py, steps)?;
            left -= steps;
            // Steps left over at the end make no full stride.
            if steps == every && callback.call1((slf,))?.is(PyBool::new(py, false)) {
                break;
            }
        }
        Ok(())
    }

    /// Take the hits kept in full that have ended since the last call, in SI units [-].
    ///
    /// They are held in memory until then.
    fn take_hits<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let setup = self.inner.model().setup();
        if setup.hits.is_none() {
            let message = "this simulation follows no hits; make it anew with `hits=True`, because what has passed was not \
                           kept";
            return Err(errors::from_input(py, message, "hits"));
        }
        let walls: Vec<String> = setup.walls.iter().map(|wall| wall.name.clone()).collect();
        let hits = self.inner.take_hits();
        let batch = Batch::from(hits_table(&hits, &walls));
        py.import("pelletflow._table")?
            .getattr("Table")?
            .call_method1("_of", (batch,))
    }

    /// Pickles as its scene and its state, of the same version alone.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Pickled<'py>)> {
        let inner = &self.inner;
        let state = py.detach(|| snapshot_to_bytes(&inner.snapshot()));
        let restored = py.import("pelletflow._pelletflow")?.getattr("restored")?;
        let follows_hits = inner.model().setup().hits.is_some();
        let parts = (
            self.scene.clone(),
            self.threads,
            follows_hits,
            PyBytes::new(py, &state),
        );
        Ok((restored, parts))
    }

    /// Draw the pellets as circles colored by speed [m/s]; needs matplotlib.
    ///
    /// `along` is the axis of the view, `ax` the axes to draw on.
    #[pyo3(signature = (**options))]
    fn plot<'py>(
        slf: &Bound<'py, Self>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let plots = slf.py().import("pelletflow._plot")?;
        plots.getattr("pellets")?.call((slf,), options)
    }

    fn __repr__(&self) -> String {
        format!(
            "<pelletflow.Simulation: {} pellets at {:.6} s, step {}>",
            self.inner.pellet_count(),
            self.inner.time(),
            self.inner.step_count()
        )
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
        arrays::column(py, &self.inner, |pellets, index| pellets.id[index])
    }

    /// Centers in the world, shape (n, 3) [m].
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::vectors(py, &self.inner, |pellets| &pellets.position)
    }

    /// Velocities, shape (n, 3) [m/s].
    #[getter]
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::vectors(py, &self.inner, |pellets| &pellets.velocity)
    }

    /// Spins in the world, shape (n, 3) [rad/s].
    #[getter]
    fn spins<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::vectors(py, &self.inner, |pellets| &pellets.spin)
    }

    /// Radii, shape (n,) [m].
    #[getter]
    fn radii<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::column(py, &self.inner, |pellets, index| pellets.position[index][3])
    }

    /// Masses, shape (n,) [kg].
    #[getter]
    fn masses<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::column(py, &self.inner, Pellets::mass)
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
