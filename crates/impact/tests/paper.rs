//! The claims of the paper, held against the solved hit: which hold, and by how much the others fail.

mod common;

use common::{is_near, papers_pellet};
use pelletflow_core::material::library::LibraryMaterial;
use pelletflow_impact::{Arrival, Damping, Impact, Slip};
use std::f64::consts::FRAC_PI_4;

fn solve(speed: f64, damping: Damping) -> Impact {
    Impact::new(&papers_pellet(speed), damping, None).expect("a hit that ends")
}

#[test]
fn its_peak_parameters_are_about_two_thirds_of_hertz_and_grow_with_nearly_the_power_of_hertz() {
    let printed = [(1.0, 5.2e4), (5.0, 5.1e5), (8.0, 9.7e5)];
    for (speed, peak_parameter) in printed {
        let share = peak_parameter / solve(speed, Damping::None).outline.peak_parameter;
        // Two digits are printed.
        assert!((0.63..0.66).contains(&share), "{speed}: {share}");
    }
    let power = (9.7e5_f64 / 5.2e4).ln() / 8.0_f64.ln();
    assert!((power - 1.4).abs() < 0.01, "{power}");
}

#[test]
fn its_specific_impulses_belong_to_damping_that_may_pull() {
    // By the integrals of the damped oscillator: 0.45 at e = 0.3738, 0.49 at 0.4874.
    for (restitution, specific_impulse) in [(0.373_76, 0.45), (0.487_44, 0.49)] {
        let impact = solve(1.0, Damping::RestitutionWithPull(restitution));
        assert!(is_near(
            impact.outline.specific_impulse,
            specific_impulse,
            1.0e-5
        ));
        let impact = solve(1.0, Damping::Restitution(restitution));
        assert!(impact.outline.specific_impulse > 0.5436);
    }
}

#[test]
fn its_asymmetry_that_grows_with_speed_is_viscoelastic() {
    for (speed, asymmetry) in [(0.1, 0.477), (1.0, 0.464), (8.0, 0.444)] {
        let impact = solve(speed, Damping::Viscoelastic(20.0e-6));
        // Three digits are told.
        assert!(
            (impact.outline.asymmetry - asymmetry).abs() < 6.0e-4,
            "{}",
            impact.outline.asymmetry
        );
    }
}

#[test]
fn force_and_time_follow_from_the_peak_parameter() {
    for damping in [
        Damping::None,
        Damping::Restitution(0.4),
        Damping::Viscoelastic(1.0e-5),
    ] {
        let impact = solve(3.0, damping);
        let force = (impact.outline.peak_parameter * impact.outline.impulse
            / impact.outline.specific_impulse)
            .sqrt();
        let time = (impact.outline.impulse
            / (impact.outline.specific_impulse * impact.outline.peak_parameter))
            .sqrt();
        // Identities, but for rounding.
        assert!(is_near(force, impact.outline.peak_force, 1.0e-12));
        assert!(is_near(time, impact.outline.contact_time, 1.0e-12));
    }
}

#[test]
fn its_matrix_of_small_turns_makes_bodies_grow() {
    // √(1 + (ω Δt)²) per step: e^1.8 after 1 s at 600 rad/s and 10 µs.
    let turn = 600.0 * 1.0e-5;
    let (mut x, mut y) = (1.0_f64, 0.0_f64);
    for _ in 0..100_000 {
        (x, y) = (x - turn * y, y + turn * x);
    }
    assert!(is_near(x.hypot(y), 1.8_f64.exp(), 1.0e-4));
}

#[test]
fn speeds_on_a_slope_are_nearly_logistic_by_its_law_and_less_so_by_partial_slip() {
    let named = |name| LibraryMaterial::named(name).expect("in the library");
    for (slip, least, greatest) in [(Slip::Coulomb, 0.02, 0.03), (Slip::Partial, 0.06, 0.08)] {
        let arrival = Arrival {
            pellet: named("papers-pellet").material,
            surface: named("steel").material,
            diameter: 0.015,
            speed: 4.0,
            angle: FRAC_PI_4,
            friction: 0.45,
            slip,
            damping: Damping::None,
        };
        let rebound = arrival.impact().expect("a hit").rebound.expect("oblique");
        for fit in [rebound.speed_fit, rebound.spin_fit] {
            let error = fit.expect("a change").rms_error;
            assert!((least..greatest).contains(&error), "{slip:?}: {error}");
        }
    }
}
