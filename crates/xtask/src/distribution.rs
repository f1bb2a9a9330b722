//! What is handed out: the source distribution, and the wheel of this platform built from it.

use crate::process;
use crate::report::Report;
use crate::venv::Venv;
use crate::workspace::{cargo, root, target};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// What a wheel has to show in an environment that holds nothing else: a step that changes the state, and the command.
const PROOF: &str = r#"
import sys
import pelletflow as pf
from pelletflow import _command
scene = pf.Scene(
    schema_version=1,
    materials={"ore": {"density": 3700, "shear_modulus": "60 MPa", "poisson_ratio": 0.22}},
    pairs={"ore-ore": {"restitution": 0.5, "friction": 0.3}},
    pellets={"pellet": {"material": "ore", "diameter": "15 mm"}},
    fill={"one": {"pellets": "pellet", "at": [[0, 0, 0.5]]}},
    domain={"min": [-1, -1, -1], "max": [1, 1, 1]},
    time={"end": "0.01 s"},
)
assert pf.run(scene, output=sys.argv[1]).read().bodies.rows > 1
sys.argv = ["pelletflow", "inspect", sys.argv[1] + "/run.mcap"]
sys.exit(_command.main())
"#;

/// Builds both into `target/dist`, and runs a scene by the wheel where nothing else is installed.
///
/// The one wheel holds the code of every instruction set, which is chosen when it runs.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    let folder = target().join("dist");
    report.part("distribution", || {
        let venv = Venv::at(target().join("venv-build"), &["requirements-build.txt"])?;
        if folder.exists() {
            fs::remove_dir_all(&folder)?;
        }
        process::run(
            venv.tool("maturin")
                .current_dir(root())
                .args(["build", "--release", "--sdist", "--out"])
                .arg(&folder),
        )?;
        Ok(format!("in {}", folder.display()))
    })?;
    report.part("wheel", || prove(&folder))
}

/// Installs the wheel of a folder as a user does and has it run a scene.
fn prove(folder: &Path) -> Result<String> {
    let place = target().join("venv-wheel");
    if place.exists() {
        fs::remove_dir_all(&place)?;
    }
    let venv = Venv::at(place.clone(), &[])?;
    venv.install(&wheel(folder)?)?;
    process::run(
        venv.tool("python")
            .args(["-c", PROOF])
            .arg(place.join("run")),
    )?;
    Ok("runs in an environment of its own".to_owned())
}

/// The wheel that a folder holds.
fn wheel(folder: &Path) -> Result<PathBuf> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|ending| ending == "whl") {
            return Ok(path);
        }
    }
    anyhow::bail!("{} holds no wheel", folder.display())
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
