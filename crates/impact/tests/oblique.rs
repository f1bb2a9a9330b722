//! Oblique hits: partial slip is the exact solution, Coulomb the closed form, Mindlin's one spring the usual error.

mod common;

use common::{is_near, papers_pellet};
use pelletflow_impact::{Approach, Damping, Impact, Rebound, Slip};

const FRICTION: f64 = 0.3;

/// A hit whose sliding speed before is `theta` times `μ v_n`, for a pair of one Poisson's ratio.
fn hit(theta: f64, poisson_ratio: f64, slip: Slip, damping: Damping) -> Rebound {
    let normal = papers_pellet(2.0);
    let approach = Approach {
        tangential_speed: theta * FRICTION * normal.speed,
        spin: 0.0,
        radius: normal.effective_radius,
        friction: FRICTION,
        // Of a pair of two bodies of this Poisson's ratio.
        stiffness_ratio: 2.0 * (1.0 - poisson_ratio) / (2.0 - poisson_ratio),
        slip,
    };
    Impact::new(&normal, damping, Some(&approach))
        .expect("a hit that ends")
        .rebound
        .expect("an oblique hit")
}

/// Sliding and spinning speed after the hit, over `μ v_n`.
fn outcome(rebound: &Rebound) -> [f64; 2] {
    let normal = papers_pellet(2.0);
    let unit = FRICTION * normal.speed;
    [
        rebound.sliding_speed / unit,
        normal.effective_radius * rebound.spin / unit,
    ]
}

#[test]
fn partial_slip_is_the_exact_solution_of_mindlin_and_deresiewicz() {
    // Maw, Barber & Fawcett 1976 by the method of dimensionality reduction, to three digits:
    // θ; φ and Rω/(μ v_n) for ν 0.3; the same for ν 0.4.
    let table = [
        (0.333, [0.053, -0.200], [0.004, -0.235]),
        (1.0, [-0.004, -0.717], [-0.153, -0.824]),
        (2.0, [-0.673, -1.909], [-0.848, -2.034]),
        (3.0, [-1.392, -3.137], [-1.565, -3.261]),
        (4.0, [-1.764, -4.117], [-1.907, -4.219]),
        (5.0, [-1.704, -4.789], [-1.784, -4.846]),
    ];
    for (theta, of_three, of_four) in table {
        for (poisson_ratio, exact) in [(0.3, of_three), (0.4, of_four)] {
            let found = outcome(&hit(theta, poisson_ratio, Slip::Partial, Damping::None));
            // Half a unit of the last digit, and as much for the elements and steps of the march.
            for (found, exact) in found.into_iter().zip(exact) {
                assert!(
                    (found - exact).abs() < 1.5e-3,
                    "θ {theta} ν {poisson_ratio}: {found} {exact}"
                );
            }
        }
    }
}

#[test]
fn mindlins_single_spring_has_the_errors_that_flows_are_known_for() {
    // The same table's column of the usual law, total displacement, ν 0.3.
    let table = [
        (1.0, [0.667, -0.238]),
        (2.0, [-0.276, -1.626]),
        (3.0, [-1.001, -2.858]),
        (4.0, [-1.398, -3.856]),
        (5.0, [-1.436, -4.597]),
    ];
    for (theta, usual) in table {
        let found = outcome(&hit(theta, 0.3, Slip::Mindlin, Damping::None));
        for (found, usual) in found.into_iter().zip(usual) {
            assert!((found - usual).abs() < 5.0e-3, "θ {theta}: {found} {usual}");
        }
    }
}

#[test]
fn hits_that_slide_throughout_end_the_same_by_every_law() {
    // φ = θ − 7/2 (1 + e), Rω/(μ v_n) = −5/2 (1 + e). By springs to what the march leaves over.
    for slip in [Slip::Coulomb, Slip::Mindlin, Slip::Partial] {
        let [sliding, spinning] = outcome(&hit(9.0, 0.3, slip, Damping::None));
        assert!(is_near(sliding, 2.0, 1.0e-4), "{slip:?}: {sliding}");
        assert!(is_near(spinning, -5.0, 1.0e-4), "{slip:?}: {spinning}");
    }
    let [sliding, spinning] = outcome(&hit(9.0, 0.3, Slip::Coulomb, Damping::Restitution(0.5)));
    assert!(is_near(sliding, 3.75, 1.0e-6), "{sliding}");
    assert!(is_near(spinning, -3.75, 1.0e-6), "{spinning}");
}

