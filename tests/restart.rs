//! A simulation restored from a snapshot goes on as if nothing had happened, to the last bit.

mod common;

use common::{GRAVITY, ORE, RADIUS, floor, setup, sheets, simulation_on, tube, wall};
use pelletflow::core::contact::{ContactLaws, NormalLaw, TangentialLaw, TurningLaw};
use pelletflow::core::{Bounds, PairProperties, Shape, Vec3};
use pelletflow::sim::{
    Domain, Fill, FillAmount, Heap, HitRequest, Inlet, MassFlow, Meter, MeterKind, Model, Motion,
    Outlet, PelletKind, PlaneFlow, Rate, Region, Residence, RestoreError, Schedule, Seats, Setup,
    Simulation, SizeDistribution, Snapshot, WallForce, WallImpacts, Wear,
};

/// Steps taken at once, as a recorded run does.
const STRIDE: u64 = 16;

const ROUGH: PairProperties = PairProperties {
    restitution: 0.5,
    friction: 0.5,
    rolling_friction: 0.1,
    stiffness: Some(2.0e5),
    yield_pressure: Some(5.0e6),
    surface_energy: Some(0.5),
    ..PairProperties::ELASTIC
};

/// Two beds thrown into a ring, a feeder, an outlet, a floor of triangles, a paddle that turns, a lid that opens: pellets
/// come and go, every meter reads, and hits are followed.
fn plant(laws: ContactLaws) -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    setup.laws = laws;
    setup.pellets.push(PelletKind {
        name: "fines".into(),
        material: ORE,
        size: SizeDistribution::Uniform {
            min_diameter: 0.010,
            max_diameter: 0.014,
        },
    });
    let ring = tube([0.11, 0.2], 0.3);
    let plate = |size: Vec3, height: f64| {
        Shape::Cuboid {
            half_sides: size / 2.0,
        }
        .translated(height * Vec3::z())
    };
    let mut paddle = wall("paddle", plate(Vec3::new(0.16, 0.008, 0.02), 0.02));
    paddle.motion = Motion::Rotating {
        center: Vec3::zeros(),
        axis: Vec3::z_axis(),
        rate: 8.0,
        start: 0.0,
        end: f64::INFINITY,
    };
    let mut lid = wall("lid", plate(Vec3::new(0.22, 0.22, 0.004), 0.17));
    lid.schedule = Schedule::opening_at(vec![0.06]);
    setup.walls = vec![
        wall("floor", sheets::square(0.5, 20)),
        wall("ring", ring),
        paddle,
        lid,
    ];
    let bed = |name: &str, pellets: usize, height: f64| Fill {
        name: name.into(),
        pellets,
        seats: Seats::Lattice {
            region: Shape::Cylinder {
                radius: 0.09,
                half_length: 0.05,
            }
            .translated(height * Vec3::z()),
            amount: FillAmount::Count(90),
        },
        velocity: -Vec3::z(),
        spin: Vec3::new(3.0, 0.0, 1.0),
    };
    setup.fills = vec![bed("coarse", 0, 0.1), bed("fine", 1, 0.24)];
    setup.inlets = vec![Inlet {
        name: "feed".into(),
        pellets: 1,
        region: Shape::Cuboid {
            half_sides: Vec3::new(0.06, 0.06, 0.03),
        }
        .translated(0.45 * Vec3::z()),
        rate: Rate::Mass(1.0),
        velocity: -2.0 * Vec3::z(),
        start: 0.0,
        end: f64::INFINITY,
    }];
    setup.outlets = vec![Outlet {
        name: "side".into(),
        region: Shape::Sphere { radius: 0.05 }.translated(Vec3::new(0.08, 0.0, 0.03)),
    }];
    setup.meters = meters();
    setup.hits = Some(HitRequest { threshold: 2.0 });
    setup.limits.energy_residual = 1.0;
    setup
}

/// One of each kind.
fn meters() -> Vec<Meter> {
    let kinds = [
        MeterKind::MassFlow(MassFlow { outlet: 0 }),
        MeterKind::PlaneFlow(PlaneFlow {
            point: 0.2 * Vec3::z(),
            normal: Vec3::z_axis(),
            radius: f64::INFINITY,
        }),
        MeterKind::WallForce(WallForce {
            wall: 2,
            about: Vec3::zeros(),
        }),
        MeterKind::WallImpacts(WallImpacts {
            wall: 0,
            cell: 0.05,
            least_speed: 0.05,
        }),
        MeterKind::Wear(Wear {
            wall: 0,
            cell: 0.05,
            archard: 1.0e-13,
            finnie: 1.0e-10,
            least_speed: 0.05,
        }),
        MeterKind::Region(Region {
            bounds: Bounds::about_origin(Vec3::repeat(0.1)),
        }),
        MeterKind::Residence(Residence),
        MeterKind::Heap(Heap {
            point: Vec3::zeros(),
            up: Vec3::z_axis(),
        }),
    ];
    let named = kinds.into_iter().map(|kind| Meter {
        name: kind.name().into(),
        kind,
    });
    named.collect()
}

