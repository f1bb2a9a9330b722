//! Our side: the bench `peer_case`, built once and started for each run.

use super::race::{Floor, Length, Outcome};
use crate::process;
use crate::workspace::{cargo, target};
use anyhow::{Context, Result};
use serde::Deserialize;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The program, and where it keeps beds between runs.
pub(crate) struct Ours {
    program: PathBuf,
    beds: PathBuf,
}

/// Which way the step takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Route {
    /// As a user runs it.
    Usual,
    /// Nothing left out, neighbors found in the plainest way.
    Reference,
}

/// What one run tells.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Told {
    pub(crate) pellets: f64,
    pub(crate) steps: f64,
    pub(crate) seconds: f64,
    /// Kinetic energy at the end, without spin [J].
    pub(crate) kinetic: f64,
    /// Share of the pellets that move [-].
    pub(crate) moving: f64,
    pub(crate) left: f64,
    /// Contacts per pellet at the end [-].
    pub(crate) coordination: f64,
    pub(crate) hash: String,
    /// Residual of the energy ledger over the energy that went through it [-]; none where no energy did.
    pub(crate) residual: Option<f64>,
    pub(crate) peak_memory: Option<f64>,
    pub(crate) flight_error: Option<f64>,
}

impl Told {
    pub(crate) fn outcome(&self) -> Outcome {
        Outcome {
            seconds: self.seconds,
            kinetic: self.kinetic,
            left: self.left,
            pellet_steps: self.pellets * self.steps,
        }
    }

    /// Time of a pellet's step [s].
    pub(crate) fn cost(&self) -> f64 {
        self.seconds / (self.pellets * self.steps)
    }
}

impl Ours {
    /// Builds the program as the workspace stands.
    pub(crate) fn build() -> Result<Self> {
        eprintln!("building pelletflow ...");
        let messages = process::answer(cargo().args(["build", "--release"]).args([
            "--bench",
            "peer_case",
            "--message-format=json",
        ]))?;
        let program = messages
            .lines()
            .filter_map(executable)
            .next_back()
            .context(
                "cargo built no program of the bench `peer_case`; see [[bench]] in Cargo.toml",
            )?;
        Ok(Self {
            program,
            beds: target().join("peers/beds"),
        })
    }

    /// What a scene is made of.
    pub(crate) fn describe(&self, scene: &str) -> Result<Value> {
        ask(self.command("describe", scene))
    }

    /// Writes where the pellets of a scene start.
    pub(crate) fn start(&self, scene: &str, out: &Path) -> Result<()> {
        let mut command = self.command("start", scene);
        command.arg(assignment("out", out.display()));
        ask(command).map(drop)
    }

    /// One run.
    pub(crate) fn run(
        &self,
        scene: &str,
        threads: usize,
        floor: Floor,
        length: Length,
    ) -> Result<Told> {
        let command = self.runs(scene, threads, floor, length);
        Ok(serde_json::from_value(ask(command)?)?)
    }

    /// Where the pellets are after a number of steps from the start, on a route.
    pub(crate) fn ends(
        &self,
        scene: &str,
        threads: usize,
        route: Route,
        steps: u64,
        out: &Path,
    ) -> Result<()> {
        let length = Length { warm: 0, steps };
        let mut command = self.runs(scene, threads, Floor::Closed, length);
        if route == Route::Reference {
            command.arg("path=reference");
        }
        command.arg(assignment("out", out.display()));
        ask(command).map(drop)
    }

    fn runs(&self, scene: &str, threads: usize, floor: Floor, length: Length) -> Command {
        let mut command = self.command("run", scene);
        command
            .arg(assignment("threads", threads))
            .arg(assignment("warm", length.warm))
            .arg(assignment("steps", length.steps));
        if floor == Floor::Opens {
            command.arg("floor=opens");
        }
        command
    }

    fn command(&self, verb: &str, scene: &str) -> Command {
        let mut command = Command::new(&self.program);
        command
            .arg(verb)
            .arg(assignment("scene", scene))
            .arg(assignment("folder", self.beds.display()));
        command
    }
}

/// What a command answers.
fn ask(mut command: Command) -> Result<Value> {
    let told = process::answer(&mut command)?;
    serde_json::from_str(told.trim()).with_context(|| format!("`{told}` is no JSON"))
}

fn assignment(key: &str, value: impl std::fmt::Display) -> String {
    format!("{key}={value}")
}

/// The program that one of cargo's messages tells of.
fn executable(message: &str) -> Option<PathBuf> {
    let message: Value = serde_json::from_str(message).ok()?;
    message.get("executable")?.as_str().map(PathBuf::from)
}
