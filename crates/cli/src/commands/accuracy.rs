//! `pelletflow accuracy`.

use crate::args::accuracy::AccuracyArguments;
use crate::commands::hit::bad_input;
use crate::exit::{Exit, Failure};
use crate::table::{self, count, number, span};
use crate::{file, screen};
use clap::ValueEnum;
use indicatif::ProgressBar;
use pelletflow_log::accuracy::{AccuracyError, AccuracyRequest, Estimate, Reference, Study, Trial};
use pelletflow_log::plot::{Axis, Chart, Series, SeriesStyle};
use pelletflow_scene::Scene;
use pelletflow_sim::Integrator;
use serde_json::{Value, json};
use std::fmt::Write;
use std::ops::ControlFlow;

/// Runs a scene over step sizes and integrators.
pub(crate) fn accuracy(arguments: &AccuracyArguments) -> Result<Exit, Failure> {
    let scene = Scene::read(&arguments.scene, &arguments.set)?;
    let integrators = if arguments.integrator.is_empty() {
        Integrator::ALL.to_vec()
    } else {
        let names = arguments.integrator.iter();
        names.map(|name| name.integrator()).collect()
    };
    let mut steps_per_contact = arguments.steps_per_contact.clone();
    steps_per_contact.sort_by(f64::total_cmp);
    let request = AccuracyRequest {
        setup: &scene.setup,
        end_time: scene.plan.end_time,
        integrators,
        steps_per_contact,
        repeats: arguments.repeats,
        threads: arguments.threads,
        exact: scene.expectations.exact(),
    };
    let bar = if screen::is_watched() {
        ProgressBar::new(0)
    } else {
        ProgressBar::hidden()
    };
    let study = Study::run(&request, &mut |done, cases| {
        bar.set_length(cases as u64);
        bar.set_position(done as u64);
        ControlFlow::Continue(())
    });
    bar.finish_and_clear();
    let study = study.map_err(|error| refused(&error))?;
    if let Some(path) = &arguments.plot {
        file::draw(path, &chart(&scene.title, &study))?;
    }
    if arguments.json {
        screen::json(&json_of(&study, arguments.error))?;
    } else {
        screen::result(&page(&scene.title, &study, arguments.error))?;
        if let Some(path) = &arguments.plot {
            screen::remark(&format!("{} written", path.display()));
        }
    }
    Ok(Exit::Done)
}

fn refused(error: &AccuracyError) -> Failure {
    match error {
        AccuracyError::Reference(_) => Failure::new(Exit::Failed, error.to_string()),
        AccuracyError::Interrupted => Failure::new(Exit::Interrupted, error.to_string()),
        _ => bad_input(error.to_string()),
    }
}

fn name(integrator: Integrator) -> String {
    use crate::args::accuracy::IntegratorName;
    IntegratorName::value_variants()
        .iter()
        .find(|name| name.integrator() == integrator)
        .and_then(ValueEnum::to_possible_value)
        .map_or_else(String::new, |name| name.get_name().to_owned())
}

/// An error in percent, with its interval where it has one.
fn percent(error: &Estimate) -> String {
    let value = number(100.0 * error.value);
    if error.half_width > 0.0 {
        format!("{value} ± {}", number(100.0 * error.half_width))
    } else {
        value
    }
}

fn page(title: &str, study: &Study, asked: f64) -> String {
    let mut page = format!("{title}\n\n{}\n\n", reference(study));
    let header = [
        "integrator",
        "steps per contact",
        "step [µs]",
        "steps",
        "run time",
        "worst error [%]",
        "of",
    ];
    let rows = study.trials.iter().map(|trial| {
        let worst = study
            .quantities
            .iter()
            .zip(&trial.errors)
            .max_by(|(_, a), (_, b)| a.bound().total_cmp(&b.bound()));
        [
            name(trial.integrator),
            number(trial.steps_per_contact),
            number(1.0e6 * trial.time_step),
            count(trial.steps),
            span(trial.wall_time),
            worst.map_or_else(String::new, |(_, error)| percent(error)),
            worst.map_or_else(String::new, |(key, _)| key.clone()),
        ]
    });
    let table = table::listing(header, &[1, 2, 3, 4, 5], rows);
    let _ = writeln!(page, "{table}\n");
    page + &recommendation(study, asked) + "\n"
}

