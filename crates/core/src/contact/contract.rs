//! What every contact law promises, held for each composition.

use super::{Contact, ContactHistory, ContactLaws, NormalLaw, RollingLaw, Sampling, TangentialLaw};
use crate::{Material, MaterialPair, PairProperties, Vec3};
use nalgebra::UnitQuaternion;

/// Every composition of the three parts.
fn registry() -> Vec<ContactLaws> {
    let mut all = Vec::new();
    for tangential in [TangentialLaw::None, TangentialLaw::Mindlin] {
        for rolling in [RollingLaw::None, RollingLaw::ConstantTorque] {
            all.push(ContactLaws {
                normal: NormalLaw::Hertz,
                tangential,
                rolling,
            });
        }
    }
    all
}

fn pair(restitution: f64) -> MaterialPair {
    let pellet = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
    MaterialPair::new(
        &pellet,
        &pellet,
        &PairProperties {
            restitution,
            friction: 0.5,
            rolling_friction: 0.1,
        },
    )
}

fn touch(overlap: f64) -> Contact {
    Contact {
        normal: Vec3::new(0.6, 0.0, 0.8),
        overlap,
        relative_velocity: Vec3::new(0.3, -0.2, -0.5),
        relative_spin: Vec3::new(4.0, 1.0, -2.0),
        effective_radius: 3.75e-3,
        effective_mass: 3.27e-3,
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
            assert!(force.normal >= 0.0, "{laws:?}");
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
            assert_eq!(a.rolling_torque, -b.rolling_torque, "{laws:?}");
            assert_eq!(
                of_a.tangential_displacement, -of_b.tangential_displacement,
                "{laws:?}"
            );
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
        assert!(force.force.norm() < 1.0e-12, "{laws:?}");
        assert!(force.rolling_torque.norm() < 1.0e-12, "{laws:?}");
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
            let tangential = force.force - force.normal * contact.normal;
            assert!(
                tangential.norm() <= 0.5 * force.normal * (1.0 + 1.0e-12),
                "{laws:?}"
            );
        }
    }
}

#[test]
fn the_tangential_history_turns_with_the_contact() {
    let laws = ContactLaws {
        rolling: RollingLaw::None,
        ..ContactLaws::default()
    };
    let mut history = ContactHistory {
        tangential_displacement: Vec3::new(0.0, 1.0e-6, 0.0),
        normal_force: 1.0,
    };
    let turn = UnitQuaternion::from_axis_angle(&Vec3::x_axis(), 0.01);
    let mut normal = Vec3::z();
    for _ in 0..100 {
        normal = turn * normal;
        let contact = Contact {
            normal,
            relative_velocity: Vec3::zeros(),
            relative_spin: Vec3::zeros(),
            ..touch(2.0e-4)
        };
        laws.force(&contact, &pair(0.5), &mut history, &sampling());
    }
    let length = history.tangential_displacement.norm();
    assert!((length / 1.0e-6 - 1.0).abs() < 1.0e-9, "length {length}");
    assert!(history.tangential_displacement.dot(&normal).abs() < 1.0e-18);
}

#[test]
fn normal_damping_and_rolling_never_give_energy_back() {
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
