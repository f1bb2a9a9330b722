//! Points on and near a closed mesh at which a baked distance is held against the exact one.

use super::Sides;
use crate::Vec3;
use std::f64::consts::TAU;

/// Points about each of faces, edges and corners [-].
const PROBES: usize = 10_000;
/// Numbers that make one point [-].
const AXES: usize = 6;

/// Points nearer to a mesh than a distance, the same for the same mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Probes {
    /// About points spread evenly over the surface [m].
    pub faces: Vec<Vec3>,
    /// About its edges, the more the sharper they are, and about its corners [m].
    pub edges: Vec<Vec3>,
}

impl Probes {
    /// Points up to `reach` [m] from the mesh; one in four is on it.
    pub fn new(sides: &Sides, reach: f64) -> Self {
        let mesh = sides.mesh();
        let areas = running_sum(mesh.triangles().map(|each| each.area_vector().norm()));
        let lengths = running_sum(
            (0..3 * mesh.indices().len()).map(|edge| sides.sharp_length(edge / 3, edge % 3)),
        );
        let shares = shares();
        let (mut faces, mut edges) = (Vec::new(), Vec::new());
        for index in 0..PROBES {
            let numbers = shares.map(|share| ((index + 1) as f64 * share).fract());
            let [first, second, third, height, turn, far] = numbers;
            // A direction drawn evenly; one point in four stays on the surface.
            let z = 2.0 * height - 1.0;
            let flat = (1.0 - z * z).sqrt();
            let (sine, cosine) = (TAU * turn).sin_cos();
            let away = if index % 4 == 0 { 0.0 } else { far * reach };
            let off = away * Vec3::new(flat * cosine, flat * sine, z);

            let [a, b, c] = mesh.triangle(pick(&areas, first) as u32).corners;
            let root = second.sqrt();
            faces.push((1.0 - root) * a + root * ((1.0 - third) * b + third * c) + off);

            let edge = pick(&lengths, first);
            let corners = mesh.triangle((edge / 3) as u32).corners;
            let (from, to) = (corners[edge % 3], corners[(edge % 3 + 1) % 3]);
            edges.push(from + second * (to - from) + off);
            let corner = (third * (3 * mesh.indices().len()) as f64) as usize;
            edges.push(mesh.triangle((corner / 3) as u32).corners[corner % 3] + off);
        }
        Self { faces, edges }
    }
}

/// Steps of an evenly spread sequence in as many axes (Roberts 2018, the sequence R6).
fn shares() -> [f64; AXES] {
    // The root of x⁷ = x + 1; the iteration gains a digit every other turn.
    let root = (0..60).fold(1.0_f64, |root, _| {
        (1.0 + root).powf(1.0 / (AXES as f64 + 1.0))
    });
    let mut share = 1.0;
    [(); AXES].map(|()| {
        share /= root;
        share
    })
}

fn running_sum(weights: impl Iterator<Item = f64>) -> Vec<f64> {
    weights
        .scan(0.0, |sum, weight| {
            *sum += weight;
            Some(*sum)
        })
        .collect()
}

/// The place at a share of a running sum.
fn pick(sums: &[f64], share: f64) -> usize {
    let sought = share * sums.last().copied().unwrap_or_default();
    sums.partition_point(|&sum| sum <= sought)
        .min(sums.len() - 1)
}
