//! What a checkpoint costs: bytes per pellet of a bed at rest, and its time against that of the steps.
//!
//! The run waits for the copy alone; a thread of its own encodes and writes.

mod silo;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::sim::HitRequest;

const PELLETS: usize = 10_000;
const RADIUS: f64 = 0.15;
/// Steps in which the bed, which is put down nearly settled, takes up its weight.
const SETTLING_STEPS: u64 = 10_000;
/// Steps advanced at a time.
const STEPS: u64 = 16;

fn checkpoint(criterion: &mut Criterion) {
    let mut setup = silo::silo(PELLETS, RADIUS);
    setup.hits = Some(HitRequest {
        threshold: f64::INFINITY,
    });
    let mut simulation = silo::simulation(setup, 0);
    simulation.advance(SETTLING_STEPS).expect("the bed settles");
    let encode = |snapshot: &_| postcard::to_stdvec(snapshot).expect("it is plain data");
    let snapshot = simulation.snapshot();
    let bytes = encode(&snapshot).len();
    let open = simulation.contact_statistics().open as f64 / PELLETS as f64;

    let mut group = criterion.benchmark_group("checkpoint");
    group.sample_size(10);
    group.throughput(Throughput::Bytes(bytes as u64));
    let each = bytes / PELLETS;
    group.bench_function(
        format!("copy/{each} B per pellet of {open:.1} contacts"),
        |bencher| bencher.iter(|| simulation.snapshot()),
    );
    group.bench_function("encode", |bencher| bencher.iter(|| encode(&snapshot)));
    group.throughput(Throughput::Elements(PELLETS as u64 * STEPS));
    group.bench_function(format!("{STEPS} steps"), |bencher| {
        bencher.iter(|| simulation.advance(STEPS).expect("the bed rests"));
    });
    group.finish();
}

criterion_group!(benches, checkpoint);
criterion_main!(benches);
