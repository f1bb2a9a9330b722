//! Flow down a rough slope without end: where it stands, flows steadily and runs away, and how fast it flows at which depth.

mod common;

use common::{held, setup, simulation_on, wall};
use pelletflow::core::contact::{NormalLaw, TurningLaw};
use pelletflow::core::{Bounds, PairProperties, Shape, Vec3};
use pelletflow::sim::{Domain, Fill, FillAmount, Seats, Setup, Simulation};

/// Diameter of the pellets [m].
const DIAMETER: f64 = 2.0 * common::RADIUS;
/// Acceleration of gravity [m/s²].
const GRAVITY: f64 = 9.81;
/// Balls of the bottom along the slope and across it [-].
const BALLS: [u32; 2] = [10, 8];
/// Distance of two balls of the bottom over the diameter [-].
const SPACING: f64 = 1.1;
/// Pellets that flow [-].
const PELLETS: usize = 1700;
/// Stiffness of a contact in weights of a pellet per diameter [-]; Silbert et al. show that more changes nothing.
const STIFFNESS: f64 = 2.0e4;

/// Time in which a pellet falls through half its diameter [s].
fn unit_time() -> f64 {
    (DIAMETER / GRAVITY).sqrt()
}

/// Numbers between -0.5 and 0.5 that fill a square evenly (Roberts' sequence).
fn jitter(index: u32) -> [f64; 3] {
    [0.819_172_513_4, 0.671_043_606_7, 0.549_700_477_9]
        .map(|step| (step * f64::from(index)) % 1.0 - 0.5)
}

/// Balls that do not move, a wall for each with its images beyond the borders, so that a pellet may lie on several.
fn bottom(setup: &mut Setup, size: Vec3) {
    let ball = Shape::Sphere {
        radius: DIAMETER / 2.0,
    };
    for index in 0..BALLS[0] * BALLS[1] {
        let [x, y, z] = jitter(index);
        let center = Vec3::new(
            (f64::from(index % BALLS[0]) + 0.5 + 0.3 * x) * SPACING * DIAMETER,
            (f64::from(index / BALLS[0]) + 0.5 + 0.3 * y) * SPACING * DIAMETER,
            (0.6 * z - 0.5) * DIAMETER,
        );
        let mut images = Vec::new();
        for i in -1..=1 {
            for j in -1..=1 {
                let shift = Vec3::new(f64::from(i) * size.x, f64::from(j) * size.y, 0.0);
                images.push(ball.clone().translated(center + shift));
            }
        }
        let images = Shape::Union { of: images };
        setup.walls.push(wall(&format!("ball {index}"), images));
    }
}

/// A bed on a slope of an angle [rad], set going at two diameters per unit of time.
fn slope(angle: f64) -> Simulation {
    let pair = PairProperties {
        restitution: 0.88,
        friction: 0.5,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(pair, pair);
    setup.laws.normal = NormalLaw::Linear;
    setup.laws.rolling = TurningLaw::None;
    let mass = setup.mass(0, DIAMETER / 2.0);
    for (_, pair) in &mut setup.pairs {
        pair.stiffness = Some(STIFFNESS * mass * GRAVITY / DIAMETER);
    }
    setup.gravity = GRAVITY * Vec3::new(angle.sin(), 0.0, -angle.cos());
    let size = SPACING * DIAMETER * Vec3::new(f64::from(BALLS[0]), f64::from(BALLS[1]), 0.0);
    let height = 30.0 * DIAMETER;
    setup.domain = Domain {
        bounds: Bounds {
            min: Vec3::new(0.0, 0.0, -2.0 * DIAMETER),
            max: size + Vec3::new(0.0, 0.0, 4.0 * height),
        },
        is_periodic: [true, true, false],
    };
    bottom(&mut setup, size);
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: (size + Vec3::new(0.0, 0.0, height)) / 2.0,
            }
            .translated((size + Vec3::new(0.0, 0.0, height + DIAMETER)) / 2.0),
            amount: FillAmount::Count(PELLETS),
        },
        velocity: 2.0 * DIAMETER / unit_time() * Vec3::x(),
        spin: Vec3::zeros(),
    }];
    simulation_on(setup, 2)
}

/// Advances by a number of units of time.
fn run(simulation: &mut Simulation, units: f64) {
    let steps = (units * unit_time() / simulation.model().time_step().seconds) as u64;
    simulation.advance(steps).expect("it flows");
}

/// Mean velocity along the slope, in diameters per unit of time [-].
fn mean_velocity(simulation: &Simulation) -> f64 {
    let sum: f64 = simulation.pellets().map(|pellet| pellet.velocity.x).sum();
    sum / PELLETS as f64 * unit_time() / DIAMETER
}

/// What flows at each height, in layers one diameter high, averaged over a time.
struct Profile {
    /// Share of each layer's volume that is pellet [-].
    volume: Vec<f64>,
    /// Mean velocity along the slope in each layer, in diameters per unit of time [-].
    velocity: Vec<f64>,
    /// Mean height of the pellets' centers above the bottom, in diameters [-].
    mean_height: f64,
}

