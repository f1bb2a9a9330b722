//! The domain: periodic axes and what stands against them.

use super::{GOOD, draft};

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
