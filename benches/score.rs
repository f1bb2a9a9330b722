//! How long it takes to score a million blows on twenty thousand pellets.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::impact::{
    Blow, FractureEnergy, MedianEnergy, Scatter, Strength, StrengthLaw, score,
};

const BLOWS: u32 = 1_000_000;
const PELLETS: u32 = 20_000;

/// Blows of pellets in turn, their sizes without pattern: fractions of multiples of the golden ratio.
fn blows() -> Vec<Blow> {
    let spread = |index: u32| (f64::from(index) * 0.618_033_988_749_894_9).fract();
    (0..BLOWS)
        .map(|index| Blow {
            pellet: index.wrapping_mul(7919) % PELLETS,
            diameter: 0.012,
            mass: 3.44e-3,
            force: 1500.0 * spread(index),
            energy: 0.2 * spread(index).powi(2),
        })
        .collect()
}

fn million_blows(criterion: &mut Criterion) {
    let load = |scatter| {
        StrengthLaw::Load(Strength {
            scatter,
            test_diameter: Some(0.01125),
            sample_size: Some(60),
        })
    };
    let laws = [
        (
            "weibull",
            load(Scatter::Weibull {
                scale: 2700.0,
                modulus: 4.0,
            }),
        ),
        (
            "log-normal",
            load(Scatter::LogNormal {
                median: 2450.0,
                deviation: 0.3,
            }),
        ),
        (
            "damage",
            StrengthLaw::Energy(FractureEnergy {
                median: MedianEnergy::OfAnySize(100.0),
                deviation: 0.5,
                truncation: Some(4.0),
                damage_constant: Some(5.0),
                sample_size: Some(60),
            }),
        ),
    ];
    let blows = blows();
    let mut group = criterion.benchmark_group("a million blows");
    group.sample_size(10);
    group.throughput(Throughput::Elements(u64::from(BLOWS)));
    for (name, law) in laws {
        group.bench_function(name, |bencher| {
            bencher.iter_batched(
                || (),
                |()| score(&law, &blows).expect("good blows"),
                BatchSize::LargeInput,
            );
        });
    }
    group.finish();
}

criterion_group!(benches, million_blows);
criterion_main!(benches);
