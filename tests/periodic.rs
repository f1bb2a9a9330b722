//! Periodic axes: what leaves on one side comes in at the other, and nothing else changes.

mod common;

use common::{GRAVITY, RADIUS, floor, one, pellet, setup, simulation, simulation_on, smooth, wall};
use pelletflow::core::{Bounds, PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::sim::{
    Domain, Fill, FillAmount, Model, NeighborSearch, Outlet, PelletKind, Seats, Setup, Simulation,
    SizeDistribution,
};

/// Side of the box [m].
const SIDE: f64 = 0.2;

fn rough(restitution: f64) -> PairProperties {
    PairProperties {
        restitution,
        friction: 0.4,
        rolling_friction: 0.02,
        ..PairProperties::ELASTIC
    }
}

/// An empty box about the origin, periodic along some axes.
fn empty_box(is_periodic: [bool; 3], pellets: PairProperties) -> Setup {
    let mut setup = setup(pellets, rough(0.5));
    setup.domain = Domain {
        bounds: Bounds::about_origin(Vec3::repeat(SIDE / 2.0)),
        is_periodic,
    };
    setup
}

/// Two pellets after an oblique hit about a point, both drifting along x so that they come round in mid-contact.
fn hit_about(point: Vec3) -> [(Vec3, Vec3, Vec3); 2] {
    let mut setup = empty_box([true, true, false], rough(0.6));
    // Neighbors are sought every few steps, so that the first comes round before the second.
    setup.skin = Some(1.0e-4);
    let apart = Vec3::new(0.8, 0.0, 0.6) * (RADIUS + 1.0e-4);
    let drift = Vec3::new(0.3, -0.2, 0.0);
    let approach = Vec3::new(-0.5, 0.3, -0.1);
    setup.fills = vec![
        one("left", point - apart, drift - approach),
        one("right", point + apart, drift + approach),
    ];
    setup.fills[0].spin = Vec3::new(5.0, -20.0, 3.0);
    let mut simulation = simulation(setup);
    let steps = (5.0e-3 / simulation.model().time_step().seconds) as u64;
    simulation.advance(steps).expect("they hit and part");
    assert_eq!(simulation.contact_statistics().finished, 1);
    [0, 1].map(|id| {
        let pellet = pellet(&simulation, id);
        (pellet.position - point, pellet.velocity, pellet.spin)
    })
}

#[test]
fn a_hit_across_a_border_is_the_hit_in_the_middle_of_the_box() {
    let in_the_middle = hit_about(Vec3::zeros());
    for border in [
        Vec3::new(SIDE / 2.0, 0.0, 0.0),
        Vec3::new(-SIDE / 2.0, SIDE / 2.0, 0.0),
    ] {
        let across = hit_about(border - Vec3::new(1.0e-4, 0.0, 0.0));
        for ((position, velocity, spin), expected) in across.into_iter().zip(in_the_middle) {
            let away = position - expected.0;
            let whole = away.map(|component| SIDE * (component / SIDE).round());
            // Coordinates of 0.1 m round to 1e-17 m, an overlap of 1e-4 m therefore to 1e-13.
            assert!((away - whole).norm() < 1.0e-14, "{away}");
            assert!((velocity - expected.1).norm() < 1.0e-11);
            assert!((spin - expected.2).norm() < 1.0e-9);
        }
    }
}

/// A gas in a box without walls, sizes from 1 to 3 or all alike.
fn gas(pair: PairProperties, size_ratio: f64) -> Setup {
    let mut setup = empty_box([true; 3], pair);
    let diameter = 2.0 * RADIUS;
    setup.pellets.push(PelletKind {
        name: "other".into(),
        material: common::ORE,
        size: SizeDistribution::Single {
            diameter: diameter / size_ratio,
        },
    });
    let along = 7;
    for index in 0..along * along * along {
        let seat = [index % along, index / along % along, index / along / along]
            .map(|place| (f64::from(place) + 0.5) / f64::from(along) * SIDE - SIDE / 2.0);
        // Any velocities without order will do; these fill the ball of directions evenly.
        let turn = 2.399_963_229_728_653 * f64::from(index);
        let height = 2.0 * ((0.618_033_988_75 * f64::from(index)) % 1.0) - 1.0;
        let around = (1.0 - height * height).sqrt();
        let velocity = Vec3::new(around * turn.cos(), around * turn.sin(), height);
        let mut fill = one(&format!("{index}"), Vec3::from(seat), velocity);
        fill.pellets = (index % 2) as usize;
        setup.fills.push(fill);
    }
    setup
}

fn momentum(simulation: &Simulation) -> Vec3 {
    simulation
        .pellets()
        .map(|pellet| pellet.mass * pellet.velocity)
        .sum()
}

#[test]
fn a_gas_without_walls_keeps_its_energy_and_its_momentum() {
    let mut simulation = simulation_on(gas(smooth(1.0), 1.0), 2);
    simulation.advance(1).expect("nothing touches yet");
    let energy = |simulation: &Simulation| {
        let ledger = simulation.energy_ledger();
        ledger.kinetic + ledger.elastic
    };
    let (energy_before, momentum_before) = (energy(&simulation), momentum(&simulation));
    let size: f64 = simulation.pellets().map(|pellet| pellet.mass).sum();
    while simulation.contact_statistics().finished < 20 * 343 {
        simulation.advance(200).expect("it is a gas");
    }
    // Forces are exact negatives; what is left is the rounding of some 10⁴ additions to each of 343 velocities.
    let drift = (momentum(&simulation) - momentum_before).norm() / size;
    assert!(drift < 1.0e-13, "{drift}");
    // The energy of a moment swings with the contacts that are open: the step errs by 0.1 % in each.
    let share = energy(&simulation) / energy_before - 1.0;
    assert!(share.abs() < 2.0e-3, "{share}");
    assert_eq!(simulation.pellet_count(), 343);
}

#[test]
fn every_search_and_any_number_of_threads_give_the_same_bits_across_borders() {
    for size_ratio in [1.0, 4.0] {
        let hash = |search, threads| {
            let mut setup = gas(rough(0.8), size_ratio);
            setup.search = search;
            let mut simulation = simulation_on(setup, threads);
            let steps = (0.1 / simulation.model().time_step().seconds) as u64;
            simulation.advance(steps).expect("it is a gas");
            assert!(simulation.contact_statistics().finished > 100);
            simulation.state_hash()
        };
        let oracle = hash(NeighborSearch::AllPairs, 1);
        assert_eq!(hash(NeighborSearch::Grid, 1), oracle);
        assert_eq!(hash(NeighborSearch::HierarchicalGrid, 2), oracle);
        assert_eq!(hash(NeighborSearch::Tree, 2), oracle);
        assert_eq!(hash(NeighborSearch::Grid, 3), oracle);
    }
}

#[test]
fn the_energy_ledger_stays_closed_while_pellets_fall_round_and_round() {
    let mut setup = gas(rough(0.7), 1.0);
    setup.gravity = Vec3::new(1.0, 0.5, -9.0);
    let mut simulation = simulation_on(setup, 1);
    let speed_before = (momentum(&simulation)
        / simulation.pellets().map(|pellet| pellet.mass).sum::<f64>())
    .norm();
    let steps = (0.5 / simulation.model().time_step().seconds) as u64;
    simulation.advance(steps).expect("all fall together");
    let mass: f64 = simulation.pellets().map(|pellet| pellet.mass).sum();
    let speed = (momentum(&simulation) / mass).norm();
    // Nothing is outside to brake them: they fall freely, six boxes deep.
    let free_fall = 0.5 * Vec3::new(1.0, 0.5, -9.0).norm();
    assert!((speed - free_fall).abs() < speed_before + 2.0e-3 * free_fall);
    let ledger = simulation.energy_ledger();
    assert!(ledger.carried_in > 0.5 * ledger.kinetic, "{ledger:?}");
    // The ledger of the same hits without gravity is as good.
    assert!(
        ledger.residual.abs() < 2.0e-4 * ledger.throughput,
        "{ledger:?}"
    );
}

#[test]
fn pellets_leave_by_an_outlet_in_a_periodic_box() {
    let mut setup = empty_box([true, true, false], rough(0.5));
    setup.gravity = GRAVITY;
    setup.outlets = vec![Outlet {
        name: "below".into(),
        region: Shape::HalfSpace {
            point: Vec3::new(0.0, 0.0, -0.06),
            normal: Vec3::z_axis(),
        },
    }];
    setup.fills = vec![Fill {
        name: "rain".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::new(0.1, 0.1, 0.05),
            }
            .translated(Vec3::new(0.0, 0.0, 0.04)),
            amount: FillAmount::Count(300),
        },
        velocity: Vec3::new(2.0, -1.0, 0.0),
        spin: Vec3::zeros(),
    }];
    let mut simulation = simulation(setup);
    let steps = (0.3 / simulation.model().time_step().seconds) as u64;
    simulation
        .advance(steps)
        .expect("all come round and leave below");
    let ledger = simulation.mass_ledger();
    assert_eq!((ledger.discharged.count, ledger.lost.count), (300, 0));
}

