//! `pelletflow impact`.

mod cases;
mod chart;
mod curves;

use crate::args::impact::ImpactArguments;
use crate::commands::hit::bad_input;
use crate::exit::{Exit, Failure};
use crate::file;
use crate::screen;
use crate::table::{self, number};
use cases::{Case, Cases};
use pelletflow_impact::{Impact, LogisticFit};
use serde_json::{Value, json};
use std::fmt::Write;

/// A hit that was asked for, and what it comes to.
struct Followed {
    case: Case,
    impact: Impact,
}

/// Follows one hit per speed from first touch to release.
pub(crate) fn impact(arguments: &ImpactArguments) -> Result<Exit, Failure> {
    if arguments.figure == Some(9) {
        if let Some(path) = &arguments.plot {
            file::draw(path, &curves::chart())?;
        }
        return show(arguments, curves::json, curves::page);
    }
    let Cases { title, view, all } = Cases::new(arguments)?;
    let hits = all
        .into_iter()
        .map(|case| match case.arrival.impact() {
            Ok(impact) => Ok(Followed { case, impact }),
            Err(error) => Err(bad_input(format!("{}: {error}", case.label))),
        })
        .collect::<Result<Vec<_>, Failure>>()?;
    if let Some(path) = &arguments.plot {
        file::draw(path, &chart::chart(&title, view, &hits))?;
    }
    if let Some(path) = &arguments.csv {
        file::write(path, &csv(&hits))?;
    }
    show(
        arguments,
        || hits.iter().map(json_of).collect(),
        || page(&title, &hits),
    )
}

fn show(
    arguments: &ImpactArguments,
    json: impl FnOnce() -> Value,
    page: impl FnOnce() -> String,
) -> Result<Exit, Failure> {
    if arguments.json {
        screen::json(&json())?;
    } else {
        screen::result(&page())?;
        for path in [&arguments.plot, &arguments.csv].into_iter().flatten() {
            screen::remark(&format!("{} written", path.display()));
        }
    }
    Ok(Exit::Done)
}

fn page(title: &str, hits: &[Followed]) -> String {
    let kinematics = [
        "hit",
        "peak force [N]",
        "contact time [ms]",
        "approach [mm]",
        "contact radius [mm]",
        "peak pressure [MPa]",
        "restitution [-]",
        "impulse [N s]",
    ];
    let of_motion = hits.iter().map(|Followed { case, impact }| {
        [
            case.label.clone(),
            number(impact.outline.peak_force),
            number(impact.outline.contact_time * 1.0e3),
            number(impact.outline.max_approach * 1.0e3),
            number(impact.outline.contact_radius * 1.0e3),
            number(impact.outline.peak_pressure * 1.0e-6),
            number(impact.outline.restitution),
            number(impact.outline.impulse),
        ]
    });
    let shape = [
        "hit",
        "k_P [-]",
        "χ_P [N/s]",
        "τ_max [-]",
        "bell ε [-]",
        "bell τ [-]",
        "bell error [%]",
        "sine n [-]",
        "sine error [%]",
    ];
    let of_shape = hits.iter().map(|Followed { case, impact }| {
        [
            case.label.clone(),
            number(impact.outline.specific_impulse),
            format!("{:.3e}", impact.outline.peak_parameter),
            number(impact.outline.asymmetry),
            number(impact.bell.shape_parameter),
            number(impact.bell.asymmetry),
            number(impact.bell.rms_error * 100.0),
            number(impact.sine.exponent),
            number(impact.sine.rms_error * 100.0),
        ]
    });
    let mut page = vec![
        title.to_owned(),
        table::listing(kinematics, &[1, 2, 3, 4, 5, 6, 7], of_motion),
        table::listing(shape, &[1, 2, 3, 4, 5, 6, 7, 8], of_shape),
    ];
    page.extend(sliding(hits));
    page.join("\n\n")
}

