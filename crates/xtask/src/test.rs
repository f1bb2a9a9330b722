//! `cargo xtask test`: every test there is, on a machine with only Rust and Python 3.

use crate::distribution;
use crate::process;
use crate::report::Report;
use crate::venv::Venv;
use crate::viewers;
use crate::workspace::{cargo, root, target};
use anyhow::{Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};

/// Sets up and runs every test.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    report.part("Rust tests", rust_tests)?;
    let venv = Venv::with(&["requirements-build.txt", "requirements-test.txt"])?;
    wheel_and_recordings(report, &venv)
}

/// The tests that need Python: of the wheel, and of recordings by independent readers.
pub(crate) fn wheel_and_recordings(report: &mut Report, venv: &Venv) -> Result<()> {
    report.part("wheel", || {
        venv.install_wheel()?;
        Ok("built and installed".to_owned())
    })?;
    report.part("source distribution", || distribution::check_source(venv))?;
    report.part("Python tests", || python_tests(venv))?;
    let folder = target().join("recordings");
    report.part("example scenes", || recordings(venv, &folder))?;
    report.part("viewers", || viewers::check(&folder))
}

/// Runs the tests of all crates but the Python module, which only an interpreter can load.
pub(crate) fn rust_tests() -> Result<String> {
    let mut passed = 0;
    process::run_watched(
        cargo().args(["test", "--workspace", "--exclude", "pelletflow-py"]),
        |line| {
            println!("{line}");
            passed += passed_in_rust(line).unwrap_or(0);
        },
    )?;
    ensure!(passed > 0, "no Rust test ran");
    Ok(format!("{passed} passed"))
}

/// Runs a simulation under a clock that is set meanwhile, which takes a library of the system.
pub(crate) fn clock() -> Result<String> {
    let Some(library) = fake_clock() else {
        return Ok("not checked, libfaketime is not installed".to_owned());
    };
    process::run(
        cargo()
            .args(["test", "--workspace", "--exclude", "pelletflow-py"])
            .args(["--test", "faults", "--", "--ignored", "clock"])
            .env("LIBFAKETIME", library),
    )?;
    Ok("passed".to_owned())
}

/// Where Debian's packages put libfaketime: a folder for each kind of machine.
fn fake_clock() -> Option<PathBuf> {
    let folders = fs::read_dir("/usr/lib").ok()?.flatten();
    let mut libraries = folders.map(|folder| folder.path().join("faketime/libfaketimeMT.so.1"));
    libraries.find(|library| library.exists())
}

fn python_tests(venv: &Venv) -> Result<String> {
    let mut passed = 0;
    process::run_watched(
        venv.module("pytest")
            .args(["-p", "no:cacheprovider", "--import-mode=importlib"])
            .arg(root().join("python/tests")),
        |line| {
            println!("{line}");
            passed = passed_in_python(line).unwrap_or(passed);
        },
    )?;
    ensure!(passed > 0, "no Python test ran");
    Ok(format!("{passed} passed"))
}

/// Runs the example scenes as a user does and has independent readers check what they record.
fn recordings(venv: &Venv, folder: &Path) -> Result<String> {
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    let scenes = example_scenes()?;
    for scene in &scenes {
        let output = folder.join(scene.file_stem().unwrap_or_default());
        process::run(
            cargo()
                .args(["run", "--release", "--", "run"])
                .arg(scene)
                .arg("--output")
                .arg(&output),
        )?;
        process::run(
            venv.tool("python")
                .arg(root().join("python/tests/validate_recording.py"))
                .arg(output.join("run.mcap")),
        )?;
    }
    ensure!(!scenes.is_empty(), "there is no example scene");
    Ok(format!("{} written and validated", scenes.len()))
}

/// The scenes of `examples/scenes`, by name.
fn example_scenes() -> Result<Vec<PathBuf>> {
    let mut scenes = Vec::new();
    for entry in fs::read_dir(root().join("examples/scenes"))? {
        let path = entry?.path();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            scenes.push(path);
        }
    }
    scenes.sort();
    Ok(scenes)
}

/// `N` of `test result: ok. N passed; ...`.
fn passed_in_rust(line: &str) -> Option<u32> {
    let (count, _) = line
        .strip_prefix("test result: ok. ")?
        .split_once(" passed")?;
    count.parse().ok()
}

/// `N` of `==== N passed in 3.21s ====`.
fn passed_in_python(line: &str) -> Option<u32> {
    let (before, _) = line.split_once(" passed")?;
    before.split([' ', '=']).next_back()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_of_passed_tests_is_read_from_both_harnesses() {
        let rust = "test result: ok. 12 passed; 0 failed; 0 ignored; 0 measured";
        assert_eq!(passed_in_rust(rust), Some(12));
        assert_eq!(passed_in_rust("test shape ... ok"), None);
        assert_eq!(
            passed_in_python("======= 31 passed in 4.20s ======="),
            Some(31)
        );
        assert_eq!(passed_in_python("2 skipped, 7 passed in 0.1s"), Some(7));
    }
}
