//! `pelletflow card` makes cards of lab sheets that other commands read back.

mod common;

use common::{Call, call};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

const LOADS: &str = include_str!("../../../examples/sheets/loads.csv");
const DROPS: &str = include_str!("../../../examples/sheets/drops.csv");

/// A directory with the sample sheets.
fn sheets() -> TempDir {
    let directory = TempDir::new().expect("a directory");
    fs::write(directory.path().join("loads.csv"), LOADS).expect("writable");
    fs::write(directory.path().join("drops.csv"), DROPS).expect("writable");
    directory
}

fn good(directory: &Path, arguments: &[&str]) -> Call {
    let call = call(directory, arguments);
    assert_eq!(call.code, 0, "{arguments:?}: {}", call.error);
    call
}

fn json(directory: &Path, arguments: &[&str]) -> Value {
    serde_json::from_str(&good(directory, arguments).output).expect("JSON")
}

fn holds(interval: &Value, value: f64) -> bool {
    let end = |index: usize| interval[index].as_f64().expect("a number");
    (end(0)..=end(1)).contains(&value)
}

#[test]
fn the_intervals_of_the_sample_sheets_hold_what_the_sheets_were_made_of() {
    let directory = sheets();
    let arguments = [
        "card",
        "--crush",
        "loads.csv",
        "--drop",
        "drops.csv",
        "--json",
    ];
    let card = json(directory.path(), &arguments);
    assert_eq!(card["sample_size"], 60);
    assert_eq!(card["distribution"], "log-normal");
    // A mean of 2450 N and a scatter of 30 % have a median of 2450/√1.09 and a deviation of √ln 1.09.
    let fit = &card["fits"][0];
    assert!(
        holds(&fit["center_interval_n"], 2450.0 / 1.09_f64.sqrt()),
        "{fit}"
    );
    assert!(holds(&fit["shape_interval"], 1.09_f64.ln().sqrt()), "{fit}");
    let drops = &card["drops"]["fit"];
    assert!(holds(&drops["median_interval_j_per_kg"], 200.0), "{drops}");
    assert!(holds(&drops["deviation_interval"], 0.6), "{drops}");
}

#[test]
fn a_card_that_is_written_gives_safe_speed_the_load_that_was_shown() {
    let directory = sheets();
    for distribution in ["log-normal", "weibull"] {
        let file = format!("{distribution}.toml");
        let card = json(
            directory.path(),
            &[
                "card",
                "--crush",
                "loads.csv",
                "--drop",
                "drops.csv",
                "--tumble",
                "94.5%",
                "--abrasion",
                "4.5%",
                "--damage-constant",
                "5",
                "--distribution",
                distribution,
                "-o",
                &file,
                "--json",
            ],
        );
        let diameter = card["test_diameter_m"].to_string();
        let safe = json(
            directory.path(),
            &[
                "safe-speed",
                "--strength-card",
                &file,
                "--pellet",
                "fired-pellet",
                "--diameter",
                &diameter,
                "--json",
            ],
        );
        let shown = &card["loads"][1];
        assert_eq!(shown["risk"], 0.01);
        assert_eq!(safe["load_n"], shown["load_n"]);
        assert_eq!(safe["load_interval_n"], shown["load_interval_n"]);
    }
}

#[test]
fn the_force_of_a_drop_test_is_that_of_hertz_with_its_interval() {
    let directory = sheets();
    let arguments = [
        "card",
        "--crush",
        "loads.csv",
        "--drop",
        "drops.csv",
        "--pellet",
        "fired-pellet",
        "--json",
    ];
    let fit = &json(directory.path(), &arguments)["drops"]["fit"];
    let end = |key: &str, index: usize| fit[key][index].as_f64().expect("a number");
    let [force, energy] = [
        "median_elastic_force_interval_n",
        "median_interval_j_per_kg",
    ]
    .map(|key| end(key, 1) / end(key, 0));
    // P ∝ v^1.2, and the energy is v²/2.
    assert!(
        (force / energy.powf(0.6) - 1.0).abs() < 1.0e-12,
        "{force} {energy}"
    );
    let best = fit["median_elastic_force_n"].as_f64().expect("a number");
    assert!(holds(&fit["median_elastic_force_interval_n"], best));
}

#[test]
fn the_page_shows_fits_loads_drops_and_what_comes_next() {
    let directory = sheets();
    let call = good(
        directory.path(),
        &[
            "card",
            "--crush",
            "loads.csv",
            "--drop",
            "drops.csv",
            "--pellet",
            "fired-pellet",
            "--tumble",
            "94.5%",
            "--name",
            "works A",
            "-o",
            "card.toml",
            "--plot",
            "loads.svg",
        ],
    );
    for expected in [
        "works A: 60 pellets crushed, loads.csv, drops.csv; at 11.30 mm",
        "log-normal *",
        "29 of 60",
        "half break at",
        "by Hertz, elastic",
        "no breakage is worked out from it",
        "60 pellets show no risk below 1.667 %",
        "safe-speed --strength-card card.toml",
    ] {
        assert!(
            call.output.contains(expected),
            "{expected}: {}",
            call.output
        );
    }
    let svg = fs::read_to_string(directory.path().join("loads.svg")).expect("written");
    assert!(svg.contains("<polyline") && svg.contains("<circle"));
}

#[test]
fn few_pellets_are_worked_out_and_their_width_is_said() {
    let directory = TempDir::new().expect("a directory");
    fs::write(
        directory.path().join("few.csv"),
        "load [N]\n2100\n2900\n1800\n2500\n",
    )
    .expect("writable");
    let call = good(directory.path(), &["card", "--crush", "few.csv"]);
    assert!(
        call.output
            .contains("warning: 4 pellets are few: the load that breaks 1 % lies anywhere from")
    );
    assert!(call.output.contains("no card written; give -o FILE"));
}

#[test]
fn two_kinds_of_pellets_in_one_sheet_are_doubted() {
    let directory = TempDir::new().expect("a directory");
    let rows = (0..40).map(|index| {
        let kind = if index % 2 == 0 { 800.0 } else { 3000.0 };
        format!("{}\n", kind + f64::from(index))
    });
    let sheet = format!("load [N]\n{}", rows.collect::<String>());
    fs::write(directory.path().join("mixed.csv"), sheet).expect("writable");
    let call = good(directory.path(), &["card", "--crush", "mixed.csv"]);
    assert!(
        call.output
            .contains("look for two kinds of pellets in one sheet"),
        "{}",
        call.output
    );
}
