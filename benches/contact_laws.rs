//! One contact over one step by every law: nanoseconds, one by one and in batches.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::core::contact::batch::{Batch, LANES, Sphere};
use pelletflow::core::contact::{ContactLaws, NormalLaw, Sampling, TangentialLaw, TurningLaw};
use pelletflow::core::{ContactHistory, Material, MaterialPair, PairProperties, Vec3};
use std::hint::black_box;

const RADIUS: f64 = 7.5e-3;

fn pair() -> MaterialPair {
    let ore = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
    let properties = PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.1,
        stiffness: Some(2.0e5),
        yield_pressure: Some(5.0e6),
        surface_energy: Some(0.1),
        ..PairProperties::ELASTIC
    };
    MaterialPair::new(&ore, &ore, &properties)
}

/// The default with one part exchanged for another, by name.
fn laws() -> Vec<(&'static str, ContactLaws)> {
    let default = ContactLaws::default();
    let normal = |normal| ContactLaws { normal, ..default };
    let tangential = |tangential| ContactLaws {
        tangential,
        ..default
    };
    vec![
        ("default", default),
        ("linear", normal(NormalLaw::Linear)),
        ("plastic", normal(NormalLaw::Plastic)),
        ("jkr", normal(NormalLaw::Jkr)),
        ("no-friction", tangential(TangentialLaw::None)),
        ("coulomb", tangential(TangentialLaw::Coulomb)),
        ("partial-slip", tangential(TangentialLaw::PartialSlip)),
        (
            "spring-dashpot",
            ContactLaws {
                rolling: TurningLaw::SpringDashpot,
                twisting: TurningLaw::SpringDashpot,
                ..default
            },
        ),
    ]
}

/// A batch of contacts in the middle of their lives, no two alike.
fn batch() -> Batch {
    let mut batch = Batch::default();
    for lane in 0..LANES {
        let phase = lane as f64;
        let sphere = |center: Vec3, sign: f64| Sphere {
            center,
            radius: RADIUS,
            velocity: sign * Vec3::new(phase.sin(), (1.3 * phase).cos(), 0.2),
            spin: 10.0 * sign * Vec3::new((0.7 * phase).cos(), 0.5, phase.sin()),
            inverse_mass: 150.0,
        };
        let apart = 2.0 * RADIUS - 1.0e-4 * (1.0 + 0.5 * phase.cos());
        let history = ContactHistory {
            normal_force: 2.0,
            ..ContactHistory::default()
        };
        let center = apart * Vec3::new(0.6, 0.0, 0.8);
        batch.set(
            lane,
            &sphere(center, 1.0),
            &sphere(Vec3::zeros(), -1.0),
            &history,
        );
        batch.set_pair(lane, &pair());
    }
    batch
}

fn contact_laws(criterion: &mut Criterion) {
    let sampling = Sampling::located(2.0e-5);
    let pair = pair();
    let mut batch = batch();
    let mut group = criterion.benchmark_group("contact");
    group.throughput(Throughput::Elements(LANES as u64));
    for (name, laws) in laws() {
        let mut histories: Vec<ContactHistory> =
            (0..LANES).map(|lane| batch.history(lane)).collect();
        group.bench_function(format!("{name}/single"), |bencher| {
            bencher.iter(|| {
                for (lane, history) in histories.iter_mut().enumerate() {
                    let contact = black_box(batch.contact(lane));
                    black_box(laws.force(&contact, &pair, history, &sampling));
                }
            });
        });
        if laws.forces(&mut batch, LANES, &sampling) {
            group.bench_function(format!("{name}/batch"), |bencher| {
                bencher.iter(|| laws.forces(black_box(&mut batch), LANES, &sampling));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, contact_laws);
criterion_main!(benches);
