//! Work that is left out: the answer is that of doing it.

mod common;

use common::{GRAVITY, RADIUS, floor, run_until, setup, simulation, simulation_on, wall};
use pelletflow::core::{InstructionSet, PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::sim::{Fill, FillAmount, Seats, Setup};

const ROUGH: PairProperties = PairProperties {
    restitution: 0.5,
    friction: 0.5,
    rolling_friction: 0.05,
    ..PairProperties::ELASTIC
};

/// Pellets that fall, spinning, onto a floor 0.4 m below and bounce.
fn falling(free_flight: bool) -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.fills = vec![Fill {
        name: "drop".into(),
        pellets: 0,
        seats: Seats::Points(vec![
            Vec3::new(0.0, 0.0, 0.4),
            Vec3::new(0.2, 0.0, 0.45),
            Vec3::new(0.4, 0.0, 0.35),
        ]),
        velocity: Vec3::new(0.1, 0.2, 0.0),
        spin: Vec3::new(3.0, 0.0, 20.0),
    }];
    setup.skips.free_flight = free_flight;
    setup
}

#[test]
fn many_steps_of_free_flight_at_once_have_the_bits_of_single_ones() {
    let run = |free_flight, threads| {
        let mut simulation = simulation_on(falling(free_flight), threads);
        run_until(&mut simulation, 1.0).expect("they bounce");
        let ledger = simulation.energy_ledger();
        let skipped = simulation.skipped();
        let flew = skipped
            .iter()
            .any(|skipped| skipped.what == "contacts in free flight");
        assert_eq!(flew, free_flight);
        assert!(simulation.contact_statistics().finished > 3, "they hit");
        (
            simulation.state_hash(),
            simulation.particle_steps(),
            ledger.kinetic.to_bits(),
            ledger.potential.to_bits(),
        )
    };
    assert_eq!(run(true, 1), run(false, 1));
    assert_eq!(run(true, 2), run(false, 1));
}

#[test]
fn a_free_flight_ends_where_the_caller_asks() {
    let mut simulation = simulation(falling(true));
    for steps in [1, 7, 100] {
        let before = simulation.step_count();
        simulation.advance(steps).expect("they fall");
        assert_eq!(simulation.step_count(), before + steps);
    }
}

/// A bin with a bed of 600 pellets.
fn bed() -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    let side = 10.0 * RADIUS;
    setup.walls = vec![wall("floor", floor(0.0))];
    for inward in [Vec3::x(), -Vec3::x(), Vec3::y(), -Vec3::y()] {
        let shape = Shape::HalfSpace {
            point: -side * inward,
            normal: UnitVector3::new_normalize(inward),
        };
        setup.walls.push(wall("side", shape));
    }
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::new(side - 1.0e-3, side - 1.0e-3, 0.3),
            }
            .translated(Vec3::new(0.0, 0.0, 0.32)),
            amount: FillAmount::Count(600),
        },
        velocity: Vec3::new(0.3, 0.2, 0.0),
        spin: Vec3::zeros(),
    }];
    setup
}

#[test]
fn instruction_sets_and_threads_change_no_bit_of_a_bed() {
    let run = |instructions, threads| {
        let mut setup = bed();
        setup.instructions = Some(instructions);
        let mut simulation = simulation_on(setup, threads);
        run_until(&mut simulation, 0.5).expect("the bed rests");
        simulation.state_hash()
    };
    let oracle = run(InstructionSet::Baseline, 1);
    for instructions in InstructionSet::ALL {
        if instructions.is_available() {
            assert_eq!(run(instructions, 2), oracle, "{instructions:?}");
        }
    }
}
