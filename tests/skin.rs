//! The skin of the neighbor lists: it follows the motion seen, and no bit follows it.

mod common;

use common::{
    GRAVITY, RADIUS, floor, one, run_until, setup, simulation, simulation_on, smooth, wall,
};
use pelletflow::core::contact::NormalLaw;
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{
    Fill, FillAmount, Inlet, Motion, NeighborSearch, Outlet, PelletKind, Rate, Seats, Setup,
    SizeDistribution,
};

const ROUGH: PairProperties = PairProperties {
    restitution: 0.5,
    friction: 0.5,
    rolling_friction: 0.1,
    ..PairProperties::ELASTIC
};
/// Diameter of the pellets [m].
const DIAMETER: f64 = 2.0 * RADIUS;
/// A few units in the last place of a share of the diameter [-].
const ROUNDING: f64 = 1.0e-12;

/// A closed drum that turns about its level axis [rad/s], with pellets of two kinds thrown into it [m/s].
fn drum(rate: f64, velocity: Vec3) -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    setup.pellets.push(PelletKind {
        name: "fines".into(),
        material: common::ORE,
        size: SizeDistribution::Uniform {
            min_diameter: 0.010,
            max_diameter: 0.014,
        },
    });
    let hollow = Shape::Difference {
        of: Box::new(Shape::Cylinder {
            radius: 0.2,
            half_length: 0.15,
        }),
        minus: Box::new(Shape::Cylinder {
            radius: 0.15,
            half_length: 0.1,
        }),
    };
    let mut shell = wall("shell", hollow);
    shell.motion = Motion::Rotating {
        center: Vec3::zeros(),
        axis: Vec3::z_axis(),
        rate,
        start: 0.0,
        end: f64::INFINITY,
    };
    setup.walls = vec![shell];
    setup.gravity = -9.81 * Vec3::y();
    let bed = |name: &str, pellets: usize, along: f64| Fill {
        name: name.into(),
        pellets,
        seats: Seats::Lattice {
            region: Shape::Cylinder {
                radius: 0.12,
                half_length: 0.04,
            }
            .translated(along * Vec3::z()),
            amount: FillAmount::Count(300),
        },
        velocity,
        spin: Vec3::zeros(),
    };
    setup.fills = vec![bed("coarse", 0, 0.045), bed("fine", 1, -0.045)];
    setup
}

/// Hash of the state after steps enough for pellets to be stored anew several times.
fn hash_of(setup: Setup, threads: usize) -> String {
    let mut simulation = simulation_on(setup, threads);
    simulation.advance(2200).expect("the drum is closed");
    simulation.state_hash()
}

fn assert_skin_changes_no_bit(rate: f64, velocity: Vec3) {
    let tuned = hash_of(drum(rate, velocity), 1);
    assert_eq!(hash_of(drum(rate, velocity), 2), tuned, "two threads");
    let oracle = Setup {
        search: NeighborSearch::AllPairs,
        ..drum(rate, velocity)
    };
    assert_eq!(hash_of(oracle, 1), tuned, "all pairs");
    for (skin, threads) in [(2.0e-4, 1), (1.5e-3, 2), (6.0e-3, 1)] {
        let fixed = Setup {
            skin: Some(skin),
            ..drum(rate, velocity)
        };
        assert_eq!(hash_of(fixed, threads), tuned, "a skin of {skin} m");
    }
}

#[test]
fn no_bit_of_a_flow_follows_the_skin() {
    assert_skin_changes_no_bit(8.0, Vec3::new(2.0, -1.0, 0.5));
}

#[test]
fn no_bit_of_a_settling_bed_follows_the_skin() {
    assert_skin_changes_no_bit(0.0, Vec3::zeros());
}

#[test]
fn the_skin_is_wide_in_a_fast_flow_and_thin_in_a_bed_at_rest() {
    let skin_after = |speed: f64| {
        let mut setup = setup(smooth(0.5), smooth(0.5));
        setup.fills = vec![one("pellet", -Vec3::z(), speed * Vec3::z())];
        let mut simulation = simulation(setup);
        simulation.step().expect("it flies");
        let first = simulation.state().skin / DIAMETER;
        assert!((first - 0.1).abs() < ROUNDING, "nothing was seen");
        simulation.advance(2000).expect("it flies");
        simulation.state().skin / DIAMETER
    };
    let (creeping, sliding, fast) = (skin_after(0.02), skin_after(0.3), skin_after(20.0));
    assert!(creeping < 0.5 * sliding && sliding < 0.7 * fast);
    // Wider lists would name much that is never touched.
    assert!((fast - 0.4).abs() < ROUNDING);
}

