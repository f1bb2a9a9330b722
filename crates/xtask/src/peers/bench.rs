//! All codes at hand, and runs of them.

use super::accuracy::Counted;
use super::code::Code;
use super::inputs::Inputs;
use super::install::Installed;
use super::log;
use super::ours::{Ours, Told};
use super::race::{self, Floor, Length, Outcome, Spread};
use crate::process;
use crate::workspace::target;
use anyhow::{Context, Result, ensure};
use std::collections::BTreeMap;
use std::fs;

/// All codes at hand, and what was worked out for one case and serves others.
pub(crate) struct Bench {
    pub(crate) ours: Ours,
    pub(crate) peers: Vec<Installed>,
    pub(crate) pace: Pace,
    inputs: BTreeMap<&'static str, Inputs>,
    /// Pellets that left, by scene.
    pub(crate) left: BTreeMap<&'static str, Counted>,
    /// Greatest distance from the reference path, by scene over the diameter [-].
    pub(crate) off_reference: BTreeMap<&'static str, f64>,
}

/// The outcomes of a race: ours, and those of the fastest other code.
pub(crate) struct Finish {
    pub(crate) ours: Vec<Outcome>,
    pub(crate) fastest: Code,
    pub(crate) theirs: Vec<Outcome>,
    /// Share of the pellets that move at the end of ours [-].
    pub(crate) moving: f64,
}

/// How thorough a pass is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pace {
    Quick,
    Full,
}

impl Pace {
    fn rounds(self) -> usize {
        match self {
            Self::Quick => 3,
            Self::Full => 5,
        }
    }

    /// A run's length at this pace.
    pub(crate) fn length(self, full: Length) -> Length {
        match self {
            Self::Quick => Length {
                warm: full.warm / 2,
                steps: (full.steps / 2).max(1),
            },
            Self::Full => full,
        }
    }
}

impl Bench {
    pub(crate) fn new(ours: Ours, peers: Vec<Installed>, pace: Pace) -> Self {
        Self {
            ours,
            peers,
            pace,
            inputs: BTreeMap::new(),
            left: BTreeMap::new(),
            off_reference: BTreeMap::new(),
        }
    }

    /// Our outcomes and those of the fastest of some codes, in rounds side by side.
    pub(crate) fn race(
        &mut self,
        scene: &'static str,
        cores: usize,
        floor: Floor,
        codes: &[Code],
        length: Length,
    ) -> Result<Finish> {
        let codes: Vec<Code> = codes
            .iter()
            .copied()
            .filter(|code| self.installed(*code).is_some())
            .collect();
        ensure!(
            !codes.is_empty(),
            "no other code is installed that runs `{scene}`; see above why"
        );
        self.prepare(scene)?;
        let mut moving = 0.0;
        let mut outcomes = race::run(codes.len() + 1, self.pace.rounds(), |racer| {
            if racer == 0 {
                let told = self.ours.run(scene, cores, floor, length)?;
                progress("pelletflow", &told.outcome());
                moving = told.moving;
                return Ok(told.outcome());
            }
            self.theirs(codes[racer - 1], scene, cores, floor, length)
        })?;
        let ours = outcomes.remove(0);
        let (fastest, theirs) = codes
            .into_iter()
            .zip(outcomes)
            .min_by(|(_, a), (_, b)| race::median_seconds(a).total_cmp(&race::median_seconds(b)))
            .context("there is at least one code")?;
        Ok(Finish {
            ours,
            fastest,
            theirs,
            moving,
        })
    }

    /// Rounds of our own scenes, each on a number of threads.
    pub(crate) fn alone(&self, racers: &[(&str, usize)], length: Length) -> Result<Vec<Vec<Told>>> {
        let mut told = vec![Vec::new(); racers.len()];
        race::run(racers.len(), self.pace.rounds(), |racer| {
            let (scene, threads) = racers[racer];
            let run = self.ours.run(scene, threads, Floor::Closed, length)?;
            let outcome = run.outcome();
            progress(scene, &outcome);
            told[racer].push(run);
            Ok(outcome)
        })?;
        Ok(told)
    }

    /// One run of another code.
    pub(crate) fn theirs(
        &self,
        code: Code,
        scene: &str,
        cores: usize,
        floor: Floor,
        length: Length,
    ) -> Result<Outcome> {
        let (installed, inputs) = self
            .installed(code)
            .zip(self.inputs.get(scene))
            .context("the code and its inputs are there")?;
        let script = inputs.script(code, floor, length)?;
        let name = format!("{}-{cores}.log", code.file_stem());
        let told = process::answer(
            installed
                .command(cores)
                .args(["-in", &script, "-log", &name])
                .current_dir(&inputs.folder),
        );
        let path = inputs.folder.join(name);
        let log = fs::read_to_string(&path).unwrap_or_default();
        let outcome = told.ok().and_then(|_| log::parsed(&log)).with_context(|| {
            format!(
                "{} did not finish `{scene}`; {} ends:\n{}",
                code.name(),
                path.display(),
                process::tail(&log)
            )
        })?;
        // Frozen balls are among its pellets; only those that move count.
        let outcome = Outcome {
            pellet_steps: inputs.pellets as f64 * length.steps as f64,
            ..outcome
        };
        progress(code.name(), &outcome);
        Ok(outcome)
    }

    pub(crate) fn installed(&self, code: Code) -> Option<&Installed> {
        self.peers
            .iter()
            .find(|installed| installed.program == code.program())
    }

    pub(crate) fn inputs(&self, scene: &str) -> Result<&Inputs> {
        self.inputs
            .get(scene)
            .with_context(|| format!("`{scene}` was not prepared"))
    }

    /// Has the bed of a scene settled and written for the other codes.
    fn prepare(&mut self, scene: &'static str) -> Result<()> {
        if self.inputs.contains_key(scene) {
            return Ok(());
        }
        eprintln!("preparing `{scene}`; the first time takes minutes ...");
        let folder = target().join("peers/inputs").join(scene);
        let places = folder.join("places.txt");
        self.ours.start(scene, &places)?;
        let description = serde_json::from_value(self.ours.describe(scene)?)?;
        let inputs = Inputs::write(folder, description, &places)?;
        self.inputs.insert(scene, inputs);
        Ok(())
    }
}

/// Median speed [million pellet-steps/s].
pub(crate) fn speed(outcomes: &[Outcome]) -> f64 {
    let speeds = outcomes
        .iter()
        .map(|outcome| 1.0e-6 * outcome.pellet_steps / outcome.seconds);
    Spread::of(speeds).median
}

fn progress(name: &str, outcome: &Outcome) {
    eprintln!(
        "  {name:<28}{:>9.3} M/s {:>9.3} s   kinetic {:.2e} J   left {}",
        speed(&[*outcome]),
        outcome.seconds,
        outcome.kinetic,
        outcome.left
    );
}