fn reference(study: &Study) -> String {
    let against = match study.reference {
        Reference::FinestRun { time_step } => format!(
            "A nudge has grown {} times by the end: runs are compared one by one, with a run of {} µs.",
            number(study.growth),
            number(1.0e6 * time_step)
        ),
        Reference::MeanOfSeeds { time_step, runs } => format!(
            "A nudge has grown {} times by the end, which is chaotic: means over {runs} seeds are compared with those of \
             {runs} other seeds at {} µs; ± is the 95 % confidence interval.",
            number(study.growth),
            number(1.0e6 * time_step)
        ),
    };
    if study.exact.is_empty() {
        against
    } else {
        format!("{against}\nExact by the scene: {}.", study.exact.join(", "))
    }
}

fn recommendation(study: &Study, asked: f64) -> String {
    let asked_percent = number(100.0 * asked);
    if let Some(trial) = study.recommended(asked) {
        return format!(
            "Recommended for {asked_percent} %: {} steps per contact of {}, in the scene\n  [time]\n  step = {:.4e}\n  \
             integrator = \"{}\"",
            number(trial.steps_per_contact),
            name(trial.integrator),
            trial.time_step,
            name(trial.integrator)
        );
    }
    let best = study
        .trials
        .iter()
        .map(Trial::worst)
        .fold(f64::INFINITY, f64::min);
    let also = match study.reference {
        Reference::FinestRun { .. } => "",
        Reference::MeanOfSeeds { .. } => ", or for more repeats, which narrow the intervals",
    };
    format!(
        "No case keeps {asked_percent} %; the best keeps {} %. Ask for more steps per contact{also}.",
        number(100.0 * best)
    )
}

fn chart(title: &str, study: &Study) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    for trial in &study.trials {
        let label = name(trial.integrator);
        // A logarithmic axis has no place for an error of nothing.
        let point = [trial.worst().max(f64::EPSILON), trial.wall_time];
        match series.iter_mut().find(|series| series.label == label) {
            Some(series) => series.points.push(point),
            None => series.push(Series {
                label,
                points: vec![point],
                style: SeriesStyle::LineWithMarkers,
            }),
        }
    }
    Chart {
        title: title.to_owned(),
        x: Axis::logarithmic("worst relative error [-]"),
        y: Axis::logarithmic("run time [s]"),
        series,
    }
}

fn json_of(study: &Study, asked: f64) -> Value {
    let trial_json = |trial: &Trial| {
        let errors: serde_json::Map<String, Value> = study
            .quantities
            .iter()
            .zip(&trial.errors)
            .map(|(key, error)| {
                let value = json!({ "relative": error.value, "half_width": error.half_width });
                (key.clone(), value)
            })
            .collect();
        json!({
            "integrator": name(trial.integrator),
            "steps_per_contact": trial.steps_per_contact,
            "step_s": trial.time_step,
            "steps": trial.steps,
            "wall_s": trial.wall_time,
            "worst_error": trial.worst(),
            "errors": errors,
        })
    };
    let (kind, step) = match study.reference {
        Reference::FinestRun { time_step } => ("finest-run", time_step),
        Reference::MeanOfSeeds { time_step, .. } => ("mean-of-seeds", time_step),
    };
    json!({
        "reference": { "kind": kind, "step_s": step, "exact": study.exact },
        "nudge_growth": if study.growth.is_finite() { json!(study.growth) } else { Value::Null },
        "trials": study.trials.iter().map(trial_json).collect::<Vec<_>>(),
        "recommended": study.recommended(asked).map(trial_json),
    })
}
