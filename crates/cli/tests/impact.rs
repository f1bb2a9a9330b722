//! `impact`, `safe-speed` and `materials` answer as their help says.

mod common;

use common::call;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The paper's pellet on steel, as an engineer writes it.
const PAPER: [&str; 10] = [
    "--diameter",
    "15mm",
    "--shear-modulus",
    "60MPa",
    "--poisson",
    "0.22",
    "--density",
    "3700",
    "--onto",
    "steel",
];

fn json(directory: &Path, arguments: &[&str]) -> Value {
    let call = call(directory, arguments);
    assert_eq!(call.code, 0, "{arguments:?}: {}", call.error);
    serde_json::from_str(&call.output).expect("JSON")
}

fn near(found: &Value, expected: f64, share: f64) -> bool {
    (found.as_f64().expect("a number") / expected - 1.0).abs() < share
}

#[test]
fn every_hit_has_the_quantities_of_hertz() {
    let directory = TempDir::new().expect("a directory");
    let arguments = [&["impact", "--json", "--speed", "1..8"][..], &PAPER].concat();
    let hits = json(directory.path(), &arguments);
    assert_eq!(hits.as_array().map(Vec::len), Some(8));
    let fastest = &hits[7];
    // Closed form, worked out by hand to seven digits.
    for (key, exact) in [
        ("speed_m_per_s", 8.0),
        ("peak_force_n", 538.074_2),
        ("contact_time_s", 0.357_653_8e-3),
        ("max_approach_m", 0.972_124_7e-3),
        ("contact_radius_m", 2.700_173e-3),
        ("peak_pressure_pa", 35.237_11e6),
        ("restitution", 1.0),
        ("impulse_n_s", 0.104_615_0),
        ("specific_impulse", 0.543_612),
        ("peak_parameter_n_per_s", 1.504_455e6),
        ("asymmetry", 0.5),
        ("shape_parameter", 3.789),
    ] {
        assert!(
            near(&fastest[key], exact, 1.0e-4),
            "{key}: {}",
            fastest[key]
        );
    }
    assert!(
        near(&fastest["fit_error"], 0.0083, 0.01),
        "{}",
        fastest["fit_error"]
    );
}

#[test]
fn restitution_and_friction_are_those_asked_for() {
    let directory = TempDir::new().expect("a directory");
    let hits = json(
        directory.path(),
        &[
            "impact",
            "--json",
            "--pellet",
            "papers-pellet",
            "--speed",
            "4m/s",
            "--angle",
            "70deg",
            "--restitution",
            "0.5",
            "--friction",
            "0.1",
            "--slip",
            "coulomb",
        ],
    );
    assert!(near(&hits[0]["restitution"], 0.5, 1.0e-6));
    // Slides throughout: v_t − μ (1 + e) v_n.
    let angle = 70.0_f64.to_radians();
    let exact = 4.0 * (angle.sin() - 0.1 * 1.5 * angle.cos());
    let tangential = &hits[0]["tangential"];
    assert!(
        near(&tangential["speed_m_per_s"], exact, 1.0e-6),
        "{tangential}"
    );
    assert!(
        tangential["speed_fit"]["fit_error"]
            .as_f64()
            .is_some_and(|error| error < 0.1)
    );
}

#[test]
fn every_figure_of_the_paper_is_one_command() {
    let directory = TempDir::new().expect("a directory");
    for figure in 2..=9 {
        let number = figure.to_string();
        let file = format!("figure-{figure}.svg");
        let call = call(
            directory.path(),
            &["impact", "--figure", &number, "--plot", &file],
        );
        assert_eq!(call.code, 0, "{figure}: {}", call.error);
        let svg = fs::read_to_string(directory.path().join(&file)).expect("written");
        assert!(svg.starts_with("<svg"), "{figure}");
        // The frame has none, a curve has one.
        assert!(svg.contains("<polyline"), "{figure}");
    }
}

#[test]
fn the_hit_over_time_goes_to_a_table_of_csv() {
    let directory = TempDir::new().expect("a directory");
    let call = call(
        directory.path(),
        &[
            "impact",
            "--pellet",
            "papers-pellet",
            "--speed",
            "1,2",
            "--csv",
            "hits.csv",
        ],
    );
    assert_eq!(call.code, 0, "{}", call.error);
    let csv = fs::read_to_string(directory.path().join("hits.csv")).expect("written");
    let mut lines = csv.lines();
    let columns = lines.next().expect("a header").split(',').count();
    assert_eq!(csv.lines().count(), 1 + 2 * 401);
    assert!(lines.all(|line| line.split(',').count() == columns));
}

#[test]
fn the_safe_speed_is_the_inverse_of_the_peak_force() {
    let directory = TempDir::new().expect("a directory");
    let arguments = [
        &["safe-speed", "--json", "--strength", "2.45kN"][..],
        &PAPER,
    ]
    .concat();
    let answer = json(directory.path(), &arguments);
    let speed = answer["speed_m_per_s"]
        .as_f64()
        .expect("a number")
        .to_string();
    let arguments = [&["impact", "--json", "--speed", &speed][..], &PAPER].concat();
    let hits = json(directory.path(), &arguments);
    assert!(near(&hits[0]["peak_force_n"], 2450.0, 1.0e-5));
    assert!(
        answer["warnings"][1]
            .as_str()
            .is_some_and(|warning| warning.contains("slow crushing is not an impact"))
    );
}

#[test]
fn a_strength_card_gives_speed_height_and_slope_with_intervals() {
    let directory = TempDir::new().expect("a directory");
    let card = "name = \"works A\"\nsource = \"60 pellets\"\ndistribution = \"weibull\"\nscale = \"2.7 kN\"\n\
                modulus = 4\ntest_diameter = \"12 mm\"\nsample_size = 60\n";
    fs::write(directory.path().join("card.toml"), card).expect("writable");
    let at = |risk: &str| {
        json(
            directory.path(),
            &[
                "safe-speed",
                "--strength-card",
                "card.toml",
                "--risk",
                risk,
                "--pellet",
                "fired-pellet",
                "--fall",
                "10m",
                "--json",
            ],
        )
    };
    let (careful, bold) = (at("0.1%"), at("5%"));
    assert!(near(
        &at("1%")["load_n"],
        2700.0 * (-(0.99_f64.ln())).powf(0.25),
        1.0e-9
    ));
    assert!(careful["speed_m_per_s"].as_f64() < bold["speed_m_per_s"].as_f64());
    assert!(careful["chute_slope_rad"].as_f64() > bold["chute_slope_rad"].as_f64());
    for key in [
        "load_interval_n",
        "speed_interval_m_per_s",
        "drop_height_interval_m",
    ] {
        assert!(careful[key][0].as_f64() < careful[key][1].as_f64(), "{key}");
    }
}

#[test]
fn materials_are_listed_with_their_sources() {
    let directory = TempDir::new().expect("a directory");
    let list = json(directory.path(), &["materials", "--json"]);
    let list = list.as_array().expect("a list");
    for name in [
        "steel",
        "rubber",
        "concrete",
        "fired-pellet",
        "green-pellet",
    ] {
        let entry = list.iter().find(|entry| entry["name"] == name).expect(name);
        assert!(
            entry["source"]
                .as_str()
                .is_some_and(|source| !source.is_empty())
        );
    }
    let page = call(directory.path(), &["materials"]);
    assert!(page.output.contains("Sources"));
}