/// Averages over a number of units of time, with two looks in each.
fn profile(simulation: &mut Simulation, units: u32) -> Profile {
    let (mut count, mut flow, mut height) = (vec![0.0; 40], vec![0.0; 40], 0.0);
    for _ in 0..2 * units {
        run(simulation, 0.5);
        for pellet in simulation.pellets() {
            let above = pellet.position.z / DIAMETER;
            height += above;
            let layer = (above.max(0.0) as usize).min(39);
            count[layer] += 1.0;
            flow[layer] += pellet.velocity.x * unit_time() / DIAMETER;
        }
    }
    let looks = 2.0 * f64::from(units);
    let area = SPACING * SPACING * f64::from(BALLS[0] * BALLS[1]);
    Profile {
        volume: count
            .iter()
            .map(|count| count / looks * std::f64::consts::PI / 6.0 / area)
            .collect(),
        velocity: flow
            .iter()
            .zip(&count)
            .map(|(flow, count)| flow / f64::max(*count, 1.0))
            .collect(),
        mean_height: height / looks / PELLETS as f64,
    }
}

/// Greatest difference of a velocity profile from the best of the form `a + b (1 − (1 − z/H)^1.5)`, over its range [-].
fn off_bagnold(velocity: &[f64], first: usize, height: f64) -> f64 {
    let shape: Vec<f64> = (0..velocity.len())
        .map(|layer| 1.0 - (1.0 - ((first + layer) as f64 + 0.5) / height).powf(1.5))
        .collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mean_shape, mean_velocity) = (mean(&shape), mean(velocity));
    let pairs = || shape.iter().zip(velocity);
    let slope = pairs()
        .map(|(s, v)| (s - mean_shape) * (v - mean_velocity))
        .sum::<f64>()
        / shape.iter().map(|s| (s - mean_shape).powi(2)).sum::<f64>();
    let off = pairs()
        .map(|(s, v)| (v - mean_velocity - slope * (s - mean_shape)).abs())
        .fold(0.0, f64::max);
    let range = velocity.iter().copied().fold(0.0, f64::max)
        - velocity.iter().copied().fold(f64::INFINITY, f64::min);
    off / range
}

const SOURCE: &str = "Silbert et al. 2001";

#[test]
#[ignore = "minutes; `cargo xtask verify` runs it"]
fn a_flow_at_23_degrees_is_steady_and_has_bagnolds_profile() {
    let mut simulation = slope(23.0_f64.to_radians());
    run(&mut simulation, 120.0);
    let early = profile(&mut simulation, 40);
    let late = profile(&mut simulation, 40);
    let mean = |profile: &Profile| -> f64 {
        let flow = profile.velocity.iter().zip(&profile.volume);
        flow.map(|(velocity, volume)| velocity * volume)
            .sum::<f64>()
            / profile.volume.iter().sum::<f64>()
    };
    held(
        "slopes",
        "mean velocity down a rough slope of 23°, from 120 to 160 and from 160 to 200 √(d/g)",
        mean(&late) / mean(&early) - 1.0,
        0.05,
        SOURCE,
    );
    // Constant density, so the surface is twice as high as the mean; bottom and surface have layers of their own.
    let height = 2.0 * late.mean_height;
    let bulk = 2..(height - 2.0) as usize;
    let volume = &late.volume[bulk.clone()];
    let middle = volume.iter().sum::<f64>() / volume.len() as f64;
    let uneven = volume.iter().map(|share| (share / middle - 1.0).abs());
    held(
        "slopes",
        "density of that flow, layer by layer, against its mean",
        uneven.fold(0.0, f64::max),
        0.05,
        SOURCE,
    );
    // Looser than random loose packing at rest would allow no flow to be steady, denser none at all.
    assert!((0.55..0.6).contains(&middle), "{middle}");
    held(
        "slopes",
        "velocity of that flow at each depth, over its range, against H^1.5 − (H − z)^1.5",
        off_bagnold(&late.velocity[bulk.clone()], bulk.start, height),
        0.05,
        "Bagnold 1954; Silbert et al. 2001",
    );
}

#[test]
#[ignore = "minutes; `cargo xtask verify` runs it"]
fn a_flow_at_18_degrees_comes_to_rest() {
    let mut simulation = slope(18.0_f64.to_radians());
    run(&mut simulation, 120.0);
    held(
        "slopes",
        "mean velocity down a rough slope of 18° after 120 √(d/g), in √(g d)",
        mean_velocity(&simulation),
        1.0e-3,
        SOURCE,
    );
}

#[test]
#[ignore = "minutes; `cargo xtask verify` runs it"]
fn a_flow_at_30_degrees_runs_away() {
    let mut simulation = slope(30.0_f64.to_radians());
    run(&mut simulation, 60.0);
    let early = mean_velocity(&simulation);
    run(&mut simulation, 60.0);
    let gain = mean_velocity(&simulation) / early;
    held(
        "slopes",
        "mean velocity down a rough slope of 30° at 60 √(d/g) over that at 120 √(d/g)",
        1.0 / gain,
        0.8,
        SOURCE,
    );
}
