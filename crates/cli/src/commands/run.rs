//! `pelletflow run`.

mod going_on;
mod live;
mod page;
mod profile;

use crate::args::RunArguments;
use crate::exit::{Exit, Failure};
use crate::progress::Teller;
use crate::screen;
use pelletflow_log::{Earlier, Ended, Live, Progress, RunError, RunRequest, Summary};
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
    let directory = arguments
        .output
        .clone()
        .unwrap_or_else(|| PathBuf::from("out").join(&scene.name));
    let live = arguments.live.as_deref().map(Live::start).transpose()?;
    let request = RunRequest {
        directory: &directory,
        scene_name: &scene.name,
        scene_title: &scene.title,
        scene_text: &scene.text,
        scene_hash: &scene.hash,
        scene_files: &scene.files,
        plan: &scene.plan,
        spheres_up_to: scene.output.spheres_up_to,
        contacts: scene.output.contacts,
        live: live.as_ref(),
    };
    let earlier = going_on::earlier(&request, arguments)?;
    if let Earlier::Finished(summary) = &earlier {
        if !arguments.quiet {
            screen::remark(&going_on::finished(&directory));
        }
        let outcomes = told(&scene, summary, &directory, arguments)?;
        return verdict(summary, None, &outcomes);
    }

    if let Some(live) = &live {
        live::invite(live, &directory, arguments)?;
    }
    listen_for_interrupt();
    let (summary, failure) = match drive(earlier, &scene, &request, arguments)? {
        Ok(summary) => (summary, None),
        Err(RunError::Physics { error, summary }) => (*summary, Some(error)),
        Err(error) => return Err(error.into()),
    };
    let outcomes = told(&scene, &summary, &directory, arguments)?;
    if summary.ended == Ended::Interrupted && !arguments.quiet {
        screen::remark(&going_on::how_to(&summary, &directory, arguments));
    }
    verdict(&summary, failure.map(|error| error.to_string()), &outcomes)
}

/// Shows what came of a run; how its expectations fared.
fn told(
    scene: &Scene,
    summary: &Summary,
    directory: &Path,
    arguments: &RunArguments,
) -> Result<Vec<ExpectationOutcome>, Failure> {
    let mut json = serde_json::to_value(summary).expect("a summary is plain data");
    let outcomes = scene.expectations.check(&json);
    if arguments.json {
        json["expectations"] = outcomes.iter().map(expectation_json).collect();
        screen::json(&json)?;
    } else {
        let page = (!arguments.quiet).then(|| page::page(scene, summary, &outcomes, directory));
        let profile = arguments.profile.then(|| profile::table(summary));
        let sections: Vec<String> = page.into_iter().chain(profile).collect();
        if !sections.is_empty() {
            screen::result(&sections.join("\n\n"))?;
        }
    }
    Ok(outcomes)
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

/// Drives a run to its end, from its start or from where it was interrupted.
fn drive(
    earlier: Earlier,
    scene: &Scene,
    request: &RunRequest,
    arguments: &RunArguments,
) -> Result<Result<Summary, RunError>, Failure> {
    // To the simulation, no threads means one per core.
    let threads = arguments.threads.unwrap_or(0);
    let mut teller = if arguments.quiet {
        Teller::Silent
    } else {
        Teller::suiting()
    };
    let mut observer = |progress: &Progress| {
        teller.tell(progress);
        if IS_INTERRUPTED.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let model = scene.model.clone();
    let outcome = if let Earlier::Unfinished(resumption) = earlier {
        resumption.run(model, threads, request, &mut observer)
    } else {
        let mut simulation = Simulation::new(model, threads)
            .map_err(|errors| Failure::from(scene.locate(&errors)))?;
        pelletflow_log::run(&mut simulation, request, &mut observer)
    };
    teller.finish();
    Ok(outcome)
}

fn expectation_json(outcome: &ExpectationOutcome) -> Value {
    json!({
        "key": outcome.key,
        "expected": outcome.expected,
        "found": outcome.found,
        "is_met": outcome.is_met,
    })
}
