//! `pelletflow safe-speed`: the closed form, and whole runs of a scene beside it.

mod common;

use common::call;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// One pellet without weight, straight at a floor: the closed form's own case.
const SCENE: &str = r#"
schema_version = 1

[scene]
title = "One pellet, straight at a floor"
gravity = [0, 0, 0]

[materials.ore]
density = 3800
youngs_modulus = "1 GPa"
poisson_ratio = 0.25

[materials.steel]
density = 7850
youngs_modulus = "207 GPa"
poisson_ratio = 0.28

[pairs."ore-ore"]
restitution = 1
friction = 0

[pairs."ore-steel"]
restitution = 1
friction = 0

[pellets.pellet]
material = "ore"
diameter = "12 mm"

[walls.floor]
material = "steel"
shape = { kind = "half-space", point = [0, 0, 0], normal = [0, 0, 1] }

[fill.one]
pellets = "pellet"
at = [[0, 0, "15 mm"]]
velocity = [0, 0, "-1 m/s"]

[domain]
min = [-1, -1, -1]
max = [1, 1, 1]

[time]
end = "5 ms"
"#;

const CARD: &str = r#"
name = "works A"
source = "60 pellets"
distribution = "log-normal"
median = "2 kN"
deviation = 0.3
sample_size = 60
yield_pressure = "60 MPa"
"#;

fn directory() -> TempDir {
    let directory = TempDir::new().expect("a directory");
    fs::write(directory.path().join("beam.toml"), SCENE).expect("writable");
    fs::write(directory.path().join("card.toml"), CARD).expect("writable");
    directory
}

fn answer(directory: &Path, arguments: &[&str]) -> Value {
    let fixed = ["safe-speed", "--strength-card", "card.toml", "--json"];
    let call = call(directory, &[&fixed, arguments].concat());
    assert_eq!(call.code, 0, "{arguments:?}: {}", call.error);
    serde_json::from_str(&call.output).expect("JSON")
}

fn value(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn runs_of_a_lone_pellet_find_the_speed_of_the_closed_form_and_its_interval() {
    let directory = directory();
    let closed = answer(
        directory.path(),
        &[
            "--diameter",
            "12mm",
            "--density",
            "3800",
            "--youngs-modulus",
            "1GPa",
            "--poisson",
            "0.25",
        ],
    );
    let of_scene = ["--scene", "beam.toml", "--range", "4..24m/s"];
    let found = answer(directory.path(), &of_scene);
    // The step is chosen for 0.1 % of the force, which is 0.08 % of the speed; the library's steel is a little stiffer than
    // this one, and the secant of the last bracket adds 0.05 %.
    let near = |found: &Value, exact: &Value| (value(found) / value(exact) - 1.0).abs() < 2.0e-3;
    assert!(
        near(&found["value"], &closed["speed_m_per_s"]),
        "{} {}",
        found["value"],
        closed["speed_m_per_s"]
    );
    for side in [0, 1] {
        let exact = &closed["speed_interval_m_per_s"][side];
        assert!(near(&found["interval"][side], exact), "{side}: {found}");
    }
    let beside = &found["closed_form"];
    assert!((value(&beside["spread_factor"]) - 1.0).abs() < 1.0e-3);
    assert_eq!(value(&beside["slant_factor"]), 1.0);
    assert_eq!(found["is_monotone"], true);
    // Nothing is left to chance here, so that seeds tell nothing apart.
    assert_eq!(value(&found["seed_half_width"]), 0.0);
    // Pellets that yield break less at that speed, and may arrive faster.
    assert!(value(&found["breakage"]["broken_yielding"]["share"]) < 0.01);
    assert!(value(&closed["yielding_speed_m_per_s"]) > value(&closed["speed_m_per_s"]));
}

#[test]
fn a_floor_is_tilted_until_the_speed_across_it_is_that_of_the_closed_form() {
    let directory = directory();
    let level = ["--scene", "beam.toml", "--range", "4..24m/s"];
    let speed = value(&answer(directory.path(), &level)["value"]);
    let settings = [
        "--set",
        "walls.floor.shape.rotate={ axis = [1, 0, 0], angle = 0 }",
        "--set",
        "fill.one.velocity=[0, 0, \"-12 m/s\"]",
    ];
    let vary = [
        "--scene",
        "beam.toml",
        "--vary",
        "walls.floor.shape.rotate.angle",
        "--range",
        "5..50deg",
    ];
    let found = answer(directory.path(), &[&vary[..], &settings].concat());
    let tilt = (speed / 12.0).acos().to_degrees();
    // More tilt breaks less; the secant of the last bracket is off by less than a tenth of its 0.45°.
    assert!(
        (value(&found["value"]) - tilt).abs() < 0.1,
        "{tilt}: {found}"
    );
    assert_eq!(found["unit"], "deg");
    assert!(value(&found["interval"][0]) < tilt && tilt < value(&found["interval"][1]));
    let slant = value(&found["closed_form"]["slant_factor"]);
    assert!((slant * speed / 12.0 - 1.0).abs() < 2.0e-3, "{slant}");
}

#[test]
fn wrong_requests_are_refused_with_the_cure() {
    let directory = directory();
    for (arguments, code, expected) in [
        (
            vec!["--scene", "beam.toml", "--range", "4..6m/s"],
            2,
            "all of it is safe; widen the range",
        ),
        (
            vec!["--scene", "beam.toml", "--range", "20..30m/s"],
            2,
            "none of it is safe; widen the range",
        ),
        (
            vec!["--scene", "beam.toml", "--range", "4..24kg"],
            2,
            "`velocity` is a speed",
        ),
        (
            vec![
                "--scene",
                "beam.toml",
                "--range",
                "4..24",
                "--vary",
                "fill.two.count",
            ],
            2,
            "the scene is not valid at 4",
        ),
        (
            vec![
                "--scene",
                "beam.toml",
                "--range",
                "4..24",
                "--diameter",
                "12mm",
            ],
            2,
            "cannot be used with",
        ),
        (
            vec![
                "--scene",
                "beam.toml",
                "--range",
                "4..24",
                "--set",
                "time.end=1e-5",
            ],
            2,
            "no pellet is hit in the run at 4",
        ),
    ] {
        let fixed = ["safe-speed", "--strength-card", "card.toml"];
        let arguments = [&fixed[..], &arguments].concat();
        let call = call(directory.path(), &arguments);
        assert_eq!(call.code, code, "{arguments:?}: {}", call.error);
        assert!(
            call.error.contains(expected),
            "{arguments:?}: {}",
            call.error
        );
    }
}
