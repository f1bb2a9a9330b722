//! The settled silo of the peer comparison: one step of a dense bed at rest.
//!
//! A cylinder of radius 150 mm over a 60° cone with an outlet of radius 60 mm, closed; 15 mm pellets settled by
//! 20,000 steps. Reports particle-steps per second on one and two threads.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::core::contact::RollingLaw;
use pelletflow::core::{
    Bounds, ContactLaws, Material, PairProperties, Profile, Shape, UnitVector3, Vec3,
};
use pelletflow::sim::{
    Domain, Fill, FillAmount, Limits, Model, Motion, NamedMaterial, NeighborSearch, PelletKind,
    Schedule, Seats, Setup, Simulation, SizeDistribution, Skips, StepRequest, Wall,
};

const DIAMETER: f64 = 0.015;
const OUTLET_RADIUS: f64 = 0.06;
/// Steps advanced at a time: enough to hold a fair share of neighbor searches.
const STEPS: u64 = 100;

fn wall(name: &str, shape: Shape) -> Wall {
    Wall {
        name: name.into(),
        material: 0,
        shape,
        motion: Motion::Fixed,
        surface_velocity: Vec3::zeros(),
        schedule: Schedule::always(),
    }
}

/// The silo, filled with a number of pellets on a lattice, its radius in [m].
fn silo(pellets: usize, radius: f64) -> Setup {
    let cone_height = (radius - OUTLET_RADIUS) * 3.0_f64.sqrt();
    let top = cone_height + 4.0;
    let hopper = Profile::Closed {
        corners: vec![
            [OUTLET_RADIUS, 0.0],
            [radius, cone_height],
            [radius, top],
            [radius + 0.02, top],
            [radius + 0.02, 0.0],
        ],
    };
    let floor = Shape::HalfSpace {
        point: Vec3::zeros(),
        normal: UnitVector3::new_unchecked(Vec3::z()),
    };
    Setup {
        seed: 1,
        gravity: Vec3::new(0.0, 0.0, -9.81),
        materials: vec![NamedMaterial {
            name: "ore".into(),
            material: Material {
                density: 3700.0,
                youngs_modulus: 1.464e8,
                poisson_ratio: 0.22,
            },
        }],
        pairs: vec![(
            [0, 0],
            PairProperties {
                restitution: 0.5,
                friction: 0.5,
                rolling_friction: 0.0,
            },
        )],
        pellets: vec![PelletKind {
            name: "ore".into(),
            material: 0,
            size: SizeDistribution::Single { diameter: DIAMETER },
        }],
        laws: ContactLaws {
            rolling: RollingLaw::None,
            ..ContactLaws::default()
        },
        walls: vec![
            wall("hopper", Shape::Revolution { profile: hopper }),
            wall("floor", floor),
        ],
        fills: vec![Fill {
            name: "bed".into(),
            pellets: 0,
            seats: Seats::Lattice {
                region: Shape::Cylinder {
                    radius: radius - 1.0e-3,
                    half_length: 1.9,
                }
                .translated(Vec3::new(0.0, 0.0, cone_height + 1.95)),
                amount: FillAmount::Count(pellets),
            },
            velocity: Vec3::zeros(),
            spin: Vec3::zeros(),
        }],
        inlets: Vec::new(),
        outlets: Vec::new(),
        meters: Vec::new(),
        domain: Domain {
            bounds: Bounds {
                min: Vec3::new(-0.5, -0.5, -0.3),
                max: Vec3::new(0.5, 0.5, top),
            },
        },
        step: StepRequest::Fixed(2.0e-5),
        search: NeighborSearch::Auto,
        skin: Some(0.1 * DIAMETER),
        limits: Limits::default(),
        skips: Skips::default(),
    }
}

/// The silo settled, on a number of threads.
fn settled(pellets: usize, radius: f64, threads: usize) -> Simulation {
    let model = Model::new(silo(pellets, radius)).expect("the silo is sound");
    let mut simulation = Simulation::new(model, threads).expect("the bed fits");
    simulation.advance(20_000).expect("the bed settles");
    simulation
}

fn settled_silo(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("settled-silo");
    group.sample_size(20);
    for threads in [1, 2] {
        let mut simulation = settled(10_000, 0.15, threads);
        group.throughput(Throughput::Elements(10_000 * STEPS));
        group.bench_function(format!("10k/{threads}-threads"), |bencher| {
            bencher.iter(|| simulation.advance(STEPS).expect("the bed rests"));
        });
    }
    group.finish();
}

criterion_group!(benches, settled_silo);
criterion_main!(benches);
