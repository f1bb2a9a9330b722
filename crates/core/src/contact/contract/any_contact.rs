//! What every contact law promises, for any contact of any materials that a scene may ask for.

use super::registry;
use crate::contact::{Contact, ContactHistory, NormalLaw, Sampling};
use crate::{Material, MaterialPair, PairProperties, Vec3};
use nalgebra::{UnitQuaternion, UnitVector3};
use proptest::prelude::*;

/// Share by which sums of some tens of rounded numbers may differ [-].
const ROUNDING: f64 = 1.0e-9;
/// The same where they cancel: the sample of a touch that began a millionth of a step ago stands for what it pushed since.
const CANCELED: f64 = 1.0e-6;

/// Numbers that a scene may hold, from their least to their greatest, evenly over the decades.
fn over_decades(least: f64, greatest: f64) -> impl Strategy<Value = f64> {
    (least.ln()..greatest.ln()).prop_map(f64::exp)
}

fn vector(most: f64) -> impl Strategy<Value = Vec3> {
    [-most..most, -most..most, -most..most].prop_map(Vec3::from)
}

fn direction() -> impl Strategy<Value = Vec3> {
    vector(1.0)
        .prop_filter("it has a length", |vector| vector.norm() > 0.1)
        .prop_map(|vector| vector.normalize())
}

/// Two bodies of 10⁶ to 2·10¹¹ Pa, up to 30 m/s fast, pressed together by up to a tenth of a radius.
fn contacts() -> impl Strategy<Value = Contact> {
    let radius = over_decades(1.0e-4, 1.0);
    let overlap = over_decades(1.0e-9, 0.1);
    (
        radius,
        overlap,
        direction(),
        vector(30.0),
        vector(1000.0),
        over_decades(0.1, 10.0),
    )
        .prop_map(
            |(effective_radius, overlap, normal, relative_velocity, relative_spin, lightness)| {
                let inverse_mass = lightness / (4000.0 * effective_radius.powi(3));
                Contact {
                    normal,
                    overlap: overlap * effective_radius,
                    relative_velocity,
                    relative_spin,
                    effective_radius,
                    effective_mass: 1.0 / inverse_mass,
                    inverse_mass,
                }
            },
        )
}

fn pairs() -> impl Strategy<Value = MaterialPair> {
    let modulus = || over_decades(1.0e6, 2.0e11);
    let poisson_ratio = || 0.0..0.49_f64;
    (
        modulus(),
        modulus(),
        poisson_ratio(),
        poisson_ratio(),
        0.05..1.0_f64,
        0.0..10.0_f64,
    )
        .prop_map(|(one, other, of_one, of_other, restitution, friction)| {
            let material = |youngs_modulus: f64, poisson_ratio| Material {
                density: 4000.0,
                youngs_modulus,
                poisson_ratio,
            };
            let properties = PairProperties {
                restitution,
                friction,
                rolling_friction: 0.1,
                stiffness: Some(1.0e-3 * one),
                yield_pressure: Some(1.0e-2 * one),
                surface_energy: Some(0.05),
                ..PairProperties::ELASTIC
            };
            MaterialPair::new(
                &material(one, of_one),
                &material(other, of_other),
                &properties,
            )
        })
}

/// A step that follows a hit of these bodies, by Hertz's time of the fastest and by that of the linear spring [s].
fn step(contact: &Contact, pair: &MaterialPair) -> f64 {
    let stiffness = pair.effective_youngs_modulus * contact.effective_radius.sqrt();
    let time = (contact.effective_mass / stiffness).powf(0.4) / 30.0_f64.powf(0.2);
    let of_spring = (contact.effective_mass / pair.linear_stiffness).sqrt();
    0.1 * time.min(of_spring)
}

proptest! {
    #[test]
    fn every_force_is_finite_and_a_turned_contact_has_the_turned_force(
        contact in contacts(), pair in pairs(), axis in direction(), angle in 0.0..3.0_f64,
    ) {
        let turn = UnitQuaternion::from_axis_angle(&UnitVector3::new_normalize(axis), angle);
        let turned = Contact {
            normal: turn * contact.normal,
            relative_velocity: turn * contact.relative_velocity,
            relative_spin: turn * contact.relative_spin,
            ..contact
        };
        for laws in registry() {
            let sampling = Sampling::located(step(&contact, &pair));
            let [mut history, mut of_turned] = [ContactHistory::default(), ContactHistory::default()];
            for _ in 0..3 {
                let force = laws.force(&contact, &pair, &mut history, &sampling);
                let found = laws.force(&turned, &pair, &mut of_turned, &sampling);
                let numbers = [force.normal, force.dissipation, force.shear_energy];
                let numbers = numbers.iter().chain(&force.force).chain(&force.turning_torque);
                prop_assert!(numbers.clone().all(|number| number.is_finite()), "{laws:?}: {force:?}");
                let [scale, of_torque] = [force.force.norm(), force.turning_torque.norm()];
                prop_assert!((turn * force.force - found.force).norm() <= CANCELED * scale, "{laws:?}");
                let missed = (turn * force.turning_torque - found.turning_torque).norm();
                prop_assert!(missed <= CANCELED * of_torque, "{laws:?}");
            }
        }
    }

    #[test]
    fn friction_of_any_contact_stays_below_coulombs_cap_and_its_heat_is_not_negative(
        contact in contacts(), pair in pairs(),
    ) {
        for laws in registry() {
            // What sticks is held by more than it presses with; `contract.rs` has its cap.
            if laws.normal == NormalLaw::Jkr {
                continue;
            }
            // The laws alone: the first and the last sample of a hit stand for a step that they do not fill.
            let sampling = Sampling::plain(step(&contact, &pair));
            let mut history = ContactHistory::default();
            for _ in 0..20 {
                let force = laws.force(&contact, &pair, &mut history, &sampling);
                let normal = force.force.dot(&contact.normal);
                let tangential = force.force - normal * contact.normal;
                let cap = pair.friction * normal.abs();
                prop_assert!(tangential.norm() <= cap + ROUNDING * normal.abs(), "{laws:?}");
                let scale = force.force.norm() * contact.relative_velocity.norm();
                prop_assert!(force.dissipation >= -ROUNDING * scale, "{laws:?}: {force:?}");
            }
        }
    }
}
