//! Meters against what is known.

#[path = "../common/mod.rs"]
mod common;
mod flow;
mod heap;
mod walls;

use common::{GRAVITY, RADIUS, floor, one, setup, simulation_on, wall};
use pelletflow::core::{Bounds, PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::sim::{
    Fill, FillAmount, Heap, MassFlow, Meter, MeterKind, Outlet, PlaneFlow, Region, Residence,
    Seats, Setup, Simulation, StepRequest, WallForce,
};
use std::f64::consts::PI;
use walls::{impacts_on, wear};

/// Magnitude of gravity [m/s²].
const G: f64 = 9.81;

fn meter(kind: MeterKind) -> Meter {
    Meter {
        name: kind.name().into(),
        kind,
    }
}

/// One value of the only meter.
fn value(simulation: &Simulation, quantity: &str) -> f64 {
    let reading = simulation.meter_readings().remove(0);
    let found = reading.values.iter().find(|(name, _)| *name == quantity);
    found.expect("the meter reads this quantity").1
}

/// One column of the patches of the only meter, the worst first.
fn column(simulation: &Simulation, quantity: &str) -> Vec<f64> {
    let (_, table) = simulation.patch_tables().remove(0);
    let place = table.columns.iter().position(|name| *name == quantity);
    let place = place.expect("the meter keeps this quantity");
    table.rows.iter().map(|row| row[place]).collect()
}

fn advance_until(simulation: &mut Simulation, time: f64) {
    let step = simulation.model().time_step().seconds;
    let steps = ((time - simulation.time()) / step).round() as u64;
    simulation.advance(steps).expect("the scene is sound");
}

fn mass() -> f64 {
    3700.0 * 4.0 / 3.0 * PI * RADIUS.powi(3)
}

/// A bed that flows down a chute, with a meter of every kind.
fn busy_scene() -> Setup {
    let rough = PairProperties {
        restitution: 0.5,
        friction: 0.3,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(rough, rough);
    setup.gravity = GRAVITY;
    setup.step = StepRequest::PeakForceError(1.0e-2);
    setup.walls = vec![wall("chute", floor(0.4))];
    setup.fills = vec![Fill {
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::new(0.15, 0.15, 0.06),
            }
            .translated(0.2 * Vec3::z()),
            amount: FillAmount::Count(1000),
        },
        ..one("bed", Vec3::zeros(), Vec3::zeros())
    }];
    setup.outlets = vec![Outlet {
        name: "end".into(),
        region: Shape::HalfSpace {
            point: Vec3::new(0.25, 0.0, 0.0),
            normal: -Vec3::x_axis(),
        },
    }];
    setup.meters = [
        MeterKind::MassFlow(MassFlow { outlet: 0 }),
        MeterKind::PlaneFlow(PlaneFlow {
            point: 0.2 * Vec3::x(),
            normal: UnitVector3::new_normalize(Vec3::new(1.0, 0.0, -0.4)),
            radius: 0.2,
        }),
        MeterKind::WallForce(WallForce {
            wall: 0,
            about: Vec3::x(),
        }),
        impacts_on(0),
        wear(1.0e-12, 1.0e-11),
        MeterKind::Region(Region {
            bounds: Bounds::about_origin(Vec3::repeat(0.2)),
        }),
        MeterKind::Residence(Residence),
        MeterKind::Heap(Heap {
            point: -0.1 * Vec3::z(),
            up: Vec3::z_axis(),
        }),
    ]
    .map(meter)
    .into();
    assert_eq!(
        setup.meters.len(),
        MeterKind::NAMES.len(),
        "a meter of every kind"
    );
    setup
}

#[test]
fn no_reading_depends_on_the_number_of_threads() {
    let run = |threads| {
        let mut simulation = simulation_on(busy_scene(), threads);
        while simulation.mass_ledger().discharged.count < 100 {
            simulation.advance(50).expect("the scene is sound");
        }
        (
            simulation.meter_readings(),
            simulation.patch_tables(),
            simulation.state_hash(),
        )
    };
    let alone = run(1);
    assert_eq!(run(2), alone);
    assert_eq!(run(4), alone);
}
