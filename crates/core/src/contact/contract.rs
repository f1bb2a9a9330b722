//! What every contact law promises, held for each composition.

mod any_contact;

use super::{
    Contact, ContactForce, ContactHistory, ContactLaws, NormalLaw, Sampling, TangentialLaw,
    TurningLaw,
};
use crate::{Material, MaterialPair, PairProperties, Vec3};
use nalgebra::UnitQuaternion;
use std::f64::consts::{PI, TAU};

const TURNING_LAWS: [TurningLaw; 3] = [
    TurningLaw::None,
    TurningLaw::ConstantTorque,
    TurningLaw::SpringDashpot,
];

/// Every composition of the four parts.
pub(super) fn registry() -> Vec<ContactLaws> {
    let mut all = Vec::new();
    for normal in [
        NormalLaw::Hertz,
        NormalLaw::Linear,
        NormalLaw::Plastic,
        NormalLaw::Jkr,
    ] {
        for tangential in [
            TangentialLaw::None,
            TangentialLaw::Coulomb,
            TangentialLaw::Mindlin,
            TangentialLaw::PartialSlip,
        ] {
            for rolling in TURNING_LAWS {
                for twisting in TURNING_LAWS {
                    all.push(ContactLaws {
                        normal,
                        tangential,
                        rolling,
                        twisting,
                    });
                }
            }
        }
    }
    all
}

const FRICTION: f64 = 0.5;
const SURFACE_ENERGY: f64 = 0.05;

fn pair_of(properties: PairProperties) -> MaterialPair {
    let pellet = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
    MaterialPair::new(
        &pellet,
        &pellet,
        &PairProperties {
            rolling_friction: 0.1,
            stiffness: Some(1.0e5),
            yield_pressure: Some(2.0e6),
            surface_energy: Some(SURFACE_ENERGY),
            ..properties
        },
    )
}

fn pair(restitution: f64) -> MaterialPair {
    pair_of(PairProperties {
        restitution,
        friction: FRICTION,
        ..PairProperties::ELASTIC
    })
}

/// Twice the force that parts a sticky contact [N]; none where bodies do not stick.
fn adhesion(laws: ContactLaws, contact: &Contact) -> f64 {
    match laws.normal {
        NormalLaw::Jkr => 3.0 * PI * SURFACE_ENERGY * contact.effective_radius,
        _ => 0.0,
    }
}

fn touch(overlap: f64) -> Contact {
    Contact {
        normal: Vec3::new(0.6, 0.0, 0.8),
        overlap,
        relative_velocity: Vec3::new(0.3, -0.2, -0.5),
        relative_spin: Vec3::new(4.0, 1.0, -2.0),
        effective_radius: 3.75e-3,
        effective_mass: 3.27e-3,
        inverse_mass: 1.0 / 3.27e-3,
    }
}

const TIME_STEP: f64 = 1.0e-5;

fn sampling() -> Sampling {
    Sampling::located(TIME_STEP)
}

#[test]
fn every_law_pushes_apart_and_harder_when_deeper() {
    for laws in registry() {
        let mut last = 0.0;
        for overlap in [1.0e-6, 1.0e-5, 1.0e-4, 5.0e-4] {
            let force = laws.force(
                &touch(overlap),
                &pair(0.5),
                &mut ContactHistory::default(),
                &sampling(),
            );
            assert!(force.normal > last, "{laws:?}");
            assert!(force.force.dot(&touch(overlap).normal) > 0.0, "{laws:?}");
            last = force.normal;
        }
    }
}

#[test]
fn no_law_pulls_when_bodies_part() {
    for laws in registry() {
        for speed in [0.1, 1.0, 10.0] {
            let parting = Contact {
                relative_velocity: speed * touch(1.0e-6).normal,
                ..touch(1.0e-6)
            };
            let force = laws.force(
                &parting,
                &pair(0.2),
                &mut ContactHistory::default(),
                &sampling(),
            );
            let pull = 0.5 * adhesion(laws, &parting);
            assert!(force.normal >= -pull, "{laws:?}: {}", force.normal);
        }
    }
}

