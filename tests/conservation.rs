//! What a closed system keeps.

mod common;

use common::{RADIUS, floor, one, pellet, setup, simulation, smooth, tube, wall};
use pelletflow::core::contact::{TangentialLaw, TurningLaw};
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{Fill, FillAmount, Integrator, Seats, Setup, Simulation, StepRequest};

/// Two blocks of pellets that fly at each other.
fn colliding_blocks(properties: PairProperties) -> Setup {
    let mut setup = setup(properties, properties);
    let block = |name: &str, side: f64| Fill {
        name: name.into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::new(0.07, 0.08, 0.06),
            }
            .translated(Vec3::new(0.08 * side, 0.003 * side, 0.002)),
            amount: FillAmount::Count(400),
        },
        velocity: Vec3::new(-1.5 * side, 0.2, 0.1 * side),
        spin: Vec3::new(5.0, 20.0 * side, 0.0),
    };
    setup.fills = vec![block("left", -1.0), block("right", 1.0)];
    setup
}

fn momentum(simulation: &Simulation) -> (Vec3, f64) {
    simulation
        .pellets()
        .fold((Vec3::zeros(), 0.0), |(sum, size), pellet| {
            let momentum = pellet.mass * pellet.velocity;
            (sum + momentum, size + momentum.norm())
        })
}

fn angular_momentum(simulation: &Simulation) -> (Vec3, f64) {
    simulation
        .pellets()
        .fold((Vec3::zeros(), 0.0), |(sum, size), pellet| {
            let orbit = pellet.mass * pellet.position.cross(&pellet.velocity);
            let spin = 0.4 * pellet.mass * pellet.radius.powi(2) * pellet.spin;
            (sum + orbit + spin, size + orbit.norm() + spin.norm())
        })
}

#[test]
fn momentum_of_a_closed_system_is_conserved_to_rounding() {
    let mut simulation = simulation(colliding_blocks(PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.1,
        ..PairProperties::ELASTIC
    }));
    let (before, _) = momentum(&simulation);
    simulation.advance(3000).expect("blocks may collide");
    assert!(
        simulation.contact_statistics().finished > 500,
        "the blocks did collide"
    );
    let (after, size) = momentum(&simulation);
    // 800 pellets, a few hundred thousand additions, each rounded by 10⁻¹⁶.
    assert!(
        (after - before).norm() < 1.0e-13 * size,
        "{:e}",
        (after - before).norm() / size
    );
}

#[test]
fn angular_momentum_of_a_closed_system_is_conserved() {
    let mut simulation = simulation(colliding_blocks(PairProperties {
        restitution: 0.7,
        friction: 0.5,
        rolling_friction: 0.0,
        ..PairProperties::ELASTIC
    }));
    let (before, _) = angular_momentum(&simulation);
    simulation.advance(3000).expect("blocks may collide");
    let (after, size) = angular_momentum(&simulation);
    // Velocities at the full step are predicted, to second order in the step, while contacts are open.
    assert!(
        (after - before).norm() < 1.0e-6 * size,
        "{:e}",
        (after - before).norm() / size
    );
}

#[test]
fn energy_of_elastic_frictionless_collisions_is_conserved() {
    let mut setup = colliding_blocks(smooth(1.0));
    setup.laws.tangential = TangentialLaw::None;
    setup.laws.rolling = TurningLaw::None;
    let mut simulation = simulation(setup);
    let before: f64 = simulation
        .pellets()
        .map(|pellet| 0.5 * pellet.mass * pellet.velocity.norm_squared())
        .sum();
    simulation.advance(6000).expect("blocks may collide");
    assert!(
        simulation.contact_statistics().finished > 500,
        "the blocks did collide"
    );
    let ledger = simulation.energy_ledger();
    assert_eq!(ledger.dissipated, 0.0);
    // Located Verlet errs by 10⁻⁴ per collision at this step, with either sign.
    assert!((ledger.kinetic + ledger.elastic - before).abs() < 1.0e-3 * before);
}

#[test]
fn the_energy_ledger_closes_when_pellets_pour_onto_a_floor() {
    // Strong damping is the hard case: too large a step turns it into a source of energy.
    for restitution in [0.1, 0.5] {
        // Velocity Verlet misses part of what a damped contact dissipates at first touch.
        for (integrator, tolerance) in [
            (Integrator::VelocityVerlet, 0.02),
            (Integrator::LocatedVerlet, 0.005),
        ] {
            let (at_rest, residual) = pour(restitution, integrator);
            assert!(
                at_rest,
                "e = {restitution}, {integrator:?}: the bed is at rest"
            );
            assert!(
                residual.abs() < tolerance,
                "e = {restitution}, {integrator:?}: {residual:.4} of the energy that went through"
            );
        }
    }
}

