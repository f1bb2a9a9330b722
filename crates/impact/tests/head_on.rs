//! The solved hit along the normal is the closed form wherever there is one.

mod common;

use common::{is_near, papers_pellet};
use pelletflow_core::contact::normal;
use pelletflow_impact::damping::approach_share;
use pelletflow_impact::elastic::SPECIFIC_IMPULSE;
use pelletflow_impact::{Damping, ElasticImpact, Impact};

/// What the solver leaves over of a hit, with 10 times its own error of 1e-7 for grace; 1e-4 is asked for.
const SOLVED: f64 = 1.0e-6;

fn solve(hit: &ElasticImpact, damping: Damping) -> Impact {
    Impact::new(hit, damping, None).expect("a hit that ends")
}

#[test]
fn every_quantity_of_an_elastic_hit_is_hertz() {
    for speed in [0.01, 1.0, 5.0, 8.0, 50.0] {
        let hit = papers_pellet(speed);
        let impact = solve(&hit, Damping::None);
        for (name, found, exact) in [
            ("peak force", impact.outline.peak_force, hit.peak_force()),
            (
                "contact time",
                impact.outline.contact_time,
                hit.contact_time(),
            ),
            (
                "greatest approach",
                impact.outline.max_approach,
                hit.greatest_approach(),
            ),
            (
                "contact radius",
                impact.outline.contact_radius,
                hit.contact_radius(),
            ),
            (
                "peak pressure",
                impact.outline.peak_pressure,
                hit.peak_pressure(),
            ),
            ("restitution", impact.outline.restitution, 1.0),
            ("impulse", impact.outline.impulse, hit.impulse()),
            (
                "specific impulse",
                impact.outline.specific_impulse,
                SPECIFIC_IMPULSE,
            ),
            (
                "peak parameter",
                impact.outline.peak_parameter,
                hit.peak_parameter(),
            ),
            ("asymmetry", impact.outline.asymmetry, 0.5),
        ] {
            assert!(
                is_near(found, exact, SOLVED),
                "{name} at {speed}: {found} {exact}"
            );
        }
    }
}

#[test]
fn the_curves_fitted_to_an_elastic_hit_have_the_tabulated_parameters_and_errors() {
    // Independent least-squares fit to evenly spaced times; four digits of the parameter, two of the errors.
    let impact = solve(&papers_pellet(5.0), Damping::None);
    let bell = impact.bell;
    assert!((bell.shape_parameter - 3.789).abs() < 2.0e-3, "{bell:?}");
    assert!((bell.asymmetry - 0.5).abs() < 1.0e-5, "{bell:?}");
    assert!((bell.rms_error - 0.0083).abs() < 1.0e-4, "{bell:?}");
    assert!((bell.worst_error - 0.015).abs() < 5.0e-4, "{bell:?}");
    let sine = impact.sine;
    assert!((sine.exponent - 1.599).abs() < 1.0e-3, "{sine:?}");
    assert!((sine.rms_error - 0.0032).abs() < 1.0e-4, "{sine:?}");
}

#[test]
fn damping_that_may_pull_gives_the_restitution_asked_for_and_the_exact_shape() {
    // Antypov & Elliott 2011: δ^(5/4) is a damped harmonic oscillator in the time ∫ δ^(1/4) dt, so each of these is an
    // integral, worked out to 30 digits: e, τ_max, k_P, t/t_el, P/P_el.
    let table = [
        (0.9, 0.472_822_81, 0.542_359_67, 1.011_068_18, 0.941_770_13),
        (0.7, 0.408_660_67, 0.529_534_78, 1.041_892_02, 0.837_511_66),
        (0.5, 0.326_430_10, 0.493_437_97, 1.093_368_60, 0.755_703_16),
        (0.3, 0.217_497_15, 0.413_432_75, 1.194_865_80, 0.715_283_96),
    ];
    for (restitution, asymmetry, specific_impulse, time, force) in table {
        for speed in [0.5, 8.0] {
            let hit = papers_pellet(speed);
            let impact = solve(&hit, Damping::RestitutionWithPull(restitution));
            assert!(is_near(impact.outline.restitution, restitution, SOLVED));
            for (found, tabulated) in [
                (impact.outline.asymmetry, asymmetry),
                (impact.outline.specific_impulse, specific_impulse),
                (impact.outline.contact_time / hit.contact_time(), time),
                (impact.outline.peak_force / hit.peak_force(), force),
            ] {
                assert!(
                    is_near(found, tabulated, SOLVED),
                    "{restitution}: {found} {tabulated}"
                );
            }
        }
    }
}

