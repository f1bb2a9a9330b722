//! The paper's pellet and small setups to let it loose in.

#![allow(
    dead_code,
    unused_imports,
    clippy::allow_attributes,
    reason = "each test file uses its own share of these"
)]

mod held;
pub(crate) mod sheets;

pub(crate) use held::held;

use pelletflow::core::{Bounds, ContactLaws, Material, PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::sim::{
    Domain, Fill, Integrator, Limits, Model, Motion, NamedMaterial, NeighborSearch, PelletKind,
    PelletView, Schedule, Seats, Setup, Simulation, SizeDistribution, Skips, StepError,
    StepRequest, Wall, WallShape,
};

/// Radius of the paper's pellet [m].
pub(crate) const RADIUS: f64 = 7.5e-3;
/// Index of the pellet's material in [`setup`].
pub(crate) const ORE: usize = 0;
/// Index of the walls' material in [`setup`].
pub(crate) const STEEL: usize = 1;
/// Standard gravity, downward [m/s²].
pub(crate) const GRAVITY: Vec3 = Vec3::new(0.0, 0.0, -9.81);

/// A setup with the paper's pellet and steel, and nothing in it yet.
pub(crate) fn setup(pellets: PairProperties, walls: PairProperties) -> Setup {
    let named = |name: &str, material| NamedMaterial {
        name: name.into(),
        material,
        true_youngs_modulus: None,
    };
    Setup {
        seed: 1,
        gravity: Vec3::zeros(),
        materials: vec![
            named("ore", Material::from_shear_modulus(3700.0, 60.0e6, 0.22)),
            named("steel", Material::from_shear_modulus(7850.0, 81.0e9, 0.28)),
        ],
        pairs: vec![([ORE, ORE], pellets), ([ORE, STEEL], walls)],
        pellets: vec![PelletKind {
            name: "ore".into(),
            material: ORE,
            size: SizeDistribution::Single {
                diameter: 2.0 * RADIUS,
            },
        }],
        laws: ContactLaws::default(),
        walls: Vec::new(),
        fills: Vec::new(),
        inlets: Vec::new(),
        outlets: Vec::new(),
        meters: Vec::new(),
        domain: Domain::closed(Bounds {
            min: Vec3::repeat(-2.0),
            max: Vec3::repeat(2.0),
        }),
        integrator: Integrator::default(),
        step: StepRequest::PeakForceError(1.0e-3),
        search: NeighborSearch::Auto,
        skin: None,
        limits: Limits::default(),
        skips: Skips::default(),
        instructions: None,
        hits: None,
    }
}

/// Properties of a pair without friction.
pub(crate) fn smooth(restitution: f64) -> PairProperties {
    PairProperties {
        restitution,
        friction: 0.0,
        rolling_friction: 0.0,
        ..PairProperties::ELASTIC
    }
}

/// A steel wall that stays.
pub(crate) fn wall(name: &str, shape: impl Into<WallShape>) -> Wall {
    Wall {
        name: name.into(),
        material: STEEL,
        shape: shape.into(),
        motion: Motion::Fixed,
        surface_velocity: Vec3::zeros(),
        schedule: Schedule::always(),
    }
}

/// A floor through the origin, its normal turned from the vertical by an angle about the y axis [rad].
pub(crate) fn floor(angle: f64) -> Shape {
    Shape::HalfSpace {
        point: Vec3::zeros(),
        normal: UnitVector3::new_normalize(Vec3::new(angle.sin(), 0.0, angle.cos())),
    }
}

/// A tube about the vertical axis, by its radii and half its length; its bore goes on beyond its ends [m].
pub(crate) fn tube([inner, outer]: [f64; 2], half_length: f64) -> Shape {
    let cylinder = |radius: f64, half_length: f64| {
        Box::new(Shape::Cylinder {
            radius,
            half_length,
        })
    };
    Shape::Difference {
        of: cylinder(outer, half_length),
        minus: cylinder(inner, half_length + 0.1),
    }
}

/// One pellet of the first kind at a place, with a velocity.
pub(crate) fn one(name: &str, position: Vec3, velocity: Vec3) -> Fill {
    Fill {
        name: name.into(),
        pellets: 0,
        seats: Seats::Points(vec![position]),
        velocity,
        spin: Vec3::zeros(),
    }
}

/// A simulation on one thread, of a setup without mistakes.
pub(crate) fn simulation(setup: Setup) -> Simulation {
    simulation_on(setup, 1)
}

/// A simulation on a number of threads, of a setup without mistakes.
pub(crate) fn simulation_on(setup: Setup, threads: usize) -> Simulation {
    let model = Model::new(setup).expect("the setup has no mistakes");
    Simulation::new(model, threads).expect("the fills fit")
}

/// Runs up to a time [s], or until the run fails.
pub(crate) fn run_until(simulation: &mut Simulation, time: f64) -> Result<(), StepError> {
    let steps = (time - simulation.time()) / simulation.model().time_step().seconds;
    simulation.advance(steps.round() as u64)
}

/// Asserts that a run ends in the same state for any number of threads and any search, distant walls skipped or not.
///
/// `run` takes the search, the threads, and whether distant walls are skipped, and gives a hash of the state.
pub(crate) fn assert_same_bits(run: impl Fn(NeighborSearch, usize, bool) -> String) {
    let first = run(NeighborSearch::Grid, 1, true);
    for (search, threads, distant_walls) in [
        (NeighborSearch::Grid, 3, true),
        (NeighborSearch::Tree, 2, true),
        (NeighborSearch::AllPairs, 1, false),
    ] {
        assert_eq!(run(search, threads, distant_walls), first, "{search:?}");
    }
}

/// The pellet with a number.
pub(crate) fn pellet(simulation: &Simulation, id: u32) -> PelletView {
    simulation
        .pellets()
        .find(|pellet| pellet.id == id)
        .expect("the pellet is inside")
}