#[test]
fn coulombs_friction_ends_in_rolling_when_it_stops_the_sliding() {
    for theta in [0.5, 3.0, 6.9] {
        let rebound = hit(theta, 0.3, Slip::Coulomb, Damping::None);
        // A rounding error of the sum of two speeds.
        assert!(rebound.sliding_speed.abs() < 1.0e-15, "θ {theta}");
        let share = rebound
            .tangential_restitution
            .expect("it came with a speed");
        assert!(is_near(share, 5.0 / 7.0, 1.0e-12));
    }
}

#[test]
fn the_faster_sliding_of_aluminum_oxide_on_glass_rebounds_as_measured() {
    // Kharaz, Gorham & Salman 2001: 5 mm spheres at 3.9 m/s, μ 0.092; angle from the normal, tangential restitution.
    let measured = [
        (2.03, 0.794),
        (3.93, 0.745),
        (9.63, 0.673),
        (20.1, 0.596),
        (30.2, 0.688),
        (39.3, 0.772),
        (49.5, 0.847),
        (59.8, 0.902),
    ];
    let squares: f64 = measured
        .iter()
        .map(|(angle, share)| {
            let found = kharaz(*angle);
            (found - share) * (found - share)
        })
        .sum();
    let error = (squares / 8.0).sqrt();
    // 0.0135 by an independent solution; the points themselves scatter by about as much.
    assert!(error < 0.015, "root mean square {error}");
}

/// Tangential restitution of the experiment's sphere at an angle [°] from the normal.
fn kharaz(angle: f64) -> f64 {
    use pelletflow_core::{Material, MaterialPair, PairProperties};
    let oxide = Material {
        density: 4000.0,
        youngs_modulus: 380.0e9,
        poisson_ratio: 0.23,
    };
    let glass = Material {
        density: 2500.0,
        youngs_modulus: 70.0e9,
        poisson_ratio: 0.25,
    };
    let properties = PairProperties {
        restitution: 0.98,
        friction: 0.092,
        rolling_friction: 0.0,
        ..PairProperties::ELASTIC
    };
    let pair = MaterialPair::new(&oxide, &glass, &properties);
    let radius = 2.5e-3_f64;
    let mass = oxide.density * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    let angle = angle.to_radians();
    let normal = pelletflow_impact::ElasticImpact::on_plane(&pair, radius, mass, 3.9 * angle.cos());
    let approach = Approach {
        tangential_speed: 3.9 * angle.sin(),
        spin: 0.0,
        radius,
        friction: pair.friction,
        stiffness_ratio: 4.0 * pair.effective_shear_modulus / pair.effective_youngs_modulus,
        slip: Slip::Partial,
    };
    Impact::new(&normal, Damping::Restitution(0.98), Some(&approach))
        .expect("a hit that ends")
        .rebound
        .and_then(|rebound| rebound.tangential_restitution)
        .expect("it came with a speed")
}

#[test]
fn logistic_curves_follow_a_hit_that_slides_throughout() {
    // Speed and spin follow the normal impulse then, which grows as a logistic curve within 2 % of its range.
    let rebound = hit(9.0, 0.3, Slip::Partial, Damping::None);
    for fit in [rebound.speed_fit, rebound.spin_fit] {
        let fit = fit.expect("a change");
        assert!(fit.rms_error < 0.02, "{fit:?}");
        assert!((fit.middle - 0.5).abs() < 0.02, "{fit:?}");
    }
}

#[test]
fn friction_below_zero_is_refused() {
    let normal = papers_pellet(2.0);
    let approach = Approach {
        tangential_speed: 1.0,
        spin: 0.0,
        radius: 7.5e-3,
        friction: -0.1,
        stiffness_ratio: 0.8,
        slip: Slip::Coulomb,
    };
    let error = Impact::new(&normal, Damping::None, Some(&approach)).expect_err("no friction");
    assert_eq!(error.to_string(), "friction is -0.1; expected 0 or more");
}