#[test]
fn a_skin_of_the_scene_stays() {
    let mut simulation = simulation(Setup {
        skin: Some(1.0e-3),
        ..drum(8.0, Vec3::new(2.0, -1.0, 0.5))
    });
    for _ in 0..20 {
        simulation.advance(20).expect("the drum is closed");
        assert_eq!(simulation.state().skin, 1.0e-3);
    }
}

#[test]
fn the_skin_lasts_no_longer_than_from_one_fed_pellet_to_the_next() {
    let skin = |rate: f64| {
        let mut setup = setup(smooth(0.5), smooth(0.5));
        setup.inlets = vec![Inlet {
            name: "feed".into(),
            pellets: 0,
            region: Shape::Cuboid {
                half_sides: Vec3::new(0.3, 0.3, 0.05),
            },
            rate: Rate::Count(rate),
            velocity: -4.0 * Vec3::z(),
            start: 0.0,
            end: f64::INFINITY,
        }];
        let mut simulation = simulation(setup);
        simulation.advance(3000).expect("there is room");
        let step = simulation.model().time_step().seconds;
        // Two pellets close in on each other by twice the way of one.
        (simulation.state().skin, 2.0 * 4.0 * step / (rate * step))
    };
    let (thin, fed) = skin(4000.0);
    assert!(thin < 1.6 * fed, "{thin} m, {fed} m from feed to feed");
    assert!(skin(100.0).0 > 2.0 * thin);
}

#[test]
fn the_skin_stays_thin_where_a_periodic_box_has_no_room_for_a_wide_one() {
    let skin = |side: f64| {
        let mut setup = setup(smooth(0.5), smooth(0.5));
        setup.domain.bounds.min = -0.5 * Vec3::repeat(side);
        setup.domain.bounds.max = 0.5 * Vec3::repeat(side);
        setup.domain.is_periodic = [true; 3];
        setup.fills = vec![one("pellet", Vec3::zeros(), Vec3::new(5.0, 0.0, 0.0))];
        let mut simulation = simulation(setup);
        simulation.advance(2000).expect("it goes round");
        simulation.state().skin / DIAMETER
    };
    // Two diameters and twice a tenth of one fit, twice 0.4 of one do not.
    assert!((skin(2.3 * DIAMETER) - 0.1).abs() < ROUNDING);
    assert!(skin(3.0 * DIAMETER) > 0.2);
}

#[test]
fn sticky_pellets_hold_on_within_any_skin() {
    let sticky = PairProperties {
        surface_energy: Some(50.0),
        restitution: 0.5,
        ..PairProperties::ELASTIC
    };
    let run = |skin| {
        let mut setup = setup(sticky, sticky);
        setup.laws.normal = NormalLaw::Jkr;
        setup.skin = skin;
        setup.walls = vec![wall("floor", floor(0.0))];
        // Barely apart: they touch, stick, and are carried along.
        let start = |side: f64| 0.51 * side * DIAMETER * Vec3::x() + 0.1 * Vec3::z();
        setup.fills = vec![
            one("left", start(-1.0), Vec3::new(0.3, 0.0, 1.0)),
            one("right", start(1.0), Vec3::new(0.1, 0.0, 1.0)),
        ];
        let mut simulation = simulation(setup);
        simulation.advance(3000).expect("they fly");
        simulation.state_hash()
    };
    let tuned = run(None);
    for skin in [4.0e-3, 8.0e-3] {
        assert_eq!(run(Some(skin)), tuned, "a skin of {skin} m");
    }
}

#[test]
fn no_pellet_passes_a_thin_outlet_unseen() {
    let mut setup = setup(smooth(0.5), smooth(0.5));
    let thickness = 0.1 * DIAMETER;
    setup.outlets = vec![Outlet {
        name: "sheet".into(),
        region: Shape::Cuboid {
            half_sides: Vec3::new(1.0, 1.0, thickness / 2.0),
        },
    }];
    // Spread over more than the way from one search to the next, were the skin wide.
    let start = |place: f64| Vec3::new(place, 0.0, 0.5 + 3.0 * place * thickness);
    setup.fills = (0_u32..20)
        .map(|index| {
            let place = 0.05 * f64::from(index);
            one(&format!("pellet-{index}"), start(place), -15.0 * Vec3::z())
        })
        .collect();
    let mut simulation = simulation(setup);
    run_until(&mut simulation, 0.08).expect("none reaches the border");
    assert_eq!(simulation.mass_ledger().discharged.count, 20);
}