/// Pellets that drift through a box without walls, and meet across its borders.
fn gas() -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.domain = Domain {
        bounds: Bounds::about_origin(Vec3::repeat(0.08)),
        is_periodic: [true; 3],
    };
    let half = |name: &str, side: f64| Fill {
        name: name.into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::new(0.03, 0.07, 0.07),
            }
            .translated(side * 0.035 * Vec3::x()),
            amount: FillAmount::Count(60),
        },
        velocity: Vec3::new(-3.0 * side, 1.0, 0.4),
        spin: Vec3::zeros(),
    };
    setup.fills = vec![half("left", -1.0), half("right", 1.0)];
    setup
}

/// A few pellets that fall a long way onto a floor: many steps at once.
fn fall() -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.1))];
    setup.fills = vec![Fill {
        name: "few".into(),
        pellets: 0,
        seats: Seats::Points(vec![
            Vec3::new(0.0, 0.0, 0.5),
            Vec3::new(6.0 * RADIUS, 0.0, 0.55),
        ]),
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    setup
}

fn advance(simulation: &mut Simulation, strides: u64) {
    for _ in 0..strides {
        simulation.advance(STRIDE).expect("the scene is sound");
    }
}

/// All bits that a restart needs; of equal bytes every further step is equal.
fn bytes(simulation: &Simulation) -> Vec<u8> {
    postcard::to_stdvec(&simulation.snapshot()).expect("a snapshot is plain data")
}

fn restored(setup: &Setup, threads: usize, bytes: &[u8]) -> Simulation {
    let snapshot: Snapshot = postcard::from_bytes(bytes).expect("it was written by the same code");
    let model = Model::new(setup.clone()).expect("the setup has no mistakes");
    Simulation::restore(model, threads, snapshot).expect("it is the same model")
}

/// Holds a scene to its claim: from snapshots after each part of the run, on any number of threads.
fn assert_restarts(setup: &Setup, parts: &[u64]) {
    let mut unbroken = simulation_on(setup.clone(), 1);
    let mut snapshots = vec![bytes(&unbroken)];
    for &strides in parts {
        advance(&mut unbroken, strides);
        snapshots.push(bytes(&unbroken));
    }
    let end = bytes(&unbroken);
    let mut left: u64 = parts.iter().sum();
    for (index, snapshot) in snapshots.iter().enumerate() {
        for threads in [1, 2, 4] {
            let mut again = restored(setup, threads, snapshot);
            assert!(
                bytes(&again) == *snapshot,
                "snapshot {index} is lost in restoring"
            );
            advance(&mut again, left);
            assert_eq!(again.state_hash(), unbroken.state_hash());
            assert_eq!(again.state().hits, unbroken.state().hits);
            assert_eq!(again.meter_readings(), unbroken.meter_readings());
            assert_eq!(again.skipped(), unbroken.skipped());
            assert!(
                bytes(&again) == end,
                "after snapshot {index} on {threads} threads some bit differs"
            );
        }
        left -= parts.get(index).copied().unwrap_or(0);
    }
}

#[test]
fn a_plant_goes_on_after_any_snapshot_as_if_nothing_had_happened() {
    let setup = plant(ContactLaws::default());
    let mut run = simulation_on(setup.clone(), 1);
    advance(&mut run, 300);
    let ledger = run.mass_ledger();
    assert!(
        ledger.discharged.count > 3 && ledger.by_inlet[0].count > 3,
        "pellets come and go"
    );
    assert!(run.state().hits.rows().len() > 20, "hits are kept");
    assert!(run.walls().any(|wall| !wall.is_present), "the lid is open");
    assert_restarts(&setup, &[1, 37, 62, 200]);
}

#[test]
fn contacts_of_every_law_go_on_with_all_that_they_remember() {
    let history = ContactLaws {
        normal: NormalLaw::Plastic,
        tangential: TangentialLaw::PartialSlip,
        rolling: TurningLaw::SpringDashpot,
        twisting: TurningLaw::SpringDashpot,
    };
    let sticky = ContactLaws {
        normal: NormalLaw::Jkr,
        ..ContactLaws::default()
    };
    for laws in [history, sticky] {
        assert_restarts(&plant(laws), &[90, 60]);
    }
}

#[test]
fn a_gas_across_borders_goes_on_as_if_nothing_had_happened() {
    assert_restarts(&gas(), &[40, 41, 80]);
}

#[test]
fn a_free_fall_goes_on_with_its_count_of_free_steps() {
    let mut run = simulation_on(fall(), 1);
    advance(&mut run, 400);
    assert!(
        run.skipped()
            .iter()
            .any(|skipped| skipped.what == "contacts in free flight")
    );
    assert_restarts(&fall(), &[50, 350, 700]);
}

#[test]
fn a_snapshot_of_another_scene_is_refused_with_a_reason() {
    let snapshot = bytes(&simulation_on(gas(), 1));
    let snapshot: Snapshot = postcard::from_bytes(&snapshot).expect("it was just written");
    let model = Model::new(fall()).expect("the setup has no mistakes");
    let error = Simulation::restore(model, 1, snapshot).expect_err("a gas is no fall");
    assert!(matches!(error, RestoreError::Misfit(_)));
    assert!(error.to_string().contains("walls"), "{error}");
}
