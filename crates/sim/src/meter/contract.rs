//! What every meter promises.

use super::{
    Heap, MassFlow, Meter, MeterKind, PlaneFlow, Region, Residence, WallForce, WallImpacts, Wear,
};
use crate::motion::Motion;
use crate::pellet::PelletKind;
use crate::schedule::Schedule;
use crate::setup::{
    Domain, Fill, Limits, NamedMaterial, NeighborSearch, Outlet, Seats, Setup, Skips,
};
use crate::{Integrator, Model, Simulation, SizeDistribution, StepRequest, Wall};
use pelletflow_core::{Bounds, ContactLaws, Material, PairProperties, Shape, Vec3};
use std::collections::BTreeSet;

/// A meter of each kind that has something to see in [`scene`].
fn samples() -> Vec<MeterKind> {
    vec![
        MeterKind::MassFlow(MassFlow { outlet: 0 }),
        MeterKind::PlaneFlow(PlaneFlow {
            point: Vec3::new(0.0, 0.0, 0.08),
            normal: Vec3::z_axis(),
            radius: f64::INFINITY,
        }),
        MeterKind::WallForce(WallForce {
            wall: 0,
            about: Vec3::new(1.0, 0.0, 0.0),
        }),
        MeterKind::WallImpacts(WallImpacts {
            wall: 0,
            cell: 0.05,
            least_speed: 0.1,
        }),
        MeterKind::Wear(Wear {
            wall: 0,
            cell: 0.05,
            archard: 1.0e-13,
            finnie: 1.0e-10,
            least_speed: 0.1,
        }),
        MeterKind::Region(Region {
            bounds: Bounds::about_origin(Vec3::repeat(0.3)),
        }),
        MeterKind::Residence(Residence),
        MeterKind::Heap(Heap {
            point: Vec3::zeros(),
            up: Vec3::z_axis(),
        }),
    ]
}

/// A small pile that drops on a sloping floor and slides into an outlet.
fn scene(meters: Vec<MeterKind>) -> Setup {
    let ore = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
    let pair = PairProperties {
        restitution: 0.5,
        friction: 0.2,
        ..PairProperties::ELASTIC
    };
    let places = (0..125).map(|place| {
        let [x, y, z] =
            [place % 5, place / 5 % 5, place / 25].map(|steps| 0.016 * f64::from(steps));
        Vec3::new(x, y, z + 0.1)
    });
    Setup {
        seed: 1,
        gravity: Vec3::new(3.0, 0.0, -9.0),
        materials: vec![NamedMaterial {
            name: "ore".into(),
            material: ore,
            true_youngs_modulus: None,
        }],
        pairs: vec![([0, 0], pair)],
        pellets: vec![PelletKind {
            name: "ore".into(),
            material: 0,
            size: SizeDistribution::Single { diameter: 0.015 },
        }],
        laws: ContactLaws::default(),
        walls: vec![Wall {
            name: "floor".into(),
            material: 0,
            shape: Shape::HalfSpace {
                point: Vec3::zeros(),
                normal: Vec3::z_axis(),
            }
            .into(),
            motion: Motion::Fixed,
            surface_velocity: Vec3::zeros(),
            schedule: Schedule::always(),
        }],
        fills: vec![Fill {
            name: "pile".into(),
            pellets: 0,
            seats: Seats::Points(places.collect()),
            velocity: Vec3::zeros(),
            spin: Vec3::zeros(),
        }],
        inlets: Vec::new(),
        outlets: vec![Outlet {
            name: "end".into(),
            region: Shape::HalfSpace {
                point: Vec3::new(0.15, 0.0, 0.0),
                normal: -Vec3::x_axis(),
            },
        }],
        meters: meters
            .into_iter()
            .map(|kind| Meter {
                name: kind.name().into(),
                kind,
            })
            .collect(),
        domain: Domain::closed(Bounds::about_origin(Vec3::repeat(2.0))),
        integrator: Integrator::default(),
        step: StepRequest::PeakForceError(1.0e-2),
        search: NeighborSearch::Auto,
        skin: None,
        limits: Limits::default(),
        skips: Skips::default(),
        instructions: None,
        hits: None,
    }
}

fn simulation(setup: Setup) -> Simulation {
    let model = Model::new(setup).expect("the setup has no mistakes");
    Simulation::new(model, 1).expect("the fill fits")
}

