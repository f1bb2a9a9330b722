//! The same bits, however the work is divided or found.

mod common;

use common::{floor, setup, simulation_on, tube, wall};
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{
    Fill, FillAmount, Inlet, NeighborSearch, Outlet, PelletKind, Rate, Seats, Setup,
    SizeDistribution, Skips,
};

/// A bed, a feeder and an outlet in a ring: pellets settle, come and go.
fn busy_scene() -> Setup {
    let properties = PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.1,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(properties, properties);
    setup.gravity = common::GRAVITY;
    setup.pellets.push(PelletKind {
        name: "fines".into(),
        material: common::ORE,
        size: SizeDistribution::Uniform {
            min_diameter: 0.010,
            max_diameter: 0.014,
        },
    });
    setup.walls = vec![
        wall("floor", floor(0.05)),
        wall("ring", tube([0.15, 0.3], 0.3)),
    ];
    let bed = |name: &str, pellets: usize, height: f64| Fill {
        name: name.into(),
        pellets,
        seats: Seats::Lattice {
            region: Shape::Cylinder {
                radius: 0.13,
                half_length: 0.06,
            }
            .translated(height * Vec3::z()),
            amount: FillAmount::Count(500),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    };
    setup.fills = vec![bed("coarse", 0, 0.1), bed("fine", 1, 0.25)];
    setup.inlets = vec![Inlet {
        name: "feed".into(),
        pellets: 1,
        region: Shape::Cuboid {
            half_sides: Vec3::new(0.08, 0.08, 0.03),
        }
        .translated(0.5 * Vec3::z()),
        rate: Rate::Mass(1.0),
        velocity: -2.0 * Vec3::z(),
        start: 0.0,
        end: f64::INFINITY,
    }];
    setup.outlets = vec![Outlet {
        name: "top".into(),
        region: Shape::Sphere { radius: 0.06 }.translated(Vec3::new(0.1, 0.0, 0.05)),
    }];
    setup
}

fn hash_after(setup: Setup, threads: usize, steps: u64) -> String {
    let mut simulation = simulation_on(setup, threads);
    simulation.advance(steps).expect("the scene is sound");
    let ledger = simulation.mass_ledger();
    assert!(
        ledger.discharged.count > 5 && ledger.by_inlet[0].count > 5,
        "pellets came and went"
    );
    simulation.state_hash()
}

#[test]
fn one_and_two_and_four_threads_give_the_same_bits() {
    let alone = hash_after(busy_scene(), 1, 2500);
    assert_eq!(hash_after(busy_scene(), 2, 2500), alone);
    assert_eq!(hash_after(busy_scene(), 4, 2500), alone);
}

#[test]
fn every_neighbor_search_gives_the_same_bits() {
    let run = |search| {
        hash_after(
            Setup {
                search,
                ..busy_scene()
            },
            1,
            2000,
        )
    };
    let oracle = run(NeighborSearch::AllPairs);
    assert_eq!(run(NeighborSearch::Grid), oracle);
    assert_eq!(run(NeighborSearch::HierarchicalGrid), oracle);
    assert_eq!(run(NeighborSearch::Tree), oracle);
}

#[test]
fn skipping_distant_walls_changes_no_bit() {
    let run = |distant_walls| {
        let skips = Skips {
            distant_walls,
            ..Skips::default()
        };
        hash_after(
            Setup {
                skips,
                ..busy_scene()
            },
            1,
            2000,
        )
    };
    assert_eq!(run(false), run(true));
}

#[test]
fn skipping_rotation_where_no_law_turns_a_pellet_changes_no_bit() {
    let run = |rotation| {
        let mut setup = busy_scene();
        setup.laws.tangential = pelletflow::core::contact::TangentialLaw::None;
        setup.laws.rolling = pelletflow::core::contact::TurningLaw::None;
        setup.skips.rotation = rotation;
        hash_after(setup, 1, 2000)
    };
    assert_eq!(run(false), run(true));
}

#[test]
fn another_seed_gives_another_run() {
    let other = Setup {
        seed: 2,
        ..busy_scene()
    };
    assert_ne!(
        hash_after(other, 1, 2000),
        hash_after(busy_scene(), 1, 2000)
    );
}
