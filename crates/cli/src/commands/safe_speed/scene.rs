//! `pelletflow safe-speed --scene`.

use super::Asked;
use crate::args::safe_speed::SafeSpeedArguments;
use crate::commands::hit::bad_input;
use crate::exit::{Exit, Failure};
use crate::screen;
use crate::table::{self, chosen, count, number, percent};
use indicatif::{ProgressBar, ProgressStyle};
use pelletflow_impact::StrengthLaw;
use pelletflow_log::safe_setting::Comparison;
use pelletflow_log::{
    BreakageRequest, SafeSetting, SafeSettingError, SafeSettingRequest, safe_setting,
};
use pelletflow_scene::{Scene, Setting};
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::path::Path;

/// Ticks of the bar for each run.
const TICKS: f64 = 100.0;

/// Seeks the value of a setting of a scene at which the share asked for breaks.
pub(super) fn safe_setting_of(
    path: &Path,
    arguments: &SafeSpeedArguments,
    asked: &Asked,
) -> Result<Exit, Failure> {
    let of_scene = &arguments.of_scene;
    let scene = Scene::read(path, &of_scene.set)?;
    let range = of_scene
        .range
        .as_ref()
        .ok_or_else(|| bad_input("--scene needs --range, such as --range 1..12m/s".into()))?;
    let setting = Setting::of_scene(&scene, of_scene.vary.as_deref(), &range.unit)
        .map_err(|error| bad_input(format!("{error}; --vary names it")))?;
    let range = [range.least, range.greatest];
    let request = SafeSettingRequest {
        breakage: BreakageRequest {
            law: StrengthLaw::Load(asked.strength),
            yield_pressure: asked.yield_pressure,
            places: 3,
        },
        risk: arguments.risk,
        range,
        tolerance: of_scene.tolerance,
        seeds: of_scene.seeds,
        threads: of_scene.threads.unwrap_or(0),
    };
    let bar = bar();
    let found = safe_setting(
        &request,
        &mut |value| {
            let mut overrides = of_scene.set.clone();
            overrides.push(setting.set(value).map_err(|error| error.to_string())?);
            let scene = Scene::read(path, &overrides).map_err(|error| error.to_string())?;
            Ok((scene.setup, scene.plan))
        },
        &mut |done, part| {
            bar.set_message(format!("run {}", done + 1));
            bar.set_position((TICKS * part) as u64);
            ControlFlow::Continue(())
        },
    );
    bar.finish_and_clear();
    let answer = Answer {
        found: found.map_err(|error| refused(&error))?,
        title: scene.title,
        setting,
        range,
        risk: arguments.risk,
        told: &asked.told,
    };
    if arguments.json {
        screen::json(&answer.json())?;
    } else {
        screen::result(&answer.page())?;
    }
    Ok(Exit::Done)
}

fn bar() -> ProgressBar {
    if !screen::is_watched() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(TICKS as u64);
    if let Ok(style) = ProgressStyle::with_template("{msg} {bar:40} {percent} % [{elapsed}]") {
        bar.set_style(style);
    }
    bar
}

fn refused(error: &SafeSettingError) -> Failure {
    match error {
        SafeSettingError::Run { .. } => Failure::new(Exit::Failed, error.to_string()),
        SafeSettingError::Interrupted => Failure::new(Exit::Interrupted, error.to_string()),
        _ => bad_input(error.to_string()),
    }
}

struct Answer<'a> {
    found: SafeSetting,
    title: String,
    setting: Setting,
    /// Values between which it was sought [the setting's unit].
    range: [f64; 2],
    risk: f64,
    told: &'a str,
}

