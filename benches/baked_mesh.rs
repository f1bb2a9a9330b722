//! A pellet's question to a wall of triangles, and to the same wall baked: nanoseconds, alternately.
//!
//! Asked as a step does: the triangles near the pellet were listed before.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use pelletflow::broadphase::BakedMesh;
use pelletflow::core::{TriangleMesh, Vec3};
use std::f64::consts::TAU;
use std::hint::black_box;

const RADIUS: f64 = 7.5e-3;
const SKIN: f64 = 1.5e-3;
const SPACING: f64 = 2.0e-3;
const POINTS: usize = 2000;

/// A sphere of 0.25 m about the origin, cut along meridians and half as many parallels.
fn globe(sides: u32) -> TriangleMesh {
    let rows = sides / 2 - 1;
    let mut vertices = vec![-0.25 * Vec3::z(), 0.25 * Vec3::z()];
    for row in 1..=rows {
        let (out, up) = (TAU / 2.0 * f64::from(row) / f64::from(rows + 1)).sin_cos();
        vertices.extend((0..sides).map(|side| {
            let (sine, cosine) = (TAU * f64::from(side) / f64::from(sides)).sin_cos();
            0.25 * Vec3::new(out * cosine, out * sine, -up)
        }));
    }
    let at = |row: u32, side: u32| 2 + row * sides + side % sides;
    let triangles = (0..sides)
        .flat_map(|side| {
            let caps = [
                [0, at(0, side + 1), at(0, side)],
                [1, at(rows - 1, side), at(rows - 1, side + 1)],
            ];
            let belt = (1..rows).flat_map(move |row| {
                let (a, b) = (at(row - 1, side), at(row - 1, side + 1));
                let (c, d) = (at(row, side), at(row, side + 1));
                [[a, b, d], [a, d, c]]
            });
            caps.into_iter().chain(belt)
        })
        .collect();
    TriangleMesh::new(vertices, triangles).expect("a globe is a mesh")
}

/// A box of 0.5 x 0.4 x 0.3 m about the origin.
fn block() -> TriangleMesh {
    let vertices = (0..8_u32)
        .map(|corner| {
            let sign = |axis: u32| f64::from(corner >> axis & 1) * 2.0 - 1.0;
            Vec3::new(0.25 * sign(0), 0.2 * sign(1), 0.15 * sign(2))
        })
        .collect();
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let triangles = quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    TriangleMesh::new(vertices, triangles.collect()).expect("a box is a mesh")
}

fn baked_mesh(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("mesh");
    group.throughput(Throughput::Elements(POINTS as u64));
    for (name, mesh) in [
        ("box", block()),
        ("globe-64", globe(64)),
        ("globe-512", globe(512)),
    ] {
        let baked = BakedMesh::new(mesh.clone(), SPACING, RADIUS + SKIN).expect("it is closed");
        let mut asked: Vec<(Vec3, Vec<u32>)> = Vec::new();
        let mut index = 0_u32;
        while asked.len() < POINTS {
            index += 1;
            let share = |step: f64| (f64::from(index) * step).fract() - 0.5;
            let point = 0.54 * Vec3::new(share(0.819_172), share(0.671_043), share(0.549_700));
            let mut near = Vec::new();
            baked.tree().triangles_near(point, RADIUS + SKIN, &mut near);
            if !near.is_empty() {
                asked.push((point, near));
            }
        }
        for round in 1..=3 {
            group.bench_function(format!("{name}/triangles/{round}"), |bencher| {
                bencher.iter(|| {
                    for (point, near) in &asked {
                        black_box(mesh.touches(near, black_box(*point), RADIUS));
                    }
                });
            });
            group.bench_function(format!("{name}/baked/{round}"), |bencher| {
                bencher.iter(|| {
                    for (point, _) in &asked {
                        black_box(baked.surface_within(black_box(*point), RADIUS));
                    }
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, baked_mesh);
criterion_main!(benches);
