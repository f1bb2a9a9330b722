//! One contact over one step by every law: nanoseconds, one by one and in batches.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::core::contact::batch::{Batch, LANES, SpherePair};
use pelletflow::core::contact::{ContactLaws, NormalLaw, Sampling, TangentialLaw, TurningLaw};
use pelletflow::core::{ContactHistory, InstructionSet, Material, MaterialPair, PairProperties};
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
fn batch(laws: ContactLaws) -> Batch {
    let mut batch = Batch::new(laws);
    for lane in 0..LANES {
        let phase = lane as f64;
        let velocity = [phase.sin(), (1.3 * phase).cos(), 0.2].map(|speed| 2.0 * speed);
        let spin = [(0.7 * phase).cos(), 0.5, phase.sin()].map(|spin| 10.0 * spin);
        let apart = 2.0 * RADIUS - 1.0e-4 * (1.0 + 0.5 * phase.cos());
        let spheres = SpherePair {
            between: [0.6 * apart, 0.0, 0.8 * apart, RADIUS],
            other_radius: RADIUS,
            velocity: [velocity[0], velocity[1], velocity[2], 300.0],
            spins: [
                [spin[0], spin[1], spin[2], 0.0],
                [-spin[0], -spin[1], -spin[2], 0.0],
            ],
        };
        batch.set_spheres(lane, &spheres, true);
        batch.set_history(lane, [0.0; 3], [2.0, 5.0], &[]);
        batch.set_pair(lane, &pair());
    }
    batch.meet(LANES, InstructionSet::widest());
    batch
}

fn contact_laws(criterion: &mut Criterion) {
    let sampling = Sampling::located(2.0e-5);
    let pair = pair();
    let mut group = criterion.benchmark_group("contact");
    group.throughput(Throughput::Elements(LANES as u64));
    for (name, laws) in laws() {
        let mut batch = batch(laws);
        let mut histories: Vec<ContactHistory> =
            (0..LANES).map(|lane| batch.history(lane, laws)).collect();
        group.bench_function(format!("{name}/single"), |bencher| {
            bencher.iter(|| {
                for (lane, history) in histories.iter_mut().enumerate() {
                    let contact = black_box(batch.contact(lane));
                    black_box(laws.force(&contact, &pair, history, &sampling));
                }
            });
        });
        let available = InstructionSet::ALL
            .into_iter()
            .filter(|set| set.is_available());
        for set in available {
            group.bench_function(format!("{name}/batch/{set:?}"), |bencher| {
                bencher.iter(|| laws.forces(black_box(&mut batch), LANES, &sampling, set));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, contact_laws);
criterion_main!(benches);
