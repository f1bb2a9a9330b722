//! `cargo xtask check`: all that a change has to pass.

use crate::report::Report;
use crate::venv::Venv;
use crate::workspace::{cargo, root};
use crate::{dependencies, documentation, process, test};
use anyhow::Result;
use std::process::Command;

/// Runs the whole gate, the quick parts first.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    let passed = |command: &mut Command| process::run(command).map(|()| "passed".to_owned());
    report.part("format", || {
        passed(cargo().args(["fmt", "--all", "--check"]))
    })?;
    let venv = Venv::with(&[
        "requirements-build.txt",
        "requirements-test.txt",
        "requirements-check.txt",
    ])?;
    report.part("spelling", || {
        passed(venv.tool("typos").current_dir(root()))
    })?;
    report.part("Python format", || {
        process::run(ruff(&venv).args(["format", "--check", "python", "benches"]))?;
        passed(ruff(&venv).args(["check", "python", "benches"]))
    })?;
    report.part("dependencies", dependencies::check)?;
    report.part("advisories", dependencies::check_advisories)?;
    report.part("lints", || {
        passed(cargo().args([
            "clippy",
            "--workspace",
            "--all-targets",
            "--",
            "--deny",
            "warnings",
        ]))
    })?;
    report.part("documentation", documentation::check)?;
    report.part("Rust tests", test::rust_tests)?;
    report.part("clock", test::clock)?;
    test::wheel_and_recordings(report, &venv)?;
    report.part("Python types", || {
        process::run(mypy(&venv).args(["--package", "pelletflow"]))?;
        passed(venv.module("mypy.stubtest").args(["pelletflow"]))
    })
}

fn ruff(venv: &Venv) -> Command {
    let mut command = venv.tool("ruff");
    command.current_dir(root());
    command
}

fn mypy(venv: &Venv) -> Command {
    let mut command = venv.module("mypy");
    command.arg("--strict");
    command
}
