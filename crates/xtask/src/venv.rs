//! Python environments of the workspace's own, under `target`.

use crate::process;
use crate::workspace::{root, target};
use anyhow::Result;
use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The environment.
pub(crate) struct Venv {
    folder: PathBuf,
}

impl Venv {
    /// The environment of the tests, `target/venv`, with the pinned packages of requirement files.
    pub(crate) fn with(requirements: &[&str]) -> Result<Self> {
        Self::at(target().join("venv"), requirements)
    }

    /// Makes an environment where it is missing and installs the pinned packages of requirement files.
    pub(crate) fn at(folder: PathBuf, requirements: &[&str]) -> Result<Self> {
        let venv = Self { folder };
        if !venv.program("python").exists() {
            let python = env::var_os("PYTHON").unwrap_or_else(|| OsString::from(SYSTEM_PYTHON));
            process::run(Command::new(python).args(["-m", "venv"]).arg(&venv.folder))?;
        }
        if requirements.is_empty() {
            return Ok(venv);
        }
        let mut install = venv.pip_install();
        for file in requirements {
            install
                .arg("--requirement")
                .arg(root().join("python").join(file));
        }
        process::run(&mut install)?;
        Ok(venv)
    }

    /// Installs a wheel and what it needs.
    pub(crate) fn install(&self, wheel: &Path) -> Result<()> {
        process::run(self.pip_install().arg(wheel))
    }

    /// Builds the wheel as the workspace stands and installs it in place of an earlier one.
    pub(crate) fn install_wheel(&self) -> Result<()> {
        let mut install = self.pip_install();
        install
            .current_dir(root())
            .env("PATH", self.path_first())
            // The development profile shares what the Rust tests have built.
            .args(["--config-settings", "build-args=--profile=dev"])
            .args([
                "--no-build-isolation",
                "--no-deps",
                "--force-reinstall",
                ".",
            ]);
        process::run(&mut install)
    }

    /// A Python module as a program, started outside the source tree so that the installed wheel is imported.
    pub(crate) fn module(&self, module: &str) -> Command {
        let mut command = self.tool("python");
        command.args(["-m", module]);
        command
    }

    /// A program of the environment, started outside the source tree.
    pub(crate) fn tool(&self, name: &str) -> Command {
        let mut command = Command::new(self.program(name));
        command.current_dir(&self.folder);
        command
    }

    /// Where the libraries of its packages are.
    pub(crate) fn libraries(&self) -> PathBuf {
        self.folder.join("lib")
    }

    fn pip_install(&self) -> Command {
        let mut command = self.module("pip");
        command.args(["install", "--quiet", "--disable-pip-version-check"]);
        command
    }

    /// The search path with this environment's programs first, so that the build finds its maturin.
    fn path_first(&self) -> OsString {
        let inherited = env::var_os("PATH").unwrap_or_default();
        let folders =
            std::iter::once(self.folder.join(PROGRAMS)).chain(env::split_paths(&inherited));
        env::join_paths(folders).unwrap_or(inherited)
    }

    /// A program of the environment.
    pub(crate) fn program(&self, name: &str) -> PathBuf {
        self.folder
            .join(PROGRAMS)
            .join(name)
            .with_extension(env::consts::EXE_EXTENSION)
    }
}

const PROGRAMS: &str = if cfg!(windows) { "Scripts" } else { "bin" };
const SYSTEM_PYTHON: &str = if cfg!(windows) { "python" } else { "python3" };
