//! What is handed out: the source distribution, and the wheel of this platform built from it.

use crate::process;
use crate::report::Report;
use crate::venv::Venv;
use crate::workspace::{cargo, root, target};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// Builds both into `target/dist`.
///
/// The one wheel holds the code of every instruction set, which is chosen when it runs.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    let venv = Venv::with(&["requirements-test.txt"])?;
    report.part("distribution", || {
        let folder = target().join("dist");
        process::run(
            venv.tool("maturin")
                .current_dir(root())
                .args(["build", "--release", "--sdist", "--out"])
                .arg(&folder),
        )?;
        Ok(format!("in {}", folder.display()))
    })
}

/// Whether the source distribution is whole: every crate that the module needs is in it, and its lock file holds.
pub(crate) fn check_source(venv: &Venv) -> Result<String> {
    let folder = target().join("sdist");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    process::run(
        venv.tool("maturin")
            .current_dir(root())
            .args(["sdist", "--out"])
            .arg(&folder),
    )?;
    let archive = only_entry(&folder)?;
    process::run(
        venv.module("tarfile")
            .arg("--extract")
            .arg(&archive)
            .arg(&folder),
    )?;
    fs::remove_file(&archive)?;
    let manifest = only_entry(&folder)?.join("crates/py/Cargo.toml");
    process::answer(
        cargo()
            .args(["metadata", "--offline", "--format-version=1"])
            .arg("--manifest-path")
            .arg(&manifest),
    )?;
    Ok("its crates resolve".to_owned())
}

/// The one thing that a folder holds.
fn only_entry(folder: &Path) -> Result<PathBuf> {
    let entry = fs::read_dir(folder)?
        .next()
        .with_context(|| format!("{} is empty", folder.display()))?;
    Ok(entry?.path())
}
