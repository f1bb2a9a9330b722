//! What a run leaves, opened as its users do: the report in a browser, the export in VTK.

use crate::process;
use crate::venv::Venv;
use crate::workspace::{cargo, root, target};
use anyhow::Result;
use std::env;
use std::path::{Path, PathBuf};

/// The scene that is looked at, by its recording among those of the example scenes.
const SCENE: &str = "hopper";
/// Programs that are Chromium under one of its names.
const BROWSERS: [&str; 4] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
];

/// Opens the report and the export of a recording among those of a folder.
pub(crate) fn check(recordings: &Path) -> Result<String> {
    let venv = Venv::with(&["requirements-test.txt", "requirements-viewers.txt"])?;
    let folder = target().join("viewers");
    let recording = recordings.join(SCENE).join("run.mcap");
    pelletflow(
        &["export", "--format", "vtk", "--output"],
        &folder.join("vtk"),
        &recording,
    )?;
    process::run(
        script(&venv, "validate_export.py")
            .arg(&recording)
            .arg(folder.join("vtk")),
    )?;
    let report = folder.join("report.html");
    pelletflow(&["report", "--output"], &report, &recording)?;
    let Some(browser) = browser() else {
        return Ok(
            "export read by VTK; report not opened, as there is no Chromium here (apt install chromium)"
                .to_owned(),
        );
    };
    process::run(script(&venv, "validate_report.py").arg(browser).arg(report))?;
    Ok("report opened by Chromium, export read by VTK".to_owned())
}

fn pelletflow(arguments: &[&str], output: &Path, recording: &Path) -> Result<()> {
    process::run(
        cargo()
            .args(["run", "--release", "--"])
            .args(arguments)
            .arg(output)
            .arg(recording),
    )
}

fn script(venv: &Venv, name: &str) -> std::process::Command {
    let mut command = venv.tool("python");
    command.arg(root().join("python/tests").join(name));
    command
}

/// The Chromium of this machine.
fn browser() -> Option<PathBuf> {
    let folders = env::var_os("PATH")?;
    BROWSERS.iter().find_map(|name| {
        env::split_paths(&folders)
            .map(|folder| folder.join(name))
            .find(|path| path.is_file())
    })
}
