//! A flow down a rough slope without end, in the proportions of Silbert et al. 2001: 26°, springs and dashpots.
//!
//! Lengths go with the diameter, times with √(d/g).

use crate::places::{self, Place};
use crate::silo;
use pelletflow::core::contact::NormalLaw;
use pelletflow::core::{Bounds, MaterialPair, Shape, Vec3};
use pelletflow::sim::{
    Domain, Fill, FillAmount, Motion, Schedule, Seats, Setup, StepRequest, Wall,
};
use serde_json::{Value, json};
use std::f64::consts::PI;

/// Tiles along the slope and across it [-].
pub(crate) const TILES: [usize; 2] = [4, 2];
/// Pellets of a tile that flow [-].
const PELLETS: usize = 4000;
/// Side of a tile in diameters: so many balls make its bottom along each side [-].
const SIDE: u32 = 10;
const DIAMETER: f64 = silo::DIAMETER;
const GRAVITY: f64 = 9.81;
/// Inclination of the slope [°].
const ANGLE: f64 = 26.0;
/// Stiffness of a contact in weights of a pellet per diameter [-].
const STIFFNESS: f64 = 2.0e5;
/// Velocity of the surface at the start, in √(g d) [-].
const SURFACE_VELOCITY: f64 = 10.6;
/// Time in which a lattice becomes a flow, in √(d/g) [-].
const MIXING_TIME: f64 = 6.0;

/// Time in which a pellet falls through half its diameter [s].
fn unit_time() -> f64 {
    (DIAMETER / GRAVITY).sqrt()
}

/// The slope of so many tiles.
pub(crate) fn setup(tiles: [usize; 2]) -> Setup {
    let mut setup = silo::silo(0, 0.15);
    let mass = setup.mass(0, DIAMETER / 2.0);
    let pair = &mut setup.pairs[0].1;
    pair.restitution = 0.88;
    pair.stiffness = Some(STIFFNESS * mass * GRAVITY / DIAMETER);
    setup.laws.normal = NormalLaw::Linear;
    let angle = ANGLE.to_radians();
    setup.gravity = GRAVITY * Vec3::new(angle.sin(), 0.0, -angle.cos());
    setup.step = StepRequest::Fixed(1.0e-4 * unit_time());
    let [along, across] = tiles.map(|count| count as f64 * f64::from(SIDE) * DIAMETER);
    setup.domain = Domain {
        bounds: Bounds {
            min: Vec3::new(0.0, 0.0, -2.0 * DIAMETER),
            max: Vec3::new(along, across, 80.0 * DIAMETER),
        },
        is_periodic: [true, true, false],
    };
    let size = Vec3::new(along, across, 0.0);
    setup.walls = balls(size)
        .into_iter()
        .enumerate()
        .map(|(index, center)| ball(index, center, size))
        .collect();
    setup
}

/// Centers of the balls of the bottom of a box [m], the same in each tile: raised and lowered by Roberts' sequence.
fn balls(size: Vec3) -> Vec<Vec3> {
    let count = |length: f64| (length / DIAMETER).round() as u32;
    let (columns, rows) = (count(size.x), count(size.y));
    (0..columns * rows)
        .map(|index| {
            let (column, row) = (index % columns, index / columns);
            let in_tile = row % SIDE * SIDE + column % SIDE;
            let height = (0.618_033_988_7 * f64::from(in_tile)) % 1.0 - 0.5;
            DIAMETER
                * Vec3::new(
                    f64::from(column) + 0.5,
                    f64::from(row) + 0.5,
                    0.6 * height - 0.5,
                )
        })
        .collect()
}

/// A ball that does not move, with its images beyond the borders that a pellet inside can reach.
fn ball(index: usize, center: Vec3, size: Vec3) -> Wall {
    let mut images = Vec::new();
    for [x, y] in [-1.0, 0.0, 1.0]
        .into_iter()
        .flat_map(|x| [-1.0, 0.0, 1.0].map(|y| [x, y]))
    {
        let image = center + Vec3::new(x * size.x, y * size.y, 0.0);
        let is_within =
            |value: f64, end: f64| value > -2.0 * DIAMETER && value < end + 2.0 * DIAMETER;
        if is_within(image.x, size.x) && is_within(image.y, size.y) {
            let ball = Shape::Sphere {
                radius: DIAMETER / 2.0,
            };
            images.push(ball.translated(image));
        }
    }
    let shape = if images.len() > 1 {
        Shape::Union { of: images }
    } else {
        images.remove(0)
    };
    Wall {
        name: format!("ball {index}"),
        material: 0,
        shape: shape.into(),
        motion: Motion::Fixed,
        surface_velocity: Vec3::zeros(),
        schedule: Schedule::always(),
    }
}

