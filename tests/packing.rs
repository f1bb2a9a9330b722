//! Beds at the start: no overlap, the amount asked for, and how soon they are at rest.

mod common;

use common::{GRAVITY, floor, setup, simulation_on, wall};
use pelletflow::core::{PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::sim::{Fill, FillAmount, Model, Seats, Setup, Simulation, SizeDistribution};
use proptest::prelude::*;

/// Side of the square bin [m].
const SIDE: f64 = 0.12;

/// A bin with a bed of a mass [kg].
fn bin(size: SizeDistribution, seats: impl Fn(Shape, FillAmount) -> Seats, mass: f64) -> Setup {
    let pair = PairProperties {
        restitution: 0.4,
        friction: 0.5,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(pair, pair);
    setup.gravity = GRAVITY;
    setup.pellets[0].size = size;
    setup.walls = vec![wall("floor", floor(0.0))];
    for axis in 0..2 {
        for sign in [-1.0, 1.0] {
            let mut outward = Vec3::zeros();
            outward[axis] = sign;
            let plane = Shape::HalfSpace {
                point: 0.5 * SIDE * outward,
                normal: UnitVector3::new_normalize(-outward),
            };
            setup.walls.push(wall(&format!("{axis} {sign}"), plane));
        }
    }
    let half_sides = Vec3::new(0.4999 * SIDE, 0.4999 * SIDE, 0.8);
    let region = Shape::Cuboid { half_sides }.translated(0.8001 * Vec3::z());
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: seats(region, FillAmount::Mass(mass)),
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    setup
}

fn lattice(region: Shape, amount: FillAmount) -> Seats {
    Seats::Lattice { region, amount }
}

fn deposit(region: Shape, amount: FillAmount) -> Seats {
    Seats::Deposit { region, amount }
}

/// Share of the bin's volume that is pellet, in the middle half of the bed's height [-].
fn filling(simulation: &Simulation) -> f64 {
    let top = simulation
        .pellets()
        .map(|pellet| pellet.position.z + pellet.radius)
        .fold(0.0, f64::max);
    let (low, high) = (0.25 * top, 0.75 * top);
    let volume: f64 = simulation
        .pellets()
        .map(|pellet| {
            let height = |z: f64| (z - pellet.position.z).clamp(-pellet.radius, pellet.radius);
            let below = |h: f64| pellet.radius.powi(2) * h - h.powi(3) / 3.0;
            std::f64::consts::PI * (below(height(high)) - below(height(low)))
        })
        .sum();
    volume / (SIDE * SIDE * (high - low))
}

/// Time until the pellets' root mean square speed stays below 5 mm/s [s].
fn settling_time(simulation: &mut Simulation) -> f64 {
    let steps = (2.0e-3 / simulation.model().time_step().seconds) as u64;
    let mut quiet = 0;
    while quiet < 5 {
        simulation.advance(steps).expect("it settles");
        let square: f64 = simulation
            .pellets()
            .map(|pellet| pellet.velocity.norm_squared())
            .sum();
        let speed = (square / simulation.pellet_count() as f64).sqrt();
        quiet = if speed < 5.0e-3 { quiet + 1 } else { 0 };
    }
    simulation.time() - 5.0 * 2.0e-3
}

/// Screened ore from 5 mm to 15 mm.
fn screened() -> SizeDistribution {
    SizeDistribution::Sieve {
        openings: vec![0.005, 0.010, 0.015],
        passing: vec![0.0, 0.5, 1.0],
    }
}

/// Filling at the start [-] and settling time [s] of a bed.
fn bed(
    size: SizeDistribution,
    seats: impl Fn(Shape, FillAmount) -> Seats,
    mass: f64,
) -> (f64, f64) {
    let mut simulation = simulation_on(bin(size, seats, mass), 1);
    (filling(&simulation), settling_time(&mut simulation))
}

#[test]
fn a_deposit_starts_denser_than_a_lattice_and_settles_sooner() {
    // Settled, these beds fill 0.51 to 0.6 of the bin.
    let (loose, late) = bed(SizeDistribution::Single { diameter: 0.012 }, lattice, 2.0);
    let (dense, soon) = bed(SizeDistribution::Single { diameter: 0.012 }, deposit, 2.0);
    assert!(dense > 1.15 * loose && dense > 0.47, "{dense}, {loose}");
    assert!(soon < 0.8 * late, "{soon} s, {late} s");
    // A lattice as wide as the largest pellet is mostly air where most are small.
    let (loose, late) = bed(screened(), lattice, 1.0);
    let (dense, soon) = bed(screened(), deposit, 1.0);
    assert!(dense > 5.0 * loose && dense > 0.5, "{dense}, {loose}");
    assert!(soon < 0.6 * late, "{soon} s, {late} s");
}

proptest! {
    // Each is a bed of some hundred pellets.
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn any_bed_starts_without_overlap_inside_its_region_and_weighs_what_was_asked(
        seed in any::<u64>(),
        [min, max] in [0.005..0.015, 0.005..0.015_f64].prop_map(|[one, other]| [one.min(other), one.max(other)]),
        mass in 0.02..0.4,
        is_deposit in any::<bool>(),
        gravity in [-10.0..10.0, -10.0..10.0, -10.0..10.0_f64],
    ) {
        let seats = if is_deposit { deposit } else { lattice };
        let mut setup = bin(SizeDistribution::Uniform { min_diameter: min, max_diameter: max }, seats, mass);
        setup.seed = seed;
        setup.gravity = Vec3::from(gravity);
        let simulation = simulation_on(setup, 1);
        let pellets: Vec<_> = simulation.pellets().collect();
        let weighed: f64 = pellets.iter().map(|pellet| pellet.mass).sum();
        let largest = pellets.iter().map(|pellet| pellet.mass).fold(0.0, f64::max);
        // Up to the next whole pellet, and the rounding of a sum.
        prop_assert!(weighed > 0.999_999 * mass && weighed < mass + largest, "{weighed} of {mass}");
        for (index, a) in pellets.iter().enumerate() {
            for b in &pellets[..index] {
                let gap = (a.position - b.position).norm() - a.radius - b.radius;
                prop_assert!(gap > 0.0, "{gap}");
            }
            let inside = 0.5 * SIDE - a.radius;
            prop_assert!(a.position.x.abs() < inside && a.position.y.abs() < inside);
            prop_assert!(a.position.z > a.radius);
        }
        prop_assert_eq!(simulation.contact_statistics().open, 0);
    }
}

#[test]
fn a_region_too_small_for_a_deposit_tells_what_it_holds() {
    let setup = bin(screened(), deposit, 60.0);
    let model = Model::new(setup).expect("the setup itself is sound");
    let errors = Simulation::new(model, 1).expect_err("60 kg do not fit");
    let told = errors[0].to_string();
    // 1.6 m of a square of 0.12 m, half of it pellet of 3700 kg/m³, are 43 kg.
    let (_, held) = told.split_once(" pellets (").expect("it tells the mass");
    let held = held
        .split_once(" kg)")
        .and_then(|(held, _)| held.parse::<f64>().ok());
    assert!(
        held.is_some_and(|held| (40.0..50.0).contains(&held)),
        "{told}"
    );
    assert!(
        told.contains("60 kg were asked for; enlarge the region"),
        "{told}"
    );
}
