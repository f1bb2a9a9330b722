//! Fills: how many pellets, and how they are put.

use super::{GOOD, draft};
use pelletflow_sim::{FillAmount, Seats};
use std::f64::consts::PI;

const COUNT: &str = "count = 10";
const SCREENED: &str = "diameter = { openings = [0.005, 0.01], passing = [0, 1] }";

fn seats(text: &str) -> Seats {
    match draft(text) {
        Ok(draft) => draft.resolved.setup.fills[0].seats.clone(),
        Err(mistakes) => panic!("{mistakes}"),
    }
}

#[test]
fn pellets_of_one_size_start_on_a_lattice_and_others_as_a_deposit_unless_told() {
    let wide = GOOD.replace("diameter = \"15 mm\"", SCREENED);
    let told = |packing: &str| format!("{COUNT}\npacking = \"{packing}\"");
    assert!(matches!(seats(GOOD), Seats::Lattice { .. }));
    assert!(matches!(seats(&wide), Seats::Deposit { .. }));
    let deposit = GOOD.replace(COUNT, &told("deposit"));
    assert!(matches!(seats(&deposit), Seats::Deposit { .. }));
    let lattice = wide.replace(COUNT, &told("lattice"));
    assert!(matches!(seats(&lattice), Seats::Lattice { .. }));
    let floating = format!("{wide}\n[scene]\ngravity = [0, 0, 0]\n");
    assert!(matches!(seats(&floating), Seats::Lattice { .. }));
}

#[test]
fn a_level_becomes_a_number_of_pellets_and_says_that_it_is_an_estimate() {
    let text = GOOD.replace(COUNT, "to_level = \"150 mm\"");
    let draft = draft(&text).expect("no mistake");
    let Seats::Deposit {
        amount: FillAmount::Count(count),
        ..
    } = draft.resolved.setup.fills[0].seats
    else {
        panic!("not a number of deposited pellets");
    };
    // A decimeter square, half a decimeter high, 0.6 of it balls of 15 mm.
    let expected = 0.6 * 0.1 * 0.1 * 0.05 / (PI / 6.0 * 0.015_f64.powi(3));
    assert!((count as f64 - expected).abs() <= 1.0, "{count}");
    let note = draft
        .resolved
        .notes
        .iter()
        .find(|note| note.starts_with("fill.bed.to_level: 170 pellets"));
    assert!(
        note.is_some_and(|note| note.contains("estimated")),
        "{:?}",
        draft.resolved.notes
    );
}

#[test]
fn a_level_is_a_height_against_gravity() {
    let text = GOOD.replace(COUNT, "to_level = \"-20 mm\"");
    let sideways = format!("{text}\n[scene]\ngravity = [5, 0, 0]\n");
    // Gravity pulls along x: what lies below the level is from x = 20 mm to 100 mm, 0.8 of the region.
    let Seats::Deposit {
        amount: FillAmount::Count(count),
        ..
    } = seats(&sideways)
    else {
        panic!("not a number of deposited pellets");
    };
    let expected = 0.6 * 0.8 * 0.1_f64.powi(3) / (PI / 6.0 * 0.015_f64.powi(3));
    // Of 64 points along x, 51 lie within 0.8 of the length.
    assert!((count as f64 / expected - 1.0).abs() < 0.01, "{count}");
}
