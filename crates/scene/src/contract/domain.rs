//! The domain: periodic axes and what stands against them.

use super::{GOOD, draft};
use crate::Scene;

/// The good scene with a domain of its own.
fn within(domain: &str) -> String {
    format!("{GOOD}\n[domain]\n{domain}\n")
}

#[test]
fn periodic_axes_are_read_by_name() {
    let text = within("min = [-1, -1, -2]\nmax = [1, 1, 2]\nperiodic = [\"y\", \"x\"]");
    let draft = draft(&text).expect("no mistake");
    let domain = draft.resolved.setup.domain;
    assert_eq!(domain.is_periodic, [true, true, false]);
}

#[test]
fn periodic_axes_that_cannot_be_are_refused() {
    for (domain, expected) in [
        ("periodic = [\"x\"]", "domain.min: `min` is missing"),
        (
            "min = [-1, -1, -2]\nmax = [1, 1, 1]\nperiodic = [\"w\"]",
            "domain.periodic[0]: unknown periodic `w`; expected `x`, `y` or `z`",
        ),
        (
            "min = [-0.01, -1, -2]\nmax = [0.01, 1, 1]\nperiodic = [\"x\"]",
            "domain.periodic: the domain is 0.0200 m long along its periodic axis x; expected at least 0.0330 m",
        ),
        (
            "min = [-1, -1, -2]\nmax = [1, 1, 1]\nperiodic = [\"z\"]",
            "walls.floor.shape: the wall is not the same on both borders of the periodic axis z",
        ),
    ] {
        let error = Scene::parse(&within(domain), "scene.toml", &[]).expect_err(domain);
        assert!(error.to_string().contains(expected), "{domain}: {error}");
    }
}
