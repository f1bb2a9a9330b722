//! `pelletflow run`.

use crate::args::RunArguments;
use crate::exit::{Exit, Failure};
use crate::progress::Teller;
use crate::screen;
use crate::table::{self, bytes, count, number, span};
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
    } else if !arguments.quiet {
        screen::result(&page(&scene, &summary, &outcomes, &directory))?;
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

fn page(
    scene: &Scene,
    summary: &Summary,
    outcomes: &[ExpectationOutcome],
    directory: &Path,
) -> String {
    let mut sections = vec![scene.title.clone(), table::facts(facts(summary))];
    if !outcomes.is_empty() {
        let rows = outcomes.iter().map(|outcome| {
            [
                outcome.key.clone(),
                outcome.expected.clone(),
                outcome.found.clone(),
                if outcome.is_met { "met" } else { "NOT MET" }.into(),
            ]
        });
        let header = ["expectation", "expected", "found", ""];
        sections.push(table::listing(header, &[], rows));
    }
    let always = ["run.mcap", "summary.json", "scene.toml", "layout.json"].map(str::to_owned);
    let with_patches = summary
        .meters
        .iter()
        .filter(|(_, meter)| !meter.worst.is_empty());
    let tables = with_patches.map(|(name, _)| format!("meters/{name}.csv"));
    let files = always.into_iter().chain(tables).map(|file| {
        let path = directory.join(&file).display().to_string();
        (file, path)
    });
    sections.push(table::facts(files));
    sections.join("\n\n")
}

fn facts(summary: &Summary) -> Vec<(String, String)> {
    let Summary {
        time,
        bodies,
        mass,
        contacts,
        energy,
        performance,
        ..
    } = summary;
    let tally = |number_of: u64, mass: f64| format!("{}, {} kg", count(number_of), number(mass));
    let mut facts = vec![
        ("ended".to_owned(), ended(summary.ended).to_owned()),
        (
            "simulated time".into(),
            format!("{} s", number(time.simulated_s)),
        ),
        (
            "steps".into(),
            format!("{} of {}", count(time.steps), span(time.step_s)),
        ),
        ("inserted".into(), tally(bodies.inserted, mass.inserted)),
        (
            "discharged".into(),
            tally(bodies.discharged, mass.discharged),
        ),
        ("inside".into(), tally(bodies.inside, mass.inside)),
        ("lost".into(), tally(bodies.lost, mass.lost)),
        (
            "greatest force".into(),
            format!("{} N", number(contacts.max_force_n)),
        ),
        (
            "greatest overlap".into(),
            format!(
                "{} % of the radius",
                number(100.0 * contacts.max_overlap_ratio)
            ),
        ),
        ("steps per contact".into(), number(time.steps_per_contact)),
        (
            "turned into heat".into(),
            format!("{} J", number(energy.dissipated_j)),
        ),
        (
            "energy not accounted for".into(),
            format!("{} J", number(energy.residual_j)),
        ),
        (
            "run time".into(),
            format!("{}, {} threads", span(time.wall_s), summary.threads),
        ),
        (
            "speed".into(),
            format!(
                "{} pellet steps/s",
                number(performance.particle_steps_per_s)
            ),
        ),
    ];
    if let Some(memory) = performance.peak_memory_bytes {
        facts.push(("memory".into(), bytes(memory)));
    }
    for (name, meter) in &summary.meters {
        for (quantity, value) in &meter.values {
            facts.push((format!("{name}: {quantity}"), number(*value)));
        }
    }
    for skipped in &summary.skipped {
        let what = format!("skipped: {}", skipped.what);
        facts.push((what, format!("{}; {}", skipped.reason, skipped.saved)));
    }
    facts
}

fn ended(ended: Ended) -> &'static str {
    match ended {
        Ended::EndTime => "at its end time",
        Ended::Empty => "early: no pellet is inside any more",
        Ended::Settled => "early: the bed is at rest",
        Ended::Interrupted => "early: interrupted",
        Ended::Failed => "early: the physics failed",
    }
}

fn expectation_json(outcome: &ExpectationOutcome) -> Value {
    json!({
        "key": outcome.key,
        "expected": outcome.expected,
        "found": outcome.found,
        "is_met": outcome.is_met,
    })
}
