//! Where runs break: hard cases over a range of steps, which the default step must not break.
//!
//! `cargo xtask stress` runs the whole of it.

mod bits;
mod bodies;
mod case;
#[path = "../common/mod.rs"]
mod common;
mod long;
mod motions;
mod piles;
mod scenes;
mod sweep;

use case::Case;

/// Asserts that no case breaks at the default step, each run for a part of its time.
fn assert_whole(cases: &[Case]) {
    let broken: Vec<_> = cases
        .iter()
        .filter_map(|case| Some((case.name, case.run(case.quick, 1.0).broke?)))
        .collect();
    assert!(broken.is_empty(), "{broken:?}");
}

#[test]
fn stiff_soft_large_heavy_fast_slippery_and_rough_bodies_hold_at_the_default_step() {
    assert_whole(&bodies::CASES);
}

#[test]
fn piles_hold_at_the_default_step() {
    assert_whole(&piles::CASES);
}

#[test]
fn moved_and_squeezed_pellets_hold_at_the_default_step() {
    assert_whole(&motions::CASES);
}
