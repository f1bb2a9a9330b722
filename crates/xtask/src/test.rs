//! `cargo xtask test`: every test there is, on a machine with only Rust and Python 3.

use crate::process;
use crate::report::Report;
use crate::venv::Venv;
use crate::workspace::{cargo, root, target};
use anyhow::{Result, ensure};
use std::env;
use std::fs;
use std::process::Command;

/// The template of the short recording: one that runs in a moment.
const RECORDED_TEMPLATE: &str = "drop";

/// Sets up and runs every test.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    report.part("Rust tests", rust_tests)?;
    let venv = Venv::with(&["requirements-test.txt"])?;
    wheel_and_recording(report, &venv)
}

/// The tests that need Python: of the wheel, and of a recording by an independent reader.
pub(crate) fn wheel_and_recording(report: &mut Report, venv: &Venv) -> Result<()> {
    report.part("wheel", || {
        venv.install_wheel()?;
        Ok("built and installed".to_owned())
    })?;
    report.part("Python tests", || python_tests(venv))?;
    report.part("recording", || recording(venv))
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

/// Records a short run and has a reader of its own check the file.
fn recording(venv: &Venv) -> Result<String> {
    // The same packages as in the tests, so that nothing is built anew.
    process::run(cargo().args(["build", "--workspace", "--bins"]).args([
        "--exclude",
        "pelletflow-py",
        "--exclude",
        "xtask",
    ]))?;
    let folder = target().join("recording");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    fs::create_dir_all(&folder)?;
    let program = target().join(format!("debug/pelletflow{}", env::consts::EXE_SUFFIX));
    let pelletflow = |arguments: &[&str]| {
        process::run(Command::new(&program).current_dir(&folder).args(arguments))
    };
    let scene = format!("{RECORDED_TEMPLATE}.toml");
    pelletflow(&["new", RECORDED_TEMPLATE])?;
    pelletflow(&["run", &scene, "--output", "."])?;
    process::run(
        venv.tool("python")
            .arg(root().join("python/tests/validate_recording.py"))
            .arg(folder.join("run.mcap")),
    )?;
    Ok("written and validated".to_owned())
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