/// A flow over all tiles: that of one of them after a while, over and over, each layer with its mean velocity.
pub(crate) fn flow() -> Vec<Place> {
    let mut setup = setup([1, 1]);
    let side = f64::from(SIDE) * DIAMETER;
    let size = Vec3::new(side, side, 70.0 * DIAMETER);
    setup.fills = vec![Fill {
        name: "lattice".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: size / 2.0,
            }
            .translated(size / 2.0 + 0.5 * DIAMETER * Vec3::z()),
            amount: FillAmount::Count(PELLETS),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    let mut lattice = places::of(&silo::simulation(setup.clone(), 1));
    let top = lattice
        .iter()
        .map(|place| place.position.z)
        .fold(0.0, f64::max);
    for place in &mut lattice {
        place.velocity.x = bagnold(place.position.z / top);
    }
    setup.fills = places::fills(&by_layer(lattice));
    let steps = (MIXING_TIME * unit_time() / step(&setup)) as u64;
    let mut simulation = silo::simulation(setup, 0);
    simulation.advance(steps).expect("it flows");
    by_layer(tiled(&places::of(&simulation), TILES, side))
}

fn step(setup: &Setup) -> f64 {
    match setup.step {
        StepRequest::Fixed(seconds) | StepRequest::Unchecked(seconds) => seconds,
        StepRequest::PeakForceError(_) => f64::NAN,
    }
}

/// Velocity at a share of the height of a steady flow [m/s] (Bagnold 1954).
fn bagnold(share: f64) -> f64 {
    let surface = SURFACE_VELOCITY * (GRAVITY * DIAMETER).sqrt();
    surface * (1.0 - (1.0 - share.clamp(0.0, 1.0)).powf(1.5))
}

/// Sorted by layers one diameter high, each pellet with the mean velocity of its layer.
fn by_layer(mut places: Vec<Place>) -> Vec<Place> {
    let layer = |place: &Place| (place.position.z / DIAMETER).floor() as i64;
    places.sort_by_key(layer);
    for alike in places.chunk_by_mut(|a, b| layer(a) == layer(b)) {
        let mean = alike.iter().map(|place| place.velocity).sum::<Vec3>() / alike.len() as f64;
        for place in alike {
            place.velocity = mean;
        }
    }
    places
}

/// A box's pellets over and over along x and y, with sides of the box in [m].
pub(crate) fn tiled(places: &[Place], tiles: [usize; 2], side: f64) -> Vec<Place> {
    let shifts = (0..tiles[0]).flat_map(|x| (0..tiles[1]).map(move |y| [x as f64, y as f64]));
    shifts
        .flat_map(|[x, y]| {
            let shift = side * Vec3::new(x, y, 0.0);
            places.iter().map(move |place| Place {
                position: place.position + shift,
                ..*place
            })
        })
        .collect()
}

/// What another code has to know of the slope.
pub(crate) fn describe(setup: &Setup) -> Value {
    let material = &setup.materials[0].material;
    let pair = MaterialPair::new(material, material, &setup.pairs[0].1);
    let effective_mass = setup.mass(0, DIAMETER / 2.0) / 2.0;
    let damping = 2.0 * pair.damping_ratio * (pair.linear_stiffness / effective_mass).sqrt();
    // Friction keeps Mindlin's share of the stiffness.
    let share = 4.0 * pair.effective_shear_modulus / pair.effective_youngs_modulus;
    let size = setup.domain.bounds.max - setup.domain.bounds.min;
    let balls: Vec<Vec<f64>> = balls(size)
        .iter()
        .map(|center| center.as_slice().to_vec())
        .collect();
    json!({
        "angle": ANGLE,
        "normal_stiffness": pair.linear_stiffness,
        "tangential_stiffness": share * pair.linear_stiffness,
        "normal_damping": damping,
        "tangential_damping": damping * pair.tangential_damping_share,
        "ball_density": material.density,
        "balls": balls,
        "shortest_contact": PI / (pair.linear_stiffness / effective_mass).sqrt(),
    })
}
