//! `impact` and `safe-speed` refuse what makes no sense, with the bound and the cure.

mod common;

use common::call;
use std::fs;
use tempfile::TempDir;

/// Arguments after those of the paper's pellet, and a part of the message.
const WRONG_IMPACTS: &[(&[&str], &str)] = &[
    (
        &["--speed", "8..1"],
        "the range runs backwards, from 8 to 1 m/s; write 1..8",
    ),
    (&["--speed", "0"], "expected more than 0"),
    (
        &["--speed", "5kg"],
        "`5kg` is a mass; expected a speed, for example 2 m/s",
    ),
    (
        &["--speed", "1", "--restitution", "0"],
        "expected more than 0 and at most 1",
    ),
    (
        &["--speed", "1", "--restitution", "1.2"],
        "expected more than 0 and at most 1",
    ),
    (&["--speed", "1", "--friction", "-1"], "expected 0 or more"),
    (&["--speed", "1", "--angle", "90deg"], "less than 90deg"),
    (
        &["--speed", "1", "--onto-poisson", "0.5"],
        "expected more than -1 and less than 0.5",
    ),
    (
        &["--speed", "1", "--plot", "a.svg", "--show", "spin"],
        "give --angle",
    ),
    (&[], "--speed"),
];

#[test]
fn impossible_hits_are_bad_input() {
    let directory = TempDir::new().expect("a directory");
    for (arguments, expected) in WRONG_IMPACTS {
        let call = call(
            directory.path(),
            &[&["impact", "--pellet", "papers-pellet"][..], arguments].concat(),
        );
        assert!(
            call.error.contains(expected),
            "{arguments:?}: {}",
            call.error
        );
        assert_eq!(call.code, 2, "{arguments:?}");
        assert_eq!(call.output, "", "{arguments:?}");
        assert!(!call.error.contains("panicked"), "{}", call.error);
    }
}

#[test]
fn materials_that_are_not_there_are_bad_input() {
    let directory = TempDir::new().expect("a directory");
    for (arguments, expected) in [
        (
            &["impact", "--pellet", "fired-pelet", "--speed", "1"][..],
            "unknown material `fired-pelet` of --pellet; did you mean `fired-pellet`?",
        ),
        (
            &[
                "impact",
                "--pellet",
                "fired-pellet",
                "--onto",
                "stel",
                "--speed",
                "1",
            ],
            "unknown material `stel` of --onto; did you mean `steel`?",
        ),
        (
            &[
                "impact",
                "--pellet",
                "fired-pellet",
                "--onto",
                "rubber",
                "--speed",
                "1",
                "--angle",
                "30deg",
            ],
            "the library knows no friction on rubber; give --friction",
        ),
        (
            &["impact", "--speed", "1"],
            "is missing; give it, or a pellet of the library",
        ),
        (
            &["impact", "--pellet", "steel", "--speed", "1"],
            "--diameter is missing",
        ),
    ] {
        let call = call(directory.path(), arguments);
        assert!(
            call.error.contains(expected),
            "{arguments:?}: {}",
            call.error
        );
        assert_eq!(call.code, 2, "{arguments:?}");
        assert_eq!(call.output, "", "{arguments:?}");
    }
}

#[test]
fn impossible_strengths_and_risks_are_bad_input() {
    let directory = TempDir::new().expect("a directory");
    fs::write(directory.path().join("card.toml"), "name = 1").expect("writable");
    for (arguments, expected) in [
        (&["--strength", "0"][..], "expected more than 0"),
        (
            &["--strength", "2kg"],
            "is a mass; expected a force, for example 2 kN",
        ),
        (
            &["--strength", "2kN", "--risk", "0"],
            "expected more than 0 and less than 1",
        ),
        (
            &["--strength", "2kN", "--risk", "100%"],
            "expected more than 0 and less than 1",
        ),
        (
            &["--strength", "2kN", "--risk", "-1%"],
            "expected more than 0 and less than 1",
        ),
        (
            &["--strength", "2kN", "--scatter", "0"],
            "coefficient of variation is 0; expected more than 0",
        ),
        (
            &["--strength", "2kN", "--shear-modulus-range", "2MPa..1MPa"],
            "runs backwards",
        ),
        (
            &["--strength", "2kN", "--shear-modulus-range", "1MPa..2MPa"],
            "widen the range",
        ),
        (
            &["--strength-card", "none.toml"],
            "none.toml: cannot be read",
        ),
        (&["--strength-card", "card.toml"], "card.toml:1: name:"),
        (&[], "--strength"),
    ] {
        let all = [&["safe-speed", "--pellet", "fired-pellet"][..], arguments].concat();
        let call = call(directory.path(), &all);
        assert!(
            call.error.contains(expected),
            "{arguments:?}: {}",
            call.error
        );
        assert_eq!(call.code, 2, "{arguments:?}: {}", call.error);
    }
}

#[test]
fn a_plot_that_cannot_be_written_is_a_failure_to_write() {
    let directory = TempDir::new().expect("a directory");
    let call = call(
        directory.path(),
        &["impact", "--figure", "9", "--plot", "missing/figure.svg"],
    );
    assert!(
        call.error.contains("missing/figure.svg cannot be written"),
        "{}",
        call.error
    );
    assert_eq!(call.code, 4);
}