impl Answer<'_> {
    fn with_unit(&self, value: f64) -> String {
        format!("{} {}", number(value), self.setting.unit)
            .trim_end()
            .to_owned()
    }

    /// A bound of the interval; one that lies outside the range is that end of it.
    fn bound(&self, side: usize) -> String {
        let words = ["less than", "more than"][side];
        self.found.interval[side].map_or_else(
            || format!("{words} {}", self.with_unit(self.range[side])),
            |value| self.with_unit(value),
        )
    }

    fn page(&self) -> String {
        let found = &self.found;
        let mut rows = vec![[
            format!("{} % break at", chosen(100.0 * self.risk)),
            self.with_unit(found.value),
            format!("{} to {}", self.bound(0), self.bound(1)),
        ]];
        if let Some(half_width) = found.seed_half_width {
            let count = found.seed_shares.len();
            rows.push([
                format!("from run to run, {count} seeds"),
                String::new(),
                format!("± {}", self.with_unit(half_width)),
            ]);
        }
        if let Some(yielding) = &found.breakage.broken_yielding {
            rows.push([
                "there, of pellets that yield first".into(),
                percent(yielding.share),
                String::new(),
            ]);
        }
        let mut sections = vec![
            format!(
                "{}\n{}\nsought: {}, {} to {}, in {} runs",
                self.title,
                self.told,
                self.setting.name(),
                self.with_unit(self.range[0]),
                self.with_unit(self.range[1]),
                found.runs.len() + found.seed_shares.len(),
            ),
            table::listing(["", "best", "interval"], &[1, 2], rows),
        ];
        if let Some(comparison) = &found.comparison {
            sections.push(beside(comparison, self.risk));
        }
        let runs = found.runs.iter().map(|run| {
            let share = run.breakage.believed();
            let [low, high] = share.interval;
            [
                self.with_unit(run.value),
                percent(share.share),
                format!("{} to {}", percent(low), percent(high)),
                count(run.breakage.hits),
            ]
        });
        let header = [self.setting.key.as_str(), "broken", "interval", "hits"];
        sections.push(table::listing(header, &[0, 1, 2, 3], runs));
        let warnings = self.warnings();
        let warnings = warnings.iter().map(|warning| format!("warning: {warning}"));
        sections.push(warnings.collect::<Vec<_>>().join("\n"));
        sections.join("\n\n")
    }

    fn warnings(&self) -> Vec<String> {
        let mut warnings = self.found.breakage.warnings.clone();
        if !self.found.is_monotone {
            warnings.insert(
                0,
                "the share broken does not only grow, or only fall, with the setting: the value told is the first one; look at the runs"
                    .into(),
            );
        }
        warnings
    }

    fn json(&self) -> Value {
        let found = &self.found;
        let runs = found.runs.iter().map(|run| {
            let share = run.breakage.believed();
            json!({ "value": run.value, "share": share.share, "interval": share.interval, "hits": run.breakage.hits })
        });
        json!({
            "strength": self.told,
            "risk": self.risk,
            "key": self.setting.key,
            "unit": self.setting.unit,
            "value": found.value,
            "interval": found.interval,
            "seed_half_width": found.seed_half_width,
            "seed_shares": found.seed_shares,
            "is_monotone": found.is_monotone,
            "runs": runs.collect::<Vec<_>>(),
            "breakage": found.breakage,
            "closed_form": found.comparison.as_ref().map(|comparison| json!({
                "partner": comparison.closed_form.partner,
                "speed_m_per_s": comparison.closed_form.speed.best,
                "speed_interval_m_per_s": [comparison.closed_form.speed.low, comparison.closed_form.speed.high],
                "damping_factor": comparison.damping_factor(),
                "slant_factor": comparison.slant_factor(),
                "spread_factor": comparison.spread_factor(),
                "part": comparison.part,
                "arrival_speed_m_per_s": comparison.breaking.speed_m_per_s,
                "normal_speed_m_per_s": comparison.breaking.normal_speed_m_per_s,
            })),
            "warnings": self.warnings(),
        })
    }
}

/// The closed form beside the run, and what makes the difference.
fn beside(comparison: &Comparison, risk: f64) -> String {
    let closed = &comparison.closed_form;
    let speed = closed.speed;
    let rows = [
        [
            format!(
                "closed form: {} % of lone pellets break, square and elastic, on {}",
                chosen(100.0 * risk),
                closed.partner
            ),
            format!("{} m/s", number(speed.best)),
            format!("{} to {} m/s", number(speed.low), number(speed.high)),
        ],
        [
            "damping: a damped hit has less force".into(),
            format!("× {}", number(comparison.damping_factor())),
            String::new(),
        ],
        [
            format!(
                "slant: of those that break, {} m/s go across the surface",
                number(comparison.breaking.normal_speed_m_per_s)
            ),
            format!("× {}", number(comparison.slant_factor())),
            String::new(),
        ],
        [
            "the rest: speeds and sizes differ, and not every pellet breaks here".into(),
            format!("× {}", number(comparison.spread_factor())),
            String::new(),
        ],
        [
            format!(
                "mean arrival speed of those that break, {} of all",
                percent(comparison.part)
            ),
            format!("{} m/s", number(comparison.breaking.speed_m_per_s)),
            String::new(),
        ],
    ];
    table::listing(["arrival", "", "interval"], &[1, 2], rows)
}
