//! A small hopper with a gate, run and recorded.

#![allow(
    dead_code,
    clippy::allow_attributes,
    reason = "each test file uses its own share of these"
)]

use pelletflow_core::shape::Profile;
use pelletflow_core::{
    Bounds, ContactLaws, Material, PairProperties, Shape, UnitQuaternion, UnitVector3, Vec3,
};
use pelletflow_log::{Progress, RunError, RunRequest, Summary, run};
use pelletflow_sim::{
    Domain, Fill, FillAmount, Integrator, KeptFrames, Limits, MassFlow, Meter, MeterKind, Model,
    Motion, NamedMaterial, NeighborSearch, Outlet, PelletKind, RunPlan, Schedule, Seats, Setup,
    Simulation, SizeDistribution, Skips, StepRequest, Wall, WallForce,
};
use std::ops::ControlFlow;
use std::path::Path;

pub(crate) const SCENE_TEXT: &str = "schema_version = 1\n# a hopper\n";
pub(crate) const GATE_OPENS: f64 = 0.05;

/// Pellets fall into a hopper, whose gate opens, and a paddle turns above it.
pub(crate) fn setup(pellets: usize) -> Setup {
    let named = |name: &str, shear_modulus: f64, density: f64| NamedMaterial {
        name: name.into(),
        material: Material::from_shear_modulus(density, shear_modulus, 0.25),
        true_youngs_modulus: None,
    };
    let pair = PairProperties {
        restitution: 0.5,
        friction: 0.4,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    Setup {
        seed: 7,
        gravity: Vec3::new(0.0, 0.0, -9.81),
        materials: vec![
            named("pellet", 6.0e7, 3700.0),
            named("steel", 1.0e9, 7800.0),
        ],
        pairs: vec![([0, 0], pair), ([0, 1], pair)],
        pellets: vec![PelletKind {
            name: "pellet".into(),
            material: 0,
            size: SizeDistribution::Single { diameter: 0.015 },
        }],
        laws: ContactLaws::default(),
        walls: walls(),
        fills: vec![Fill {
            name: "heap".into(),
            pellets: 0,
            seats: Seats::Lattice {
                region: Shape::Cylinder {
                    radius: 0.10,
                    half_length: 0.10,
                }
                .translated(Vec3::new(0.0, 0.0, 0.14)),
                amount: FillAmount::Count(pellets),
            },
            velocity: Vec3::zeros(),
            spin: Vec3::zeros(),
        }],
        inlets: Vec::new(),
        outlets: vec![Outlet {
            name: "below".into(),
            region: Shape::HalfSpace {
                point: Vec3::new(0.0, 0.0, -0.15),
                normal: Vec3::z_axis(),
            },
        }],
        meters: vec![
            Meter {
                name: "outflow".into(),
                kind: MeterKind::MassFlow(MassFlow { outlet: 0 }),
            },
            Meter {
                name: "cone-load".into(),
                kind: MeterKind::WallForce(WallForce {
                    wall: 0,
                    about: Vec3::zeros(),
                }),
            },
        ],
        domain: Domain::closed(Bounds {
            min: Vec3::new(-0.3, -0.3, -0.3),
            max: Vec3::new(0.3, 0.3, 0.4),
        }),
        integrator: Integrator::default(),
        step: StepRequest::PeakForceError(0.01),
        search: NeighborSearch::Auto,
        skin: None,
        // Whether the engine's books close is tested where they are kept.
        limits: Limits {
            energy_residual: 1.0,
            ..Limits::default()
        },
        skips: Skips::default(),
        instructions: None,
        hits: None,
    }
}

fn walls() -> Vec<Wall> {
    let wall = |name: &str, shape: Shape| Wall {
        name: name.into(),
        material: 1,
        shape: shape.into(),
        motion: Motion::Fixed,
        surface_velocity: Vec3::zeros(),
        schedule: Schedule::always(),
    };
    vec![
        wall(
            "cone",
            Shape::Revolution {
                profile: Profile::Plate {
                    corners: vec![[0.05, -0.1], [0.05, -0.05], [0.13, 0.03], [0.13, 0.26]],
                    thickness: 0.004,
                },
            },
        ),
        Wall {
            schedule: Schedule::opening_at(vec![GATE_OPENS]),
            ..wall(
                "gate",
                Shape::Cuboid {
                    half_sides: Vec3::new(0.08, 0.08, 0.003),
                }
                .translated(Vec3::new(0.0, 0.0, -0.106)),
            )
        },
        Wall {
            motion: Motion::Rotating {
                center: Vec3::new(0.0, 0.0, 0.32),
                axis: UnitVector3::new_normalize(Vec3::z()),
                rate: 6.0,
                start: 0.0,
                end: f64::INFINITY,
            },
            ..wall(
                "paddle",
                Shape::Cuboid {
                    half_sides: Vec3::new(0.1, 0.004, 0.02),
                }
                .rotated(UnitQuaternion::from_euler_angles(0.3, 0.0, 0.0))
                .translated(Vec3::new(0.0, 0.0, 0.32)),
            )
        },
    ]
}

pub(crate) fn simulation(setup: Setup) -> Simulation {
    let model = Model::new(setup).expect("the hopper is a right setup");
    Simulation::new(model, 1).expect("the pellets fit into the hopper")
}

pub(crate) fn plan(end_time: f64) -> RunPlan {
    RunPlan {
        end_time,
        stop: Vec::new(),
        frame_interval: 0.01,
        kept_frames: KeptFrames::default(),
        meter_interval: 0.005,
        checkpoint_interval: f64::INFINITY,
    }
}

/// Runs into a directory, calling an observer.
pub(crate) fn run_into(
    directory: &Path,
    setup: Setup,
    plan: &RunPlan,
    spheres_up_to: usize,
    observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    let request = RunRequest {
        directory,
        scene_name: "hopper",
        scene_title: "A small hopper",
        scene_text: SCENE_TEXT,
        scene_hash: "0123",
        scene_files: &[],
        plan,
        spheres_up_to,
        contacts: true,
        live: None,
    };
    run(&mut simulation(setup), &request, observer)
}

/// Runs to the end.
pub(crate) fn record(directory: &Path, end_time: f64) -> Summary {
    run_into(directory, setup(60), &plan(end_time), 1000, &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("the hopper runs to its end")
}
