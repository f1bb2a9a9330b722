//! How far off the answers of a case are.

use super::bench::{Bench, Finish, Pace};
use super::case::Accuracy;
use super::code::Code;
use super::ours::{Route, Told};
use super::race::{Floor, Length};
use super::row::AnswerError;
use crate::workspace::target;
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::Path;

/// Steps after which the usual path and the reference path are held against each other.
const COMPARED: u64 = 100;
/// Cores that count discharged pellets, where no time is taken.
const COUNTING_CORES: usize = 2;
/// Standard deviations on either side that hold 95 % of a normal distribution [-].
const WITHIN_95_PERCENT: f64 = 1.96;

/// Pellets that left.
pub(crate) struct Counted {
    ours: f64,
    /// By the codes with the same law.
    theirs: Vec<(Code, f64)>,
}

/// The error of our last run and of theirs, by the measure of the case.
pub(crate) fn of(
    bench: &mut Bench,
    accuracy: Accuracy,
    scene: &'static str,
    cores: usize,
    finish: &Finish,
) -> Result<AnswerError> {
    let (ours, theirs) = finish
        .ours
        .last()
        .zip(finish.theirs.last())
        .context("there is at least one round")?;
    match accuracy {
        Accuracy::Rest => {
            let off = off_reference(bench, scene, cores)?;
            let inputs = bench.inputs(scene)?;
            let scale = inputs.pellets as f64
                * inputs.scene.mass()
                * inputs.scene.weight()
                * inputs.scene.diameter;
            Ok(AnswerError {
                ours: ours.kinetic / scale,
                theirs: Some(theirs.kinetic / scale),
                of: format!(
                    "kinetic energy left at rest, over m g d; {off:.0e} d off the reference path after {COMPARED} steps"
                ),
            })
        }
        Accuracy::Discharge { steps } => discharge(bench, scene, steps),
        Accuracy::Motion => Ok(AnswerError {
            ours: ours.kinetic / theirs.kinetic - 1.0,
            theirs: None,
            of: format!(
                "kinetic energy at the end, of that of {}; {:.1} % of the pellets move",
                finish.fastest.name(),
                100.0 * finish.moving
            ),
        }),
    }
}

/// What the energy books miss.
pub(crate) fn of_energy(told: &Told) -> AnswerError {
    AnswerError {
        ours: told.residual.unwrap_or(0.0).abs(),
        theirs: None,
        of: format!(
            "residual of the energy ledger, over its throughput; {:.1} contacts per pellet",
            told.coordination
        ),
    }
}

/// Pellets that left, ours against the mean of the codes with the same law.
fn discharge(bench: &mut Bench, scene: &'static str, steps: u64) -> Result<AnswerError> {
    if !bench.left.contains_key(scene) {
        let counted = counted(bench, scene, steps)?;
        bench.left.insert(scene, counted);
    }
    let Counted { ours, theirs } = &bench.left[scene];
    let counts: Vec<String> = theirs
        .iter()
        .map(|(code, left)| format!("{} {left}", code.name()))
        .collect();
    let codes = theirs.len() as f64;
    let mean = theirs.iter().map(|(_, left)| left).sum::<f64>() / codes;
    // As counts of independent events; a flow of touching pellets scatters less.
    let interval = WITHIN_95_PERCENT * (ours + mean / codes).sqrt();
    Ok(AnswerError {
        ours: (ours - mean) / mean,
        theirs: None,
        of: format!(
            "pellets that left, {ours} against {}; 95 % interval ±{:.1e}",
            counts.join(", "),
            interval / mean
        ),
    })
}

fn counted(bench: &Bench, scene: &'static str, steps: u64) -> Result<Counted> {
    eprintln!("counting the pellets that leave ...");
    let steps = match bench.pace {
        Pace::Quick => steps / 4,
        Pace::Full => steps,
    };
    let length = Length { warm: 0, steps };
    let ours = bench
        .ours
        .run(scene, COUNTING_CORES, Floor::Opens, length)?
        .left;
    let codes = [Code::LammpsGranular, Code::Liggghts];
    let theirs = codes
        .into_iter()
        .filter(|code| code.has_the_same_law() && bench.installed(*code).is_some())
        .map(|code| {
            let outcome = bench.theirs(code, scene, COUNTING_CORES, Floor::Opens, length)?;
            Ok((code, outcome.left))
        })
        .collect::<Result<_>>()?;
    Ok(Counted { ours, theirs })
}

/// Greatest distance between pellets by the usual path and by the reference path over the diameter [-].
fn off_reference(bench: &mut Bench, scene: &'static str, cores: usize) -> Result<f64> {
    if let Some(off) = bench.off_reference.get(scene) {
        return Ok(*off);
    }
    let folder = target().join("peers/ends");
    let [usual, reference] = ["usual.txt", "reference.txt"].map(|name| folder.join(name));
    let ours = &bench.ours;
    ours.ends(scene, cores, Route::Usual, COMPARED, &usual)?;
    ours.ends(scene, 1, Route::Reference, COMPARED, &reference)?;
    let (usual, reference) = (centers(&usual)?, centers(&reference)?);
    ensure!(
        usual.len() == reference.len(),
        "{} pellets by the usual path, {} by the reference path of `{scene}`",
        usual.len(),
        reference.len()
    );
    let diameter = bench.inputs(scene)?.scene.diameter;
    let off = usual
        .iter()
        .zip(&reference)
        .flat_map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).abs() / diameter))
        .fold(0.0, f64::max);
    bench.off_reference.insert(scene, off);
    Ok(off)
}

fn centers(path: &Path) -> Result<Vec<Vec<f64>>> {
    let text =
        fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    let center = |line: &str| -> Vec<f64> {
        line.split(' ')
            .take(3)
            .map_while(|word| word.parse().ok())
            .collect()
    };
    // The first line tells what the file is of.
    Ok(text.lines().skip(1).map(center).collect())
}
