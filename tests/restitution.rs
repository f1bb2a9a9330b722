//! Restitution against speed by each normal law, against its published formula.

mod common;

use common::{ORE, RADIUS, STEEL, floor, held, one, pellet, setup, simulation, wall};
use pelletflow::core::contact::NormalLaw;
use pelletflow::core::{MaterialPair, PairProperties, Vec3};
use pelletflow::sim::Simulation;
use std::f64::consts::PI;

/// A pellet above a plane, coming down at a speed [m/s].
fn coming_down(law: NormalLaw, properties: PairProperties, speed: f64) -> Simulation {
    let mut setup = setup(properties, properties);
    setup.laws.normal = law;
    setup.walls = vec![wall("plane", floor(0.0))];
    setup.fills = vec![one(
        "drop",
        Vec3::new(0.0, 0.0, 1.01 * RADIUS),
        Vec3::new(0.0, 0.0, -speed),
    )];
    simulation(setup)
}

/// Rebound speed over that of the hit [-], at default settings, and the simulation after it.
fn restitution(law: NormalLaw, properties: PairProperties, speed: f64) -> (f64, Simulation) {
    let mut simulation = coming_down(law, properties, speed);
    while simulation.contact_statistics().finished == 0 {
        simulation.step().expect("one hit is no trouble");
    }
    (pellet(&simulation, 0).velocity.z / speed, simulation)
}

fn pair(properties: &PairProperties) -> MaterialPair {
    let materials = setup(*properties, *properties).materials;
    MaterialPair::new(
        &materials[ORE].material,
        &materials[STEEL].material,
        properties,
    )
}

fn mass() -> f64 {
    3700.0 * 4.0 / 3.0 * PI * RADIUS.powi(3)
}

#[test]
fn a_linear_contact_rebounds_with_the_restitution_asked_for_and_the_force_of_an_oscillator() {
    let stiffness = 2.0e5;
    let (mut worst, mut worst_peak) = (0.0_f64, 0.0_f64);
    for wanted in [0.3, 0.5, 0.7, 0.9, 1.0] {
        for speed in [0.5, 2.0, 8.0] {
            let properties = PairProperties {
                restitution: wanted,
                stiffness: Some(stiffness),
                ..PairProperties::ELASTIC
            };
            let (found, simulation) = restitution(NormalLaw::Linear, properties, speed);
            worst = worst.max((found - wanted).abs());
            if wanted == 1.0 {
                let exact = speed * (stiffness * mass()).sqrt();
                let peak = simulation.contact_statistics().max_force;
                worst_peak = worst_peak.max((peak / exact - 1.0).abs());
            }
        }
    }
    // At 12 steps per contact.
    let claim = "linear: restitution 0.3 to 1 at 0.5 to 8 m/s, greatest error";
    held("restitution", claim, worst, 0.007, "what was asked for");
    let claim = "linear: peak force, elastic";
    held(
        "restitution",
        claim,
        worst_peak,
        1.0e-3,
        "harmonic oscillator",
    );
}

#[test]
fn a_plastic_contact_rebounds_by_thorntons_formula() {
    let properties = PairProperties {
        yield_pressure: Some(5.0e6),
        ..PairProperties::ELASTIC
    };
    let modulus = pair(&properties).effective_youngs_modulus;
    let stiffness = 4.0 / 3.0 * modulus * RADIUS.sqrt();
    let yield_overlap = RADIUS * (PI * 5.0e6 / (2.0 * modulus)).powi(2);
    // Where the energy of the hit is that of Hertz at the overlap of yielding.
    let yield_speed = (0.8 * stiffness * yield_overlap.powf(2.5) / mass()).sqrt();
    let mut worst: f64 = 0.0;
    for ratio in [0.5, 1.0, 1.5, 3.0, 10.0, 30.0] {
        let slow: f64 = 1.0 / ratio;
        // Thornton (1997), eq. 31.
        let exact = if ratio <= 1.0 {
            1.0
        } else {
            (1.2 * 3.0_f64.sqrt()).sqrt()
                * (1.0 - slow * slow / 6.0).sqrt()
                * (slow / (slow + 2.0 * (1.2 - 0.2 * slow * slow).sqrt())).powf(0.25)
        };
        let (found, simulation) = restitution(NormalLaw::Plastic, properties, ratio * yield_speed);
        worst = worst.max((found - exact).abs());
        let energy = simulation.energy_ledger();
        // The force bends where loading turns to unloading, between two samples.
        assert!(
            energy.residual.abs() < 1.0e-3 * energy.throughput,
            "{energy:?}"
        );
    }
    let claim = "plastic: restitution at 0.5 to 30 times the speed of yielding, greatest error";
    held("restitution", claim, worst, 2.0e-3, "Thornton 1997");
}

#[test]
fn damping_takes_its_share_of_a_plastic_hit_too() {
    let yielding = |restitution| PairProperties {
        restitution,
        yield_pressure: Some(5.0e6),
        ..PairProperties::ELASTIC
    };
    let (undamped, _) = restitution(NormalLaw::Plastic, yielding(1.0), 1.0);
    let (damped, _) = restitution(NormalLaw::Plastic, yielding(0.7), 1.0);
    assert!(damped < 0.95 * undamped, "{damped} against {undamped}");
}

#[test]
fn a_sticky_contact_rebounds_with_what_tearing_leaves() {
    let surface_energy: f64 = 5.0;
    let properties = PairProperties {
        surface_energy: Some(surface_energy),
        ..PairProperties::ELASTIC
    };
    // Thornton & Ning (1998), Powder Technol. 99, 154–162.
    let modulus = pair(&properties).effective_youngs_modulus;
    let torn = 7.09 * (surface_energy.powi(5) * RADIUS.powi(4) / (modulus * modulus)).cbrt();
    let sticking_speed = (2.0 * torn / mass()).sqrt();
    // The pull ends at once where the neck tears, which no sample meets: it counts for up to a step too long.
    for (ratio, tolerance) in [(1.2, 0.06), (1.5, 5.0e-3), (3.0, 5.0e-3), (10.0, 1.0e-3)] {
        let exact = (1.0_f64 - 1.0 / (ratio * ratio)).sqrt();
        let (found, _) = restitution(NormalLaw::Jkr, properties, ratio * sticking_speed);
        let claim = format!("sticky: restitution at {ratio} times the sticking speed");
        held(
            "restitution",
            &claim,
            found - exact,
            tolerance,
            "Thornton & Ning 1998",
        );
    }
    let mut slow = coming_down(NormalLaw::Jkr, properties, 0.9 * sticking_speed);
    slow.advance(20_000).expect("it sticks");
    assert_eq!(slow.contact_statistics().finished, 0);
    assert!(pellet(&slow, 0).position.z < 1.005 * RADIUS, "it holds on");
}