#[test]
fn every_law_gives_body_b_the_exact_negative() {
    for laws in registry() {
        let contact = touch(2.0e-4);
        let mirrored = Contact {
            normal: -contact.normal,
            relative_velocity: -contact.relative_velocity,
            relative_spin: -contact.relative_spin,
            ..contact
        };
        let (mut of_a, mut of_b) = (ContactHistory::default(), ContactHistory::default());
        for _ in 0..20 {
            let a = laws.force(&contact, &pair(0.5), &mut of_a, &sampling());
            let b = laws.force(&mirrored, &pair(0.5), &mut of_b, &sampling());
            assert_eq!(a.force, -b.force, "{laws:?}");
            assert_eq!(a.turning_torque, -b.turning_torque, "{laws:?}");
            assert_eq!(of_a, of_b.mirrored(), "{laws:?}");
        }
    }
}

#[test]
fn every_law_vanishes_at_first_touch() {
    for laws in registry() {
        let grazing = Contact {
            overlap: 1.0e-18,
            relative_velocity: Vec3::zeros(),
            ..touch(0.0)
        };
        let force = laws.force(
            &grazing,
            &pair(0.5),
            &mut ContactHistory::default(),
            &sampling(),
        );
        // Sticky bodies jump into contact: 8/9 of the force that parts them.
        // The sample stands for the step, which takes a few percent off.
        let jump = 4.0 / 9.0 * adhesion(laws, &grazing);
        assert!(
            (force.force.norm() - jump).abs() < 0.05 * jump + 1.0e-12,
            "{laws:?}"
        );
        let resisted = adhesion(laws, &grazing) * grazing.effective_radius;
        assert!(
            force.turning_torque.norm() <= 1.0e-12 + resisted,
            "{laws:?}"
        );
        let nothing = Contact {
            overlap: 0.0,
            ..touch(0.0)
        };
        let force = laws.force(
            &nothing,
            &pair(0.5),
            &mut ContactHistory::default(),
            &sampling(),
        );
        assert!(
            force.force.iter().all(|value| value.is_finite()),
            "{laws:?}"
        );
    }
}

#[test]
fn friction_never_exceeds_coulombs_cap() {
    for laws in registry() {
        let contact = touch(2.0e-4);
        let mut history = ContactHistory::default();
        for _ in 0..2000 {
            let force = laws.force(&contact, &pair(0.5), &mut history, &sampling());
            // What stands for the step, which at a sample next to first touch is not the force of the law.
            let normal = force.force.dot(&contact.normal);
            let tangential = force.force - normal * contact.normal;
            let cap = FRICTION * (normal + adhesion(laws, &contact));
            assert!(tangential.norm() <= cap + 1.0e-9 * normal.abs(), "{laws:?}");
        }
    }
}

#[test]
fn a_contact_without_friction_is_pushed_along_its_normal_only() {
    let smooth = pair_of(PairProperties::ELASTIC);
    for laws in registry() {
        let contact = touch(2.0e-4);
        let mut history = ContactHistory::default();
        for _ in 0..50 {
            let force = laws.force(&contact, &smooth, &mut history, &sampling());
            let tangential = force.force - force.force.dot(&contact.normal) * contact.normal;
            // What adhesion presses together is not resisted either: its share of friction is none.
            assert!(tangential.norm() < 1.0e-12 * force.normal, "{laws:?}");
        }
    }
}

#[test]
fn the_springs_keep_their_energy_while_the_contact_turns_as_a_rigid_body() {
    for laws in registry() {
        let mut history = ContactHistory::default();
        for _ in 0..3 {
            laws.force(&touch(2.0e-4), &pair(0.5), &mut history, &sampling());
        }
        let mut at_rest = |normal| {
            let contact = Contact {
                normal,
                relative_velocity: Vec3::zeros(),
                relative_spin: Vec3::zeros(),
                ..touch(2.0e-4)
            };
            laws.force(&contact, &pair(0.5), &mut history, &sampling())
                .shear_energy
        };
        let mut normal = touch(2.0e-4).normal;
        // Friction's cap follows the damped normal force, which comes to rest first.
        for _ in 0..50 {
            at_rest(normal);
        }
        let before = at_rest(normal);
        let turn = UnitQuaternion::from_axis_angle(&Vec3::x_axis(), 0.01);
        let mut after = before;
        for _ in 0..1000 {
            normal = turn * normal;
            after = at_rest(normal);
        }
        let lost = (after - before).abs();
        assert!(
            lost <= 1.0e-9 * before,
            "{laws:?}: {before} J, then {after} J"
        );
    }
}

