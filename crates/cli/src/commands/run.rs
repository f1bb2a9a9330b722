//! `pelletflow run`.

mod page;
mod profile;

use crate::args::RunArguments;
use crate::exit::{Exit, Failure};
use crate::progress::Teller;
use crate::screen;
use pelletflow_log::{Ended, RunError, RunRequest, Summary};
use pelletflow_scene::{ExpectationOutcome, Scene};
use pelletflow_sim::Simulation;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// Set by Ctrl-C; a process has one keyboard, so one flag will do.
static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Runs a scene and writes what came of it.
pub(crate) fn run(arguments: &RunArguments) -> Result<Exit, Failure> {
    let scene = Scene::read(&arguments.scene, &arguments.set)?;
    // To the simulation, no threads means one per core.
    let threads = arguments.threads.unwrap_or(0);
    let mut simulation = Simulation::new(scene.model.clone(), threads)
        .map_err(|errors| Failure::from(scene.locate(&errors)))?;
    let directory = arguments
        .output
        .clone()
        .unwrap_or_else(|| PathBuf::from("out").join(&scene.name));

    listen_for_interrupt();
    let outcome = drive(&mut simulation, &scene, &directory, arguments);
    let (summary, failure) = match outcome {
        Ok(summary) => (summary, None),
        Err(RunError::Physics { error, summary }) => (*summary, Some(error)),
        Err(error) => return Err(error.into()),
    };

    let mut json = serde_json::to_value(&summary).expect("a summary is plain data");
    let outcomes = scene.expectations.check(&json);
    if arguments.json {
        json["expectations"] = outcomes.iter().map(expectation_json).collect();
        screen::json(&json)?;
    } else {
        let page = (!arguments.quiet).then(|| page::page(&scene, &summary, &outcomes, &directory));
        let profile = arguments.profile.then(|| profile::table(&summary));
        let sections: Vec<String> = page.into_iter().chain(profile).collect();
        if !sections.is_empty() {
            screen::result(&sections.join("\n\n"))?;
        }
    }
    verdict(&summary, failure.map(|error| error.to_string()), &outcomes)
}

/// What the exit code is, and why.
fn verdict(
    summary: &Summary,
    failure: Option<String>,
    outcomes: &[ExpectationOutcome],
) -> Result<Exit, Failure> {
    if let Some(message) = failure {
        return Err(Failure::new(Exit::Failed, message));
    }
    if summary.ended == Ended::Interrupted {
        return Ok(Exit::Interrupted);
    }
    let missed: Vec<String> = outcomes
        .iter()
        .filter(|outcome| !outcome.is_met)
        .map(|outcome| {
            let ExpectationOutcome {
                key,
                expected,
                found,
                ..
            } = outcome;
            format!("expect.\"{key}\": found {found}, expected {expected}")
        })
        .collect();
    if missed.is_empty() {
        Ok(Exit::Done)
    } else {
        Err(Failure::new(Exit::Failed, missed.join("\n")))
    }
}

fn listen_for_interrupt() {
    IS_INTERRUPTED.store(false, Ordering::Relaxed);
    // A second run in one process finds the handler there, which is as good.
    let _ = ctrlc::set_handler(|| IS_INTERRUPTED.store(true, Ordering::Relaxed));
}

fn drive(
    simulation: &mut Simulation,
    scene: &Scene,
    directory: &Path,
    arguments: &RunArguments,
) -> Result<Summary, RunError> {
    let request = RunRequest {
        directory,
        scene_name: &scene.name,
        scene_title: &scene.title,
        scene_text: &scene.text,
        scene_hash: &scene.hash,
        scene_files: &scene.files,
        plan: &scene.plan,
        spheres_up_to: scene.output.spheres_up_to,
    };
    let mut teller = if arguments.quiet {
        Teller::Silent
    } else {
        Teller::suiting()
    };
    let summary = pelletflow_log::run(simulation, &request, &mut |progress| {
        teller.tell(progress);
        if IS_INTERRUPTED.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    teller.finish();
    summary
}

fn expectation_json(outcome: &ExpectationOutcome) -> Value {
    json!({
        "key": outcome.key,
        "expected": outcome.expected,
        "found": outcome.found,
        "is_met": outcome.is_met,
    })
}
