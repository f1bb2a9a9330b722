//! The Python module `pelletflow._pelletflow`: translation only.
//!
//! The package around it is `python/pelletflow`; its stubs hold the documentation that Python shows.

#![expect(
    clippy::needless_pass_by_value,
    reason = "PyO3 hands the arguments of a function over by value"
)]

mod arrays;
mod batch;
mod errors;
mod impact;
mod recording;
mod run;
mod safe_setting;
mod scene;
mod scene_copy;
mod score;
mod simulation;

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the command line, the program's name first; its exit code [-].
#[pyfunction]
fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| pelletflow_cli::main_from(arguments))
}

/// The Rust module: translation only.
///
/// An interpreter without its lock switches it on: the module was never tested there.
#[pymodule(gil_used = true)]
fn _pelletflow(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(command, module)?)?;
    module.add_function(wrap_pyfunction!(run::run, module)?)?;
    module.add_function(wrap_pyfunction!(scene::scene, module)?)?;
    module.add_function(wrap_pyfunction!(scene::scene_tables, module)?)?;
    module.add_function(wrap_pyfunction!(scene::scene_value, module)?)?;
    module.add_function(wrap_pyfunction!(scene::parts_of, module)?)?;
    module.add_function(wrap_pyfunction!(scene::schema, module)?)?;
    module.add_function(wrap_pyfunction!(impact::library, module)?)?;
    module.add_function(wrap_pyfunction!(impact::mean_interval, module)?)?;
    module.add_function(wrap_pyfunction!(impact::impacts, module)?)?;
    module.add_function(wrap_pyfunction!(impact::safe_speeds, module)?)?;
    module.add_function(wrap_pyfunction!(score::scores, module)?)?;
    module.add_function(wrap_pyfunction!(score::score_energy, module)?)?;
    module.add_function(wrap_pyfunction!(safe_setting::safe_setting, module)?)?;
    module.add_function(wrap_pyfunction!(recording::read, module)?)?;
    module.add_function(wrap_pyfunction!(recording::colors, module)?)?;
    module.add_function(wrap_pyfunction!(recording::table_kinds, module)?)?;
    module.add_function(wrap_pyfunction!(simulation::restored, module)?)?;
    module.add_class::<batch::Batch>()?;
    module.add_class::<simulation::Simulation>()
}
