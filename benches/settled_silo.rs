//! One step of a dense bed at rest: particle-steps per second by integrator, on one and two threads.

mod silo;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::sim::Integrator;

const PELLETS: usize = 10_000;
const RADIUS: f64 = 0.15;
/// Steps advanced at a time: enough to hold a fair share of neighbor searches.
const STEPS: u64 = 100;

fn settled_silo(criterion: &mut Criterion) {
    let positions = silo::settled_positions(PELLETS, RADIUS);
    let mut group = criterion.benchmark_group("settled-silo");
    group.sample_size(20);
    group.throughput(Throughput::Elements(PELLETS as u64 * STEPS));
    for integrator in [Integrator::VelocityVerlet, Integrator::LocatedVerlet] {
        for threads in [1, 2] {
            let mut simulation = silo::from_positions(&positions, RADIUS, integrator, threads);
            let name = format!("10k/{integrator:?}/{threads}-threads");
            group.bench_function(name, |bencher| {
                bencher.iter(|| simulation.advance(STEPS).expect("the bed rests"));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, settled_silo);
criterion_main!(benches);
