//! `pelletflow accuracy`.

mod common;

use common::{Call, call};
use serde_json::Value;
use tempfile::TempDir;

/// Studies the template `drop` with more arguments.
fn study(arguments: &[&str]) -> Call {
    let directory = TempDir::new().expect("a directory");
    let new = call(directory.path(), &["new", "drop"]);
    assert_eq!(new.code, 0, "{}", new.error);
    let arguments = [&["accuracy", "drop.toml"], arguments].concat();
    call(directory.path(), &arguments)
}

fn json(call: &Call) -> Value {
    assert_eq!(call.code, 0, "{}", call.error);
    serde_json::from_str(&call.output).expect("JSON")
}

#[test]
fn located_verlet_is_ahead_of_verlet_at_every_step_of_a_drop() {
    let study = json(&study(&["--steps-per-contact", "12.3,20,40", "--json"]));
    let error = |integrator: &str, steps: f64| {
        study["trials"]
            .as_array()
            .expect("a list")
            .iter()
            .find(|trial| trial["integrator"] == integrator && trial["steps_per_contact"] == steps)
            .and_then(|trial| trial["worst_error"].as_f64())
            .expect("every case ran")
    };
    for steps in [12.3, 20.0, 40.0] {
        let located = error("located-verlet", steps);
        let verlet = error("velocity-verlet", steps);
        assert!(located < 0.2 * verlet, "{steps}: {located} and {verlet}");
    }
    assert_eq!(study["reference"]["kind"], "finest-run");
    assert_eq!(study["recommended"]["integrator"], "located-verlet");
}

#[test]
fn an_exact_value_of_the_scene_is_what_the_error_is_held_against() {
    let doubled =
        "expect.\"contacts.max_force_n\"={ value = 529.6, relative = \"0.1 %\", exact = true }";
    let study = json(&study(&[
        "--steps-per-contact",
        "20",
        "--integrator",
        "located-verlet",
        "--json",
        "--set",
        doubled,
    ]));
    let error = &study["trials"][0]["errors"]["contacts.max_force_n"]["relative"];
    // Half of what a value twice as great would be.
    assert!((error.as_f64().expect("a number") - 0.5).abs() < 1.0e-3);
    assert_eq!(study["reference"]["exact"][0], "contacts.max_force_n");
}

#[test]
fn what_cannot_be_compared_is_refused_with_the_cure() {
    let unknown = "expect.\"bodies.inside\"={ value = 1, exact = true }";
    let cases: [(&[&str], &str); 2] = [
        (&["--set", "time.end=\"0.1 s\""], "let the scene run longer"),
        (&["--set", unknown], "expected one of contacts.max_force_n"),
    ];
    for (arguments, message) in cases {
        let call = study(arguments);
        assert_eq!(call.code, 2, "{arguments:?}: {}", call.error);
        assert!(
            call.error.contains(message),
            "{arguments:?}: {}",
            call.error
        );
        assert!(call.output.is_empty());
    }
}

#[test]
fn a_flow_in_which_a_nudge_grows_is_compared_by_the_means_of_seeds() {
    let directory = TempDir::new().expect("a directory");
    let new = call(directory.path(), &["new", "hopper"]);
    assert_eq!(new.code, 0, "{}", new.error);
    let study = json(&call(
        directory.path(),
        &[
            "accuracy",
            "hopper.toml",
            "--set",
            "time.end=\"0.3 s\"",
            "--set",
            "fill.bed.count=200",
            "--steps-per-contact",
            "10,20",
            "--integrator",
            "located-verlet",
            "--repeats",
            "3",
            "--json",
        ],
    ));
    assert_eq!(study["reference"]["kind"], "mean-of-seeds");
    let error = &study["trials"][0]["errors"]["energy.dissipated_j"];
    assert!(error["half_width"].as_f64().expect("a number") > 0.0);
}