/// A loop of overlap, sliding, rolling and twisting that ends where it began: motion at a share of its time.
fn around(share: f64) -> (f64, Vec3, Vec3) {
    let phase = TAU * share;
    let overlap = 2.0e-4 * (1.0 - phase.cos());
    let across = [Vec3::new(0.8, 0.0, -0.6), Vec3::y()];
    let normal = touch(0.0).normal;
    let approach = 2.0e-4 * TAU * phase.sin();
    let sliding = 5.0e-5 * TAU * (phase.cos() * across[0] + (2.0 * phase).cos() * across[1]);
    let spin = 0.02 * TAU * (phase.cos() * across[1] + (2.0 * phase).cos() * normal);
    (overlap, sliding - approach * normal, spin)
}

#[test]
fn no_law_gives_energy_over_a_closed_loop() {
    const STEPS: u32 = 4000;
    let elastic = pair(1.0);
    for laws in registry() {
        let mut history = ContactHistory::default();
        let (mut given, mut exchanged) = (0.0, 0.0);
        // Around in one unit of time.
        let sampling = Sampling::plain(1.0 / f64::from(STEPS));
        for step in 1..STEPS {
            let (overlap, relative_velocity, relative_spin) =
                around(f64::from(step) / f64::from(STEPS));
            let contact = Contact {
                overlap,
                relative_velocity,
                relative_spin,
                ..touch(0.0)
            };
            let force = laws.force(&contact, &elastic, &mut history, &sampling);
            let power =
                force.force.dot(&relative_velocity) + force.turning_torque.dot(&relative_spin);
            given += power * sampling.time_step();
            exchanged += power.abs() * sampling.time_step();
        }
        // A sticky contact closes its loop only at the pull-off gap; at no overlap it still holds on to energy.
        let held = laws.normal == NormalLaw::Jkr;
        let open = if held { 1.0e-2 } else { 1.0e-6 };
        assert!(
            given <= open * exchanged,
            "{laws:?}: {given} J of {exchanged} J"
        );
    }
}

#[test]
fn a_memory_survives_being_packed() {
    for laws in registry() {
        let mut history = ContactHistory::default();
        let mut kept = ContactHistory::default();
        let mut row = vec![0.0; laws.extra_numbers()];
        for step in 0..40 {
            let contact = touch(1.0e-5 * f64::from(20 - (step - 20_i32).abs() + 1));
            let force: ContactForce = laws.force(&contact, &pair(0.7), &mut history, &sampling());
            let mut unpacked = ContactHistory {
                tangential_stretch: kept.tangential_stretch,
                normal_force: kept.normal_force,
                samples: kept.samples,
                ..ContactHistory::default()
            };
            laws.unpack(&row, &mut unpacked);
            let same = laws.force(&contact, &pair(0.7), &mut unpacked, &sampling());
            assert_eq!(force, same, "{laws:?}, step {step}");
            laws.pack(&unpacked, &mut row);
            kept = unpacked;
        }
    }
}

#[test]
fn the_normal_direction_never_makes_less_than_no_heat() {
    for laws in registry() {
        for step in 0..400 {
            let phase = f64::from(step) * 0.37;
            let contact = Contact {
                relative_velocity: Vec3::new(phase.sin(), (1.7 * phase).cos(), (2.3 * phase).sin()),
                relative_spin: 50.0 * Vec3::new((1.3 * phase).cos(), phase.sin(), 0.2),
                ..touch(1.0e-6 + 4.0e-4 * phase.sin().abs())
            };
            let mut history = ContactHistory::default();
            let force = laws.force(&contact, &pair(0.5), &mut history, &sampling());
            assert!(
                force.dissipation >= -1.0e-12,
                "{laws:?}: {}",
                force.dissipation
            );
        }
    }
}
