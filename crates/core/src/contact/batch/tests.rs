//! A batch is held against its contacts one by one.

use super::*;
use crate::InstructionSet;
use crate::contact::Sampling;
use crate::contact::contract::registry;
use crate::{Material, PairProperties};

/// Two spheres that differ from all others, one of them in the origin.
fn spheres(number: usize, depth: f64) -> SpherePair {
    let radius = |phase: f64| 7.5e-3 * (1.0 + 0.1 * phase.sin());
    let spin = |phase: f64| {
        [
            30.0 * (2.1 * phase).sin(),
            30.0 * phase.cos(),
            9.0,
            f64::NAN,
        ]
    };
    let phase = number as f64;
    let (first, second) = (radius(phase), radius(phase + 100.0));
    let distance = first + second - depth;
    SpherePair {
        between: [0.6 * distance, 0.0, -0.8 * distance, first],
        other_radius: second,
        velocity: [
            phase.cos(),
            (1.3 * phase).sin(),
            (0.7 * phase).cos(),
            300.0 * (1.0 + 0.2 * phase.cos()),
        ],
        spins: [spin(phase), spin(phase + 100.0)],
    }
}

/// What a contact in its middle remembers beside its stretch.
fn remembered(number: usize) -> ContactHistory {
    let phase = number as f64;
    let mut history = ContactHistory {
        deepest_overlap: 2.0e-4 * (1.0 + phase.sin()),
        rolling_stretch: Vec3::new(phase.cos(), 0.3, -0.2) * 1.0e-4,
        twisting_stretch: 1.0e-4 * phase.sin(),
        ..ContactHistory::default()
    };
    history.sliders.length = 1.5e-3;
    history.sliders.covered = 4.0e-4;
    history.sliders.displacements[0] = Vec3::new(1.0e-6, -2.0e-6, 0.0);
    history
}

fn batch(pair: &MaterialPair, laws: ContactLaws) -> Batch {
    let mut batch = Batch::new(laws);
    for lane in 0..LANES {
        // Some lanes at their first sample, some at their second or near their last, most in the middle.
        let depth = [1.0e-6, 1.0e-5, 1.0e-4, 4.0e-4][lane % 4];
        batch.set_spheres(lane, &spheres(lane, depth), lane % 5 > 0);
        let [last_force, samples] = [[0.0, 0.0], [2.0, 1.0], [2.0, 5.0]][lane % 3];
        let mut extra = vec![0.0; laws.extra_numbers()];
        if last_force > 0.0 {
            laws.pack(&remembered(lane), &mut extra);
        }
        batch.set_history(
            lane,
            [8.0e-4, 3.0e-4, -6.0e-4],
            [last_force, samples],
            &extra,
        );
        batch.set_pair(lane, pair);
    }
    batch
}

fn pair() -> MaterialPair {
    let ore = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
    let properties = PairProperties {
        restitution: 0.5,
        friction: 0.4,
        rolling_friction: 0.05,
        stiffness: Some(1.0e5),
        yield_pressure: Some(2.0e6),
        surface_energy: Some(0.05),
        ..PairProperties::ELASTIC
    };
    MaterialPair::new(&ore, &ore, &properties)
}

#[test]
fn spheres_in_a_batch_meet_as_by_the_definitions() {
    let mut batch = batch(&pair(), ContactLaws::default());
    batch.meet(LANES, InstructionSet::widest());
    for lane in 0..LANES {
        let given = spheres(lane, [1.0e-6, 1.0e-5, 1.0e-4, 4.0e-4][lane % 4]);
        let contact = batch.contact(lane);
        let between = Vec3::new(given.between[0], given.between[1], given.between[2]);
        let radii = [given.between[3], given.other_radius];
        let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1.0e-14;
        let curvature = 1.0 / radii[0] + 1.0 / radii[1];
        assert!((contact.normal - between / between.norm()).norm() < 1.0e-15);
        assert!(near(contact.effective_radius, 1.0 / curvature));
        assert!(near(contact.effective_mass, 1.0 / given.velocity[3]));
        assert_eq!(contact.inverse_mass, given.velocity[3]);
        // The overlap is a small difference of numbers of the size of a radius.
        let overlap = radii[0] + radii[1] - between.norm();
        assert!((contact.overlap - overlap).abs() < 1.0e-17);
    }
}

#[test]
fn a_batch_has_the_bits_of_its_contacts_one_by_one_by_every_instruction_set() {
    let pair = pair();
    let available = InstructionSet::ALL
        .into_iter()
        .filter(|set| set.is_available());
    for instructions in available {
        for laws in registry() {
            for sampling in [Sampling::plain(2.0e-5), Sampling::located(2.0e-5)] {
                let mut batch = batch(&pair, laws);
                batch.meet(LANES, instructions);
                laws.forces(&mut batch, LANES, &sampling, instructions);
                for lane in 0..LANES {
                    let mut history = batch.history(lane, laws);
                    let contact = batch.contact(lane);
                    let force = laws.force(&contact, &pair, &mut history, &sampling);
                    let which = format!("lane {lane}, {laws:?}, {sampling:?}, {instructions:?}");
                    let found = batch.contact_force(lane);
                    assert_eq!(found.force, force.force, "{which}");
                    assert_eq!(found.normal, force.normal, "{which}");
                    assert_eq!(found.shear_power, force.shear_power, "{which}");
                    assert_eq!(found.shear_energy, force.shear_energy, "{which}");
                    assert_eq!(found.dissipation, force.dissipation, "{which}");
                    assert_eq!(found.elastic_energy, force.elastic_energy, "{which}");
                    let moment = -batch.arms[0][lane] * contact.normal.cross(&force.force);
                    let torque = force.turning_torque + moment;
                    assert!((batch.torques(lane)[0] - torque).norm() <= 1.0e-16 * moment.norm());
                    let [x, y, z, normal_force] = batch.next_memory(lane);
                    assert_eq!(Vec3::new(x, y, z), history.tangential_stretch, "{which}");
                    assert_eq!(normal_force, history.normal_force, "{which}");
                    let mut extra = vec![0.0; laws.extra_numbers()];
                    let mut expected = extra.clone();
                    batch.next_extra(lane, &mut extra);
                    laws.pack(&history, &mut expected);
                    assert_eq!(extra, expected, "{which}");
                }
            }
        }
    }
}

#[test]
fn the_totals_are_the_sums_over_the_counted_contacts() {
    let mut batch = batch(&pair(), ContactLaws::default());
    let sampling = Sampling::located(2.0e-5);
    let instructions = InstructionSet::widest();
    batch.meet(LANES, instructions);
    ContactLaws::default().forces(&mut batch, LANES, &sampling, instructions);
    let counted = (0..19).filter(|lane| lane % 5 > 0);
    let expected: f64 = counted
        .clone()
        .map(|lane| batch.contact_force(lane).elastic_energy)
        .sum();
    let totals = batch.totals(19);
    assert!((totals.elastic_energy / expected - 1.0).abs() < 1.0e-14);
    assert_eq!(batch.counted(19), counted.count() as u64);
}
