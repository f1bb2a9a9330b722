//! The silo of the peer comparison: a cylinder over a 60° cone with an outlet of radius 60 mm, closed by a floor.

use pelletflow::core::contact::TurningLaw;
use pelletflow::core::{
    Bounds, ContactLaws, Material, PairProperties, Profile, Shape, UnitVector3, Vec3,
};
use pelletflow::sim::{
    Domain, Fill, FillAmount, Integrator, Limits, Model, Motion, NamedMaterial, NeighborSearch,
    PelletKind, Schedule, Seats, Setup, Simulation, SizeDistribution, Skips, StepRequest, Wall,
};

/// Diameter of the pellets [m].
pub(crate) const DIAMETER: f64 = 0.015;
/// Radius of the outlet [m].
pub(crate) const OUTLET_RADIUS: f64 = 0.06;
/// Greatest depth of a bed above the cone [m].
const HIGHEST_BED: f64 = 3.8;
/// Time step, a tenth of the Rayleigh time [s].
pub(crate) const TIME_STEP: f64 = 2.0e-5;

fn wall(name: &str, shape: Shape) -> Wall {
    Wall {
        name: name.into(),
        material: 0,
        shape: shape.into(),
        motion: Motion::Fixed,
        surface_velocity: Vec3::zeros(),
        schedule: Schedule::always(),
    }
}

/// The silo, filled with a number of pellets on a lattice, its radius in [m].
pub(crate) fn silo(pellets: usize, radius: f64) -> Setup {
    let cone_height = cone_height(radius);
    let top = cone_height + HIGHEST_BED + 0.2;
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
            true_youngs_modulus: None,
        }],
        pairs: vec![(
            [0, 0],
            PairProperties {
                restitution: 0.5,
                friction: 0.5,
                rolling_friction: 0.0,
                ..PairProperties::ELASTIC
            },
        )],
        pellets: vec![PelletKind {
            name: "ore".into(),
            material: 0,
            size: SizeDistribution::Single { diameter: DIAMETER },
        }],
        laws: ContactLaws {
            rolling: TurningLaw::None,
            twisting: TurningLaw::None,
            ..ContactLaws::default()
        },
        walls: vec![
            wall("hopper", Shape::Revolution { profile: hopper }),
            wall("floor", floor),
        ],
        fills: vec![Fill {
            name: "bed".into(),
            pellets: 0,
            seats: Seats::Deposit {
                region: hollow(radius),
                amount: FillAmount::Count(pellets),
            },
            velocity: Vec3::zeros(),
            spin: Vec3::zeros(),
        }],
        inlets: Vec::new(),
        outlets: Vec::new(),
        meters: Vec::new(),
        domain: Domain::closed(Bounds {
            min: Vec3::new(-0.5, -0.5, -0.3),
            max: Vec3::new(0.5, 0.5, top),
        }),
        integrator: Integrator::default(),
        step: StepRequest::Fixed(TIME_STEP),
        search: NeighborSearch::Auto,
        skin: Some(0.1 * DIAMETER),
        limits: Limits::default(),
        skips: Skips::default(),
        instructions: None,
        hits: None,
    }
}

/// Height of the 60° cone under a cylinder of a radius [m]; in [m].
pub(crate) fn cone_height(radius: f64) -> f64 {
    (radius - OUTLET_RADIUS) * 3.0_f64.sqrt()
}

/// What is hollow of the silo up to a height at which the bed ends [m].
pub(crate) fn hollow(radius: f64) -> Shape {
    let cone_height = cone_height(radius);
    let top = cone_height + HIGHEST_BED;
    Shape::Revolution {
        profile: Profile::Closed {
            corners: vec![
                [0.0, 0.0],
                [OUTLET_RADIUS, 0.0],
                [radius, cone_height],
                [radius, top],
                [0.0, top],
            ],
        },
    }
}

/// A simulation of a setup without mistakes, on a number of threads.
pub(crate) fn simulation(setup: Setup, threads: usize) -> Simulation {
    let model = Model::new(setup).expect("the scene is sound");
    Simulation::new(model, threads).expect("the pellets fit")
}
