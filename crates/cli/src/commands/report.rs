//! `pelletflow report`.

use crate::args::report::ReportArguments;
use crate::args::score::{LawName, StrengthArgument, USUAL_PLACES};
use crate::commands::score::Asked;
use crate::exit::{Exit, Failure};
use crate::table::{bytes, number};
use crate::{file, screen};
use pelletflow_log::{ReportCheck, ReportRequest, ReportStrength, read_attachment, report};
use pelletflow_scene::Scene;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Writes a recording as a page.
pub(crate) fn write_report(arguments: &ReportArguments) -> Result<Exit, Failure> {
    let output = match &arguments.output {
        Some(output) => output.clone(),
        None => arguments.recording.with_file_name("report.html"),
    };
    if output.is_dir() {
        let message = format!(
            "{} is a directory; name a file in it, such as {}",
            output.display(),
            output.join("report.html").display()
        );
        return Err(Failure::new(Exit::BadInput, message));
    }
    let known = Known::beside(&arguments.recording);
    let strength = match (&arguments.strength, known.strength) {
        (Some(strength), _) => Some(Asked::new(strength, arguments.law)?),
        (None, Some(load)) => Some(Asked::new(&StrengthArgument::Load(load), LawName::Load)?),
        (None, None) => None,
    };
    let report = report(&ReportRequest {
        recording: &arguments.recording,
        most_bytes: arguments.max_size,
        strength: strength.as_ref().map(|asked| ReportStrength {
            request: asked.request(USUAL_PLACES),
            told: &asked.told,
        }),
        materials: &known.materials,
        checks: &known.checks,
    })?;
    file::write(&output, &report.html)?;
    let mut told = format!("{}: {}", output.display(), bytes(report.html.len() as u64));
    for omission in &report.omissions {
        told.push_str("\nnot all is on the page; it shows ");
        told.push_str(omission);
    }
    screen::result(&told)?;
    Ok(Exit::Done)
}

/// What the files beside a recording tell of it, as far as they are of the same run.
#[derive(Default)]
struct Known {
    /// Force at which half of the pellets break [N].
    strength: Option<f64>,
    materials: Vec<(String, String)>,
    checks: Vec<ReportCheck>,
}

impl Known {
    /// A recording that was taken elsewhere stands alone, and tells less.
    fn beside(recording: &Path) -> Self {
        Self::read(recording).unwrap_or_default()
    }

    fn read(recording: &Path) -> Option<Self> {
        let path = recording.with_file_name("scene.toml");
        if read_attachment(recording, "scene.toml").ok()? != fs::read_to_string(&path).ok()? {
            return None;
        }
        let scene = Scene::read(&path, &[]).ok()?;
        let materials = scene.setup.materials.iter().map(|named| {
            let material = &named.material;
            let told = format!(
                "{} kg/m³, Young's modulus {} GPa, Poisson's ratio {}",
                number(material.density),
                number(material.youngs_modulus * 1.0e-9),
                number(material.poisson_ratio)
            );
            (named.name.clone(), told)
        });
        Some(Self {
            strength: scene.strength.map(|strength| strength.load),
            materials: materials.collect(),
            checks: checks(&recording.with_file_name("summary.json"), &scene),
        })
    }
}

/// How the expectations of a scene came out, if its run has a summary.
fn checks(summary: &Path, scene: &Scene) -> Vec<ReportCheck> {
    let text = fs::read_to_string(summary).unwrap_or_default();
    let Ok(summary) = serde_json::from_str::<Value>(&text) else {
        return Vec::new();
    };
    if summary["scene_hash"] != *scene.hash {
        return Vec::new();
    }
    let outcomes = scene.expectations.check(&summary).into_iter();
    outcomes
        .map(|outcome| ReportCheck {
            key: outcome.key,
            expected: outcome.expected,
            found: outcome.found,
            is_met: outcome.is_met,
        })
        .collect()
}