/// Keys and messages of the mistakes of a setup.
fn mistakes(setup: Setup) -> Vec<String> {
    let errors = Model::new(setup).expect_err("something is wrong");
    errors.iter().map(ToString::to_string).collect()
}

#[test]
fn a_box_too_narrow_for_its_pellets_is_refused_with_the_least_length() {
    let mut setup = empty_box([false, true, false], rough(0.5));
    setup.fills = vec![one("one", Vec3::zeros(), Vec3::zeros())];
    setup.domain.bounds.max.y = -0.07;
    let found = mistakes(setup);
    // Twice the diameter of 15 mm and the skin of a tenth of it.
    assert!(found[0].starts_with("domain.periodic: the domain is 0.0300 m long along its periodic axis y; expected at least 0.0330 m"), "{found:?}");
}

#[test]
fn a_wall_must_be_the_same_on_both_periodic_borders() {
    let with = |shape: Shape| {
        let mut setup = empty_box([true, false, false], rough(0.5));
        setup.fills = vec![one("one", Vec3::zeros(), Vec3::zeros())];
        setup.walls = vec![wall("bottom", shape)];
        Model::new(setup)
            .map(|_| ())
            .map_err(|errors| errors[0].to_string())
    };
    let cuboid = |center: Vec3, half_sides: Vec3| Shape::Cuboid { half_sides }.translated(center);
    // Through both borders, across the axis that is not periodic, away from the borders.
    assert_eq!(with(floor(0.0)), Ok(()));
    let tilted = UnitVector3::new_normalize(Vec3::new(0.0, 1.0, 1.0));
    assert_eq!(
        with(Shape::HalfSpace {
            point: Vec3::zeros(),
            normal: tilted
        }),
        Ok(())
    );
    assert_eq!(
        with(cuboid(Vec3::zeros(), Vec3::new(0.5, 0.01, 0.01))),
        Ok(())
    );
    assert_eq!(
        with(cuboid(Vec3::zeros(), Vec3::new(0.08, 0.01, 0.01))),
        Ok(())
    );
    // Tilted along the axis, ending at a border, just outside of one.
    for shape in [
        floor(0.1),
        cuboid(Vec3::zeros(), Vec3::new(0.095, 0.01, 0.01)),
        cuboid(Vec3::new(0.1, 0.0, 0.0), Vec3::repeat(0.01)),
        cuboid(Vec3::new(-0.12, 0.0, 0.0), Vec3::repeat(0.015)),
    ] {
        let message = with(shape).expect_err("it breaks off at a border");
        assert!(message.starts_with("walls.bottom.shape: the wall is not the same on both borders of the periodic axis x"), "{message}");
    }
}
