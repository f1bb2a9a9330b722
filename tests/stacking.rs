//! Piles at rest: what friction holds, and what walls carry.

mod common;

use common::{GRAVITY, RADIUS, floor, held, one, pellet, setup, simulation, simulation_on, wall};
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{Fill, FillAmount, Seats};
use std::f64::consts::PI;

/// Whether a pellet lies on three others after a second, by the friction between them and on the floor [-].
fn stands(between: f64, on_floor: f64) -> bool {
    let pair = |friction| PairProperties {
        restitution: 0.3,
        friction,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(pair(between), pair(on_floor));
    // Stiff, so that the spheres stay where geometry puts them.
    setup.materials[common::ORE].material.youngs_modulus = 2.0e9;
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    let around = 2.0 * RADIUS / 3.0_f64.sqrt();
    for index in 0..3 {
        let angle = f64::from(index) * 2.0 * PI / 3.0;
        let seat = Vec3::new(around * angle.cos(), around * angle.sin(), RADIUS);
        setup
            .fills
            .push(one(&format!("base {index}"), seat, Vec3::zeros()));
    }
    let height = RADIUS * (1.0 + (8.0_f64 / 3.0).sqrt());
    setup
        .fills
        .push(one("top", Vec3::new(0.0, 0.0, height), Vec3::zeros()));
    let mut simulation = simulation(setup);
    let steps = (1.0 / simulation.model().time_step().seconds) as u64;
    simulation.advance(steps).expect("four spheres");
    pellet(&simulation, 3).position.z > 0.98 * height
}

/// Friction between which and which a pyramid falls and stands [-], by halving.
fn threshold(stands: impl Fn(f64) -> bool) -> f64 {
    let (mut falls_at, mut stands_at) = (0.0, 1.0);
    for _ in 0..8 {
        let middle = f64::midpoint(falls_at, stands_at);
        if stands(middle) {
            stands_at = middle;
        } else {
            falls_at = middle;
        }
    }
    f64::midpoint(falls_at, stands_at)
}

#[test]
fn a_pyramid_of_four_stands_where_friction_holds_it() {
    // Each contact's force lies in its cone of friction: tan(a/2), where sin a = 1/√3; on the floor a quarter of it.
    let exact = (0.5 * (1.0 / 3.0_f64.sqrt()).asin()).tan();
    let between = threshold(|friction| stands(friction, 1.0));
    held(
        "piles",
        "friction between spheres at which a pyramid of four stands, 0.318",
        between / exact - 1.0,
        0.03,
        "statics",
    );
    let on_floor = threshold(|friction| stands(1.0, friction));
    held(
        "piles",
        "friction on the floor at which a pyramid of four stands, 0.0795",
        on_floor / (exact / 4.0) - 1.0,
        0.05,
        "statics",
    );
}

#[test]
fn the_floor_of_a_silo_carries_what_janssen_leaves_it() {
    let friction = 0.4;
    let pair = PairProperties {
        restitution: 0.3,
        friction,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(pair, pair);
    setup.gravity = GRAVITY;
    let radius = 6.0 * RADIUS;
    let tube = |radius, half_length| Shape::Cylinder {
        radius,
        half_length,
    };
    let mut descending = wall("floor", floor(0.0));
    // A floor that sinks a little lets the pellets slide on the wall, which mobilizes its friction.
    descending.motion = pelletflow::sim::Motion::Translating {
        velocity: Vec3::new(0.0, 0.0, -0.01),
        start: 1.6,
        end: 2.4,
    };
    setup.walls = vec![
        descending,
        wall(
            "tube",
            Shape::Difference {
                of: Box::new(tube(2.0 * radius, 1.9)),
                minus: Box::new(tube(radius, 1.95)),
            },
        ),
    ];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: tube(radius - 1.0e-4, 0.5).translated(0.52 * Vec3::z()),
            amount: FillAmount::Count(700),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    let mut simulation = simulation_on(setup, 2);
    let steps = (2.4 / simulation.model().time_step().seconds) as u64;
    let mut force = 0.0;
    let mut samples = 0.0;
    for step in 0..steps {
        simulation.step().expect("the bed sinks");
        if simulation.time() > 2.0 && step % 20 == 0 {
            force -= simulation.state().books.wall_force[0].z;
            samples += 1.0;
        }
    }
    let weight: f64 = simulation.pellets().map(|pellet| pellet.mass * 9.81).sum();
    let top = simulation
        .pellets()
        .map(|pellet| pellet.position.z)
        .fold(0.0, f64::max);
    let height = top + RADIUS - (-0.01 * 0.8);
    let carried = force / samples / weight;
    let slender = 4.0 * friction * height / (2.0 * radius);
    // K is 0.6 here, as measured for spheres by most; 0.5 would carry 0.28 and 0.7 would carry 0.21.
    let janssen = (1.0 - (-0.6 * slender).exp()) / (0.6 * slender);
    held(
        "piles",
        "share of a bed's weight on the floor of a silo four diameters high, friction 0.4",
        carried / janssen - 1.0,
        0.1,
        "Janssen 1895, K = 0.6",
    );
}
