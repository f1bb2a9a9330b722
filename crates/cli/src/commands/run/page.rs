//! What `pelletflow run` shows at the end.

use crate::table::{self, bytes, count, number, span};
use pelletflow_log::{Ended, Summary};
use pelletflow_scene::{ExpectationOutcome, Scene};
use std::path::Path;

/// All that is shown of a run that is over.
pub(super) fn page(
    scene: &Scene,
    summary: &Summary,
    outcomes: &[ExpectationOutcome],
    directory: &Path,
) -> String {
    let mut sections = vec![scene.title.clone(), table::facts(facts(summary))];
    if !summary.skipped.is_empty() {
        let rows = summary.skipped.iter().map(|skipped| {
            [
                skipped.what.clone(),
                skipped.reason.clone(),
                skipped.saved.clone(),
            ]
        });
        sections.push(table::listing(["skipped", "why", "saved"], &[], rows));
    }
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
