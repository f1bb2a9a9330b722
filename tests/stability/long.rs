//! What a million steps may do.

use crate::case::by_number;
use crate::common::{held, simulation};
use crate::{motions, piles};
use pelletflow::sim::StepRequest;

const MILLION: u64 = 1_000_000;

#[test]
#[ignore = "minutes; `cargo xtask stress` runs it"]
fn a_pyramid_creeps_by_less_than_a_thousandth_of_a_radius_in_a_million_steps() {
    let mut simulation = simulation(piles::pyramid());
    // It settles first.
    simulation
        .advance(MILLION / 50)
        .expect("a pyramid is no trouble");
    let settled = by_number(&simulation);
    simulation
        .advance(MILLION)
        .expect("a pyramid is no trouble");
    held(
        "stability",
        "way of the fastest of 30 pellets of a pyramid at rest in 10⁶ steps, in radii",
        piles::way(&settled, &by_number(&simulation)),
        1.0e-3,
        "statics",
    );
}

#[test]
#[ignore = "minutes; `cargo xtask stress` runs it"]
fn a_vibrated_bed_keeps_its_books_for_a_million_steps() {
    // At the default step the error of the contacts themselves shows; a short step leaves that of the bookkeeping.
    for (step, bound) in [(None, 1.0e-3), (Some(1.0e-6), 1.0e-6)] {
        let mut setup = motions::vibrated_bed();
        let told = if let Some(seconds) = step {
            setup.step = StepRequest::Fixed(seconds);
            format!("a step of {:.0} µs", 1.0e6 * seconds)
        } else {
            "the default step".into()
        };
        let mut simulation = simulation(setup);
        let mut shares = [0.0; 2];
        for share in &mut shares {
            simulation
                .advance(MILLION / 2)
                .expect("a shaken bed is no trouble");
            let energy = simulation.energy_ledger();
            *share = energy.residual / energy.wall_work;
        }
        let [halfway, end] = shares;
        held(
            "stability",
            &format!(
                "energy missed by a vibrated bed of 100 pellets in 10⁶ steps, over that put in, at {told}"
            ),
            end,
            bound,
            "energy is conserved",
        );
        // What is missed may grow with what is put in, and no faster; it scatters by a fifth.
        assert!(end.abs() < 1.2 * halfway.abs(), "{halfway:e} to {end:e}");
    }
}
