//! The Python module `pelletflow._pelletflow`: translation only.
//!
//! The package around it is `python/pelletflow`; its stubs hold the documentation that Python shows.

mod arrays;
mod errors;
mod run;
mod scene;
mod simulation;

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the command line, the program's name first; its exit code [-].
#[pyfunction]
fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| pelletflow_cli::main_from(arguments))
}

/// The Rust module: translation only.
#[pymodule]
fn _pelletflow(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(command, module)?)?;
    module.add_function(wrap_pyfunction!(run::run, module)?)?;
    module.add_class::<simulation::Simulation>()
}