/// Pours a bed; whether it has come to rest, and the residual of the energy ledger over what went through it [-].
fn pour(restitution: f64, integrator: Integrator) -> (bool, f64) {
    let properties = PairProperties {
        restitution,
        friction: 0.5,
        rolling_friction: 0.1,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(properties, properties);
    setup.gravity = common::GRAVITY;
    setup.integrator = integrator;
    setup.walls = vec![
        wall("floor", floor(0.0)),
        wall("ring", tube([0.08, 0.2], 0.3)),
    ];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cylinder {
                radius: 0.079,
                half_length: 0.12,
            }
            .translated(0.15 * Vec3::z()),
            amount: FillAmount::Count(300),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    let mut simulation = simulation(setup);
    let steps = (0.8 / simulation.model().time_step().seconds) as u64;
    simulation.advance(steps).expect("the bed settles");
    let ledger = simulation.energy_ledger();
    (
        ledger.kinetic < 1.0e-3 * ledger.dissipated,
        ledger.residual / ledger.throughput,
    )
}

#[test]
fn a_belt_does_the_work_that_the_ledger_enters() {
    let properties = PairProperties {
        restitution: 0.5,
        friction: 0.4,
        rolling_friction: 0.0,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(smooth(1.0), properties);
    setup.gravity = common::GRAVITY;
    let mut belt = wall("belt", floor(0.0));
    belt.surface_velocity = Vec3::new(1.0, 0.0, 0.0);
    setup.walls = vec![belt];
    setup.fills = vec![one(
        "ball",
        Vec3::new(0.0, 0.0, 0.999 * RADIUS),
        Vec3::zeros(),
    )];
    let mut simulation = simulation(setup);
    simulation
        .advance(40_000)
        .expect("a ball on a belt is no trouble");
    let ball = pellet(&simulation, 0);
    // A ball put on a belt ends up rolling with 2/7 of the belt's speed.
    assert!((ball.velocity.x - 2.0 / 7.0).abs() < 1.0e-3);
    let ledger = simulation.energy_ledger();
    // The belt's force is μ m g while sliding, for 2/7 · v/(μ g): work m v² 2/7.
    let work = ball.mass * 2.0 / 7.0;
    assert!((ledger.wall_work / work - 1.0).abs() < 5.0e-3);
    assert!(ledger.residual.abs() < 0.01 * ledger.throughput);
}

/// Greatest residual over throughput while a damped pellet hits a floor, at a number of steps per contact [-].
fn missed_within_a_hit(steps: f64) -> f64 {
    let mut setup = setup(smooth(0.5), smooth(0.5));
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.fills = vec![one("drop", 1.01 * RADIUS * Vec3::z(), -Vec3::z())];
    let contact_time = simulation(setup.clone())
        .model()
        .time_step()
        .shortest_contact;
    setup.step = StepRequest::Fixed(contact_time / steps);
    let mut simulation = simulation(setup);
    let mut worst = 0.0_f64;
    while simulation.contact_statistics().finished == 0 {
        simulation.step().expect("one hit is no trouble");
        let energy = simulation.energy_ledger();
        worst = worst.max(energy.residual.abs() / energy.throughput);
    }
    worst
}

#[test]
fn the_energy_ledger_closes_within_a_hit_to_second_order() {
    let (coarse, fine) = (missed_within_a_hit(100.0), missed_within_a_hit(1600.0));
    // 16 times the steps: 16² times less, where a step counted whole before its time would give 16; first touch costs a part.
    assert!(fine < coarse / 100.0, "{coarse:e} to {fine:e}");
}

#[test]
fn what_went_through_the_ledger_is_not_forgotten_at_the_top_of_a_bounce() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.gravity = common::GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.fills = vec![one("drop", 3.0 * RADIUS * Vec3::z(), Vec3::zeros())];
    let mut simulation = simulation(setup);
    let mut greatest = 0.0_f64;
    for _ in 0..10_000 {
        simulation.step().expect("one pellet is no trouble");
        let throughput = simulation.energy_ledger().throughput;
        assert!(throughput >= greatest);
        greatest = throughput;
    }
    assert!(simulation.contact_statistics().finished > 1, "it bounced");
}