/// Takes steps until pellets have slid into the outlet.
fn run(simulation: &mut Simulation) {
    while simulation.mass_ledger().discharged.count < 20 {
        simulation.advance(16).expect("the scene is sound");
    }
}

#[test]
fn every_kind_has_a_sample_and_its_name_is_that_of_its_kind() {
    let sampled: BTreeSet<&str> = samples().iter().map(MeterKind::name).collect();
    assert_eq!(sampled, MeterKind::NAMES.iter().copied().collect());
    assert_eq!(sampled.len(), samples().len());
}

#[test]
fn every_quantity_has_one_name_at_any_time_and_a_finite_value() {
    for kind in samples() {
        let mut simulation = simulation(scene(vec![kind]));
        let before = simulation.meter_readings().remove(0);
        run(&mut simulation);
        let after = simulation.meter_readings().remove(0);
        let names = |reading: &super::MeterReading| -> Vec<&str> {
            reading.values.iter().map(|(name, _)| *name).collect()
        };
        assert_eq!(names(&before), names(&after), "{}", after.name);
        let distinct: BTreeSet<&str> = names(&after).into_iter().collect();
        assert_eq!(distinct.len(), after.values.len(), "{}", after.name);
        for (name, value) in before.values.iter().chain(&after.values) {
            assert!(value.is_finite(), "{}: {name} is {value}", after.name);
        }
        let is_new = |(name, value)| before.values.iter().all(|old| *old != (name, value));
        assert!(
            after.values.into_iter().any(is_new),
            "{} reads nothing",
            after.name
        );
    }
}

#[test]
fn patches_add_up_to_what_the_meter_reads() {
    for kind in samples() {
        let mut simulation = simulation(scene(vec![kind]));
        run(&mut simulation);
        let reading = simulation.meter_readings().remove(0);
        for (name, table) in simulation.patch_tables() {
            assert!(
                table.rows.len() > 3,
                "{name} has {} patches",
                table.rows.len()
            );
            assert_eq!(table.columns[..3], ["x_m", "y_m", "z_m"], "{name}");
            for (column, quantity) in table.columns.iter().enumerate() {
                let total = reading.values.iter().find(|(name, _)| name == quantity);
                let Some((_, total)) = total.filter(|_| !quantity.starts_with("greatest")) else {
                    continue;
                };
                let sum: f64 = table.rows.iter().map(|row| row[column]).sum();
                // The same numbers added in another order.
                assert!(
                    (sum - total).abs() <= 1.0e-9 * total.abs(),
                    "{name}: {quantity}"
                );
            }
        }
    }
}

#[test]
fn looking_changes_nothing() {
    let (mut blind, mut watched) = (simulation(scene(Vec::new())), simulation(scene(samples())));
    run(&mut blind);
    run(&mut watched);
    assert_eq!(blind.state_hash(), watched.state_hash());
}

#[test]
fn every_mistake_names_its_key() {
    let nowhere = Vec3::repeat(f64::NAN);
    let cases = [
        (MeterKind::MassFlow(MassFlow { outlet: 1 }), "outlet"),
        (
            MeterKind::PlaneFlow(PlaneFlow {
                point: Vec3::zeros(),
                normal: Vec3::z_axis(),
                radius: 0.0,
            }),
            "radius",
        ),
        (
            MeterKind::WallForce(WallForce {
                wall: 0,
                about: nowhere,
            }),
            "about",
        ),
        (
            MeterKind::WallImpacts(WallImpacts {
                wall: 0,
                cell: 0.0,
                least_speed: 0.1,
            }),
            "cell",
        ),
        (
            MeterKind::Wear(Wear {
                wall: 0,
                cell: 0.1,
                archard: 0.0,
                finnie: 0.0,
                least_speed: 0.1,
            }),
            "archard",
        ),
        (
            MeterKind::Region(Region {
                bounds: Bounds::nothing(),
            }),
            "max",
        ),
        (
            MeterKind::Heap(Heap {
                point: nowhere,
                up: Vec3::z_axis(),
            }),
            "point",
        ),
    ];
    for (kind, key) in cases {
        let expected = format!("meters.{}.{key}", kind.name());
        let mistakes = Model::new(scene(vec![kind])).expect_err(&expected);
        let keys: Vec<&str> = mistakes
            .iter()
            .map(|mistake| mistake.key.as_str())
            .collect();
        assert_eq!(keys, [expected]);
    }
    for kind in samples() {
        assert_eq!(kind.mistakes(&scene(Vec::new())), []);
    }
}
