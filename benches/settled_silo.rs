//! One step of a dense bed at rest: particle-steps per second by integrator, on one and two threads.

mod silo;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::sim::{Integrator, Seats};

const PELLETS: usize = 10_000;
const RADIUS: f64 = 0.15;
/// Steps in which the bed comes to rest.
const SETTLING_STEPS: u64 = 20_000;
/// Steps advanced at a time: enough to hold a fair share of neighbor searches.
const STEPS: u64 = 100;

fn settled_silo(criterion: &mut Criterion) {
    let mut settling = silo::simulation(silo::silo(PELLETS, RADIUS), 0);
    settling.advance(SETTLING_STEPS).expect("the bed settles");
    let mut pellets: Vec<_> = settling.pellets().collect();
    pellets.sort_by_key(|pellet| pellet.id);
    let positions: Vec<_> = pellets.iter().map(|pellet| pellet.position).collect();

    let mut group = criterion.benchmark_group("settled-silo");
    group.sample_size(20);
    group.throughput(Throughput::Elements(PELLETS as u64 * STEPS));
    for integrator in [Integrator::VelocityVerlet, Integrator::LocatedVerlet] {
        for threads in [1, 2] {
            let mut setup = silo::silo(PELLETS, RADIUS);
            setup.integrator = integrator;
            setup.fills[0].seats = Seats::Points(positions.clone());
            let mut simulation = silo::simulation(setup, threads);
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