#[test]
fn clamped_damping_gives_the_restitution_asked_for_at_any_speed() {
    for restitution in [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999, 1.0] {
        for speed in [0.1, 10.0] {
            let impact = solve(&papers_pellet(speed), Damping::Restitution(restitution));
            assert!(
                is_near(impact.outline.restitution, restitution, SOLVED),
                "{restitution}: {}",
                impact.outline.restitution
            );
        }
    }
}

#[test]
fn very_heavy_damping_makes_the_peak_force_its_own() {
    let share = |restitution| {
        let hit = papers_pellet(5.0);
        solve(&hit, Damping::Restitution(restitution))
            .outline
            .peak_force
            / hit.peak_force()
    };
    assert!(share(0.5) < 0.75);
    // The damper's force at first touch, at e = 0.1, as the documentation warns.
    assert!((share(0.1) - 1.24).abs() < 0.01, "{}", share(0.1));
}

#[test]
fn the_greatest_approach_of_a_damped_hit_is_its_closed_form() {
    for ratio in [0.034_265, 0.255_276, 0.9, 1.0, 1.5] {
        let hit = papers_pellet(3.0);
        let restitution = normal::clamped_restitution(ratio);
        let impact = solve(&hit, Damping::Restitution(restitution));
        let exact = approach_share(ratio) * hit.greatest_approach();
        assert!(
            is_near(impact.outline.max_approach, exact, SOLVED),
            "{ratio}: {} {exact}",
            impact.outline.max_approach
        );
    }
}

#[test]
fn viscoelastic_restitution_is_the_tabulated_one() {
    // Independent solution to 1e-11, six digits; the relaxation time is in units of L/v.
    let table = [
        (0.001, 0.998_272),
        (0.01, 0.982_883),
        (0.1, 0.845_144),
        (0.5, 0.478_838),
    ];
    for (relaxation, restitution) in table {
        let hit = papers_pellet(2.0);
        let time = relaxation * hit.length() / hit.speed;
        let impact = solve(&hit, Damping::Viscoelastic(time));
        assert!(
            (impact.outline.restitution - restitution).abs() < 1.5e-6,
            "{relaxation}: {}",
            impact.outline.restitution
        );
    }
}

#[test]
fn viscoelastic_hits_lose_more_the_faster_they_are_and_damped_ones_do_not() {
    let at = |speed, damping| solve(&papers_pellet(speed), damping);
    let slow = at(0.4, Damping::Viscoelastic(2.0e-5));
    let fast = at(4.0, Damping::Viscoelastic(2.0e-5));
    assert!(fast.outline.restitution < slow.outline.restitution - 0.01);
    assert!(fast.outline.asymmetry < slow.outline.asymmetry - 0.005);
    let slow = at(0.4, Damping::Restitution(0.5));
    let fast = at(4.0, Damping::Restitution(0.5));
    assert!(is_near(
        fast.outline.asymmetry,
        slow.outline.asymmetry,
        1.0e-9
    ));
}

#[test]
fn the_area_under_the_sampled_force_is_the_impulse() {
    for damping in [
        Damping::None,
        Damping::Restitution(0.4),
        Damping::Viscoelastic(3.0e-5),
    ] {
        let impact = solve(&papers_pellet(5.0), damping);
        let area: f64 = impact
            .samples
            .windows(2)
            .map(|pair| 0.5 * (pair[0].force + pair[1].force) * (pair[1].time - pair[0].time))
            .sum();
        // The trapezium rule on 400 intervals of a curve that starts like the fourth root of time.
        assert!(
            is_near(area, impact.outline.impulse, 5.0e-4),
            "{damping:?}: {area} {}",
            impact.outline.impulse
        );
        assert!(
            impact
                .samples
                .iter()
                .all(|sample| sample.force > -1.0e-6 * impact.outline.peak_force)
        );
        assert_eq!(impact.samples.len(), 401);
    }
}

#[test]
fn impossible_hits_are_refused_by_name() {
    let good = papers_pellet(1.0);
    let at_rest = ElasticImpact { speed: 0.0, ..good };
    let error = Impact::new(&at_rest, Damping::None, None).expect_err("no speed");
    assert_eq!(error.to_string(), "speed is 0 m/s; expected more than 0");
    for restitution in [0.0, -0.5, 1.1, f64::NAN] {
        let error = Impact::new(&good, Damping::Restitution(restitution), None);
        let message = error.expect_err("no such restitution").to_string();
        assert!(message.contains("more than 0 and at most 1"), "{message}");
    }
}
