//! What a run leaves, opened as its users do: the report in a browser, the export in VTK, the recording in Rerun; and a run
//! watched while it goes on.

use crate::process::{self, Failed};
use crate::venv::Venv;
use crate::workspace::{cargo, root, target};
use anyhow::Result;
use std::env;
use std::fs;
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

/// Exit code of `validate_rerun.py` where the viewer does not start.
const NO_VIEWER: u8 = 3;

/// Where Linux keeps what it knows of Vulkan drivers.
const VULKAN_DRIVERS: [&str; 2] = ["/usr/share/vulkan/icd.d", "/etc/vulkan/icd.d"];

/// Opens a recording among those of a folder in all of them, and watches a run; what was opened, and what was not and why.
pub(crate) fn check(recordings: &Path) -> Result<String> {
    let venv = Venv::with(&["requirements-test.txt", "requirements-viewers.txt"])?;
    let recording = recordings.join(SCENE).join("run.mcap");
    let folder = target().join("viewers");
    let told = [
        export(&venv, &recording, &folder.join("vtk"))?,
        report(&venv, &recording, &folder.join("report.html"))?,
        watch(&venv)?,
        rerun(&venv, &recording, &folder.join("rerun.png"))?,
    ];
    Ok(told.join("; "))
}

fn export(venv: &Venv, recording: &Path, folder: &Path) -> Result<String> {
    pelletflow(
        &["export", "--format", "vtk", "--output"],
        folder,
        recording,
    )?;
    process::run(
        script(venv, "validate_export.py")
            .arg(recording)
            .arg(folder),
    )?;
    Ok("export read by VTK".to_owned())
}

fn report(venv: &Venv, recording: &Path, page: &Path) -> Result<String> {
    pelletflow(&["report", "--output"], page, recording)?;
    let Some(browser) = browser() else {
        return Ok(
            "report not opened, as there is no Chromium here (apt install chromium)".to_owned(),
        );
    };
    process::run(script(venv, "validate_report.py").arg(browser).arg(page))?;
    Ok("report opened by Chromium".to_owned())
}

fn watch(venv: &Venv) -> Result<String> {
    // It has just written the report.
    let program = target()
        .join("release")
        .join(format!("pelletflow{}", env::consts::EXE_SUFFIX));
    process::run(script(venv, "validate_live.py").arg(program))?;
    Ok("a run watched over its web socket".to_owned())
}

fn rerun(venv: &Venv, recording: &Path, picture: &Path) -> Result<String> {
    if !can_draw_without_a_screen() {
        return Ok(
            "recording not opened by Rerun, as there is no Vulkan driver here (apt install mesa-vulkan-drivers)"
                .to_owned(),
        );
    }
    let mut look = script(venv, "validate_rerun.py");
    match process::run(look.arg(recording).arg(picture)) {
        Ok(()) => Ok("recording drawn by Rerun".to_owned()),
        Err(error) => match error.downcast_ref::<Failed>() {
            Some(failed) if failed.code == NO_VIEWER => Ok(
                "recording not opened by Rerun, whose viewer does not start on this machine"
                    .to_owned(),
            ),
            _ => Err(error),
        },
    }
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

/// Whether the system tells of a driver that draws into memory; on others than Linux nobody knows.
fn can_draw_without_a_screen() -> bool {
    VULKAN_DRIVERS
        .iter()
        .filter_map(|folder| fs::read_dir(folder).ok())
        .any(|mut drivers| drivers.next().is_some())
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
