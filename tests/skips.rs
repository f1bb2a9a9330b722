//! Work that is left out: the answer is that of doing it.

mod common;

use common::{GRAVITY, RADIUS, floor, pellet, run_until, setup, simulation, simulation_on, wall};
use pelletflow::core::{InstructionSet, PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::sim::{Fill, FillAmount, Seats, Setup, Simulation, Skips};

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

/// A bin with a bed of 600 pellets, at rest after 1.2 s.
fn bed(skips: Skips) -> Setup {
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
    setup.skips = skips;
    setup
}

fn slept(simulation: &Simulation) -> bool {
    simulation
        .skipped()
        .iter()
        .any(|skipped| skipped.what == "pellets at rest")
}

#[test]
fn a_bed_that_sleeps_lies_as_one_that_is_worked_out() {
    let awake = Skips {
        rest: false,
        ..Skips::default()
    };
    let [asleep, awake] = [Skips::default(), awake].map(|skips| {
        let mut simulation = simulation(bed(skips));
        run_until(&mut simulation, 1.5).expect("the bed rests");
        simulation
    });
    assert!(slept(&asleep) && !slept(&awake));
    // Held pellets creep no more; the others may by one overlap of 5 µm in 39 ms, for half a second.
    for id in 0..600 {
        let apart = (pellet(&asleep, id).position - pellet(&awake, id).position).norm();
        assert!(apart < 13.0 * 5.0e-6, "pellet {id}: {apart}");
    }
    let (with, without) = (asleep.energy_ledger(), awake.energy_ledger());
    assert!((with.potential / without.potential - 1.0).abs() < 1.0e-6);
    assert!((with.elastic / without.elastic - 1.0).abs() < 1.0e-2);
    assert_eq!(with.kinetic, 0.0);
    let coordination = |simulation: &Simulation| simulation.contact_statistics().mean_coordination;
    assert!((coordination(&asleep) / coordination(&awake) - 1.0).abs() < 1.0e-2);
}

#[test]
fn instruction_sets_and_threads_change_no_bit_of_a_bed_that_falls_asleep() {
    let run = |instructions, threads| {
        let mut setup = bed(Skips::default());
        setup.instructions = Some(instructions);
        let mut simulation = simulation_on(setup, threads);
        run_until(&mut simulation, 1.2).expect("the bed rests");
        simulation.state_hash()
    };
    let oracle = run(InstructionSet::Baseline, 1);
    for instructions in InstructionSet::ALL {
        if instructions.is_available() {
            assert_eq!(run(instructions, 2), oracle, "{instructions:?}");
        }
    }
}