/// What becomes of sliding and spin, where a hit is oblique.
fn sliding(hits: &[Followed]) -> Option<String> {
    let steepness = |fit: Option<LogisticFit>| {
        fit.map_or_else(String::new, |fit| {
            format!(
                "κ {} τ₀ {} ({:.1} %)",
                number(fit.steepness),
                number(fit.middle),
                fit.rms_error * 100.0
            )
        })
    };
    let rows: Vec<[String; 6]> = hits
        .iter()
        .filter_map(|Followed { case, impact }| {
            let rebound = impact.rebound.as_ref()?;
            Some([
                case.label.clone(),
                number(rebound.tangential_speed),
                rebound
                    .tangential_restitution
                    .map_or_else(String::new, number),
                number(rebound.spin),
                steepness(rebound.speed_fit),
                steepness(rebound.spin_fit),
            ])
        })
        .collect();
    let header = [
        "hit",
        "speed along the surface [m/s]",
        "over before [-]",
        "spin [rad/s]",
        "logistic fit of the speed",
        "of the spin",
    ];
    (!rows.is_empty()).then(|| table::listing(header, &[1, 2, 3], rows))
}

fn json_of(Followed { case, impact }: &Followed) -> Value {
    let arrival = &case.arrival;
    let mut object = json!({
        "label": case.label,
        "speed_m_per_s": arrival.speed,
        "angle_rad": arrival.angle,
        "normal_speed_m_per_s": impact.speed,
        "diameter_m": arrival.diameter,
        "peak_force_n": impact.outline.peak_force,
        "contact_time_s": impact.outline.contact_time,
        "max_approach_m": impact.outline.max_approach,
        "contact_radius_m": impact.outline.contact_radius,
        "peak_pressure_pa": impact.outline.peak_pressure,
        "restitution": impact.outline.restitution,
        "impulse_n_s": impact.outline.impulse,
        "specific_impulse": impact.outline.specific_impulse,
        "peak_parameter_n_per_s": impact.outline.peak_parameter,
        "asymmetry": impact.outline.asymmetry,
        "shape_parameter": impact.bell.shape_parameter,
        "fitted_asymmetry": impact.bell.asymmetry,
        "fit_error": impact.bell.rms_error,
        "worst_fit_error": impact.bell.worst_error,
        "sine_exponent": impact.sine.exponent,
        "sine_fit_error": impact.sine.rms_error,
    });
    if let Some(rebound) = &impact.rebound {
        object["tangential"] = json!({
            "friction": arrival.friction,
            "speed_m_per_s": rebound.tangential_speed,
            "restitution": rebound.tangential_restitution,
            "sliding_speed_m_per_s": rebound.sliding_speed,
            "spin_rad_per_s": rebound.spin,
            "speed_fit": rebound.speed_fit.map(|fit| json!({
                "start_m_per_s": fit.start, "change_m_per_s": fit.change, "steepness": fit.steepness,
                "middle": fit.middle, "fit_error": fit.rms_error,
            })),
            "spin_fit": rebound.spin_fit.map(|fit| json!({
                "start_rad_per_s": fit.start, "change_rad_per_s": fit.change, "steepness": fit.steepness,
                "middle": fit.middle, "fit_error": fit.rms_error,
            })),
        });
    }
    object
}

/// Every hit over time; the columns of sliding stay empty where there is none.
fn csv(hits: &[Followed]) -> String {
    let mut text = String::from(
        "hit,speed_m_per_s,time_s,force_n,overlap_m,approach_speed_m_per_s,tangential_force_n,\
         tangential_speed_m_per_s,horizontal_speed_m_per_s,spin_rad_per_s\n",
    );
    for Followed { case, impact } in hits {
        let oblique = |index| {
            impact
                .rebound
                .as_ref()
                .map(|rebound| &rebound.samples[index])
        };
        for (index, sample) in impact.samples.iter().enumerate() {
            let sliding = oblique(index).map_or_else(
                || ",,,".into(),
                |oblique| {
                    format!(
                        "{},{},{},{}",
                        oblique.tangential_force,
                        oblique.tangential_speed,
                        case.arrival.horizontal_speed(sample, oblique),
                        oblique.spin
                    )
                },
            );
            writeln!(
                text,
                "\"{}\",{},{},{},{},{},{sliding}",
                case.label,
                case.arrival.speed,
                sample.time,
                sample.force,
                sample.overlap,
                sample.approach_speed,
            )
            .expect("a string takes any text");
        }
    }
    text
}
