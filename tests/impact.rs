//! A single impact on a plane, at default settings, against Hertz's exact solution.

mod common;

use common::{GRAVITY, RADIUS, floor, one, pellet, setup, simulation, smooth, wall};
use pelletflow::core::Vec3;
use pelletflow::impact::ElasticImpact;
use pelletflow::sim::Simulation;

/// What one impact on a plane gave.
struct Impact {
    peak_force: f64,
    contact_time: f64,
    rebound_speed: f64,
}

/// Lets a pellet hit a plane at a speed [m/s]; `phase` is where in a step it first touches [-].
fn hit(restitution: f64, speed: f64, phase: f64) -> (Impact, ElasticImpact, Simulation) {
    let mut setup = setup(smooth(1.0), smooth(restitution));
    setup.walls = vec![wall("floor", floor(0.0))];
    // The step depends on the fastest hit expected; the fill's velocity is that hit.
    let draft = simulation({
        let mut draft = setup.clone();
        draft.fills = vec![one(
            "drop",
            Vec3::new(0.0, 0.0, 0.1),
            Vec3::new(0.0, 0.0, -speed),
        )];
        draft
    });
    let time_step = draft.model().time_step().seconds;
    let gap = (3.0 + phase) * time_step * speed;
    setup.fills = vec![one(
        "drop",
        Vec3::new(0.0, 0.0, RADIUS + gap),
        Vec3::new(0.0, 0.0, -speed),
    )];
    let mut simulation = simulation(setup);
    let start = pellet(&simulation, 0).position.z;
    let first_touch = (start - RADIUS) / speed;
    while pellet(&simulation, 0).velocity.z <= 0.0 || pellet(&simulation, 0).position.z < RADIUS {
        simulation.step().expect("one hit is no trouble");
    }
    // One more step, so that the velocity is that of free flight; flying back gives the release exactly.
    simulation.step().expect("free flight");
    let after = pellet(&simulation, 0);
    let release = simulation.time() - (after.position.z - RADIUS) / after.velocity.z;
    let impact = Impact {
        peak_force: simulation.contact_statistics().max_force,
        contact_time: release - first_touch,
        rebound_speed: after.velocity.z,
    };
    let pair = pelletflow::core::MaterialPair::new(
        &simulation.model().setup().materials[common::ORE].material,
        &simulation.model().setup().materials[common::STEEL].material,
        &smooth(restitution),
    );
    let exact = ElasticImpact::on_plane(&pair, RADIUS, after.mass, speed);
    (impact, exact, simulation)
}

const SPEEDS: [f64; 5] = [0.5, 1.0, 2.0, 4.0, 8.0];
const PHASES: usize = 16;

fn phases() -> impl Iterator<Item = f64> {
    (0..PHASES).map(|phase| phase as f64 / PHASES as f64)
}

#[test]
fn an_elastic_impact_has_the_force_time_and_rebound_of_hertz_within_a_thousandth() {
    for speed in SPEEDS {
        for phase in phases() {
            let (impact, exact, _) = hit(1.0, speed, phase);
            let errors = [
                impact.peak_force / exact.peak_force() - 1.0,
                impact.contact_time / exact.contact_time() - 1.0,
                impact.rebound_speed / speed - 1.0,
            ];
            for (what, error) in ["peak force", "contact time", "rebound speed"]
                .iter()
                .zip(errors)
            {
                // The error asked for by default is 0.1 %.
                assert!(
                    error.abs() < 1.0e-3,
                    "{what} at {speed} m/s, phase {phase}: {:.4} %",
                    100.0 * error
                );
            }
        }
    }
}

#[test]
fn a_damped_impact_has_the_restitution_asked_for_at_any_speed_and_phase() {
    for restitution in [0.3, 0.5, 0.7, 0.9] {
        for speed in SPEEDS {
            for phase in phases() {
                let (impact, _, _) = hit(restitution, speed, phase);
                let error = impact.rebound_speed / speed - restitution;
                // Velocity Verlet is of first order where a damped contact begins: 0.011 at 20 steps per contact.
                assert!(
                    error.abs() < 0.015,
                    "e = {restitution}, {speed} m/s, phase {phase}: {error:.4}"
                );
            }
        }
    }
}

#[test]
fn a_finished_contact_has_as_many_steps_as_the_time_step_promised() {
    let (impact, _, simulation) = hit(1.0, 2.0, 0.4);
    let promised = impact.contact_time / simulation.model().time_step().seconds;
    let statistics = simulation.contact_statistics();
    assert_eq!(statistics.finished, 1);
    assert!((statistics.fewest_steps as f64 - promised).abs() <= 1.0);
}

#[test]
fn free_fall_is_exact() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.gravity = GRAVITY;
    setup.fills = vec![one(
        "drop",
        Vec3::new(0.0, 0.0, 1.0),
        Vec3::new(0.3, 0.0, 0.0),
    )];
    let mut simulation = simulation(setup);
    let start = pellet(&simulation, 0).position;
    simulation.advance(5000).expect("nothing is in the way");
    let time = simulation.time();
    let fallen = pellet(&simulation, 0);
    let exact = start + Vec3::new(0.3 * time, 0.0, -0.5 * 9.81 * time * time);
    // 5,000 roundings of positions of 1 m.
    assert!((fallen.position - exact).norm() < 1.0e-12);
    assert!((fallen.velocity - Vec3::new(0.3, 0.0, -9.81 * time)).norm() < 1.0e-11);
}
