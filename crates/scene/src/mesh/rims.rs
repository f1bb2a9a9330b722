//! The edges of a mesh: which triangles meet at each, and where it ends.

use super::Rim;
use pelletflow_core::{Bounds, Vec3};
use std::collections::BTreeMap;

/// The triangles at an edge, each with whether it passes the edge from the lower corner to the higher.
type Beside = Vec<(usize, bool)>;

/// Edges by their two corners, the lower first.
pub(super) struct Edges(BTreeMap<[u32; 2], Beside>);

impl Edges {
    pub(super) fn new(triangles: &[[u32; 3]]) -> Self {
        let mut edges: BTreeMap<[u32; 2], Beside> = BTreeMap::new();
        for (index, corners) in triangles.iter().enumerate() {
            for side in 0..3 {
                let (from, to) = (corners[side], corners[(side + 1) % 3]);
                let ends = [from.min(to), from.max(to)];
                edges.entry(ends).or_default().push((index, from < to));
            }
        }
        Self(edges)
    }

    /// Edges of one triangle only.
    pub(super) fn open(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.0
            .iter()
            .filter(|(_, beside)| beside.len() == 1)
            .map(|(&ends, _)| ends)
    }

    /// Number of edges of more than two triangles [-].
    pub(super) fn crowded(&self) -> usize {
        self.0.values().filter(|beside| beside.len() > 2).count()
    }

    /// Which triangles are to be turned over, so that neighbors have one side: the fewer in each part.
    pub(super) fn turned(&self, triangles: usize) -> Vec<bool> {
        let mut neighbors: Vec<Vec<(usize, bool)>> = vec![Vec::new(); triangles];
        for beside in self.0.values() {
            if let [(a, way), (b, other_way)] = beside[..] {
                neighbors[a].push((b, way == other_way));
                neighbors[b].push((a, way == other_way));
            }
        }
        let mut side: Vec<Option<bool>> = vec![None; triangles];
        for first in 0..triangles {
            if side[first].is_some() {
                continue;
            }
            side[first] = Some(false);
            let mut part = vec![first];
            let mut next = 0;
            while next < part.len() {
                let index = part[next];
                next += 1;
                for &(neighbor, is_against) in &neighbors[index] {
                    if side[neighbor].is_none() {
                        side[neighbor] = side[index].map(|side| side != is_against);
                        part.push(neighbor);
                    }
                }
            }
            let over = part.iter().filter(|&&i| side[i] == Some(true)).count();
            if 2 * over > part.len() {
                for &index in &part {
                    side[index] = side[index].map(|side| !side);
                }
            }
        }
        side.into_iter().map(|side| side == Some(true)).collect()
    }
}

/// Number of connected lines of open edges [-], and the largest of them.
pub(super) fn rims(edges: &Edges, vertices: &[Vec3]) -> (usize, Option<Rim>) {
    let mut along: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for [a, b] in edges.open() {
        along.entry(a).or_default().push(b);
        along.entry(b).or_default().push(a);
    }
    let mut count = 0;
    let mut largest: Option<Rim> = None;
    while let Some((&first, _)) = along.first_key_value() {
        let mut bounds = Bounds::nothing();
        let mut open = vec![first];
        while let Some(vertex) = open.pop() {
            if let Some(next) = along.remove(&vertex) {
                let at = vertices[vertex as usize];
                bounds = bounds.merged(&Bounds { min: at, max: at });
                open.extend(next);
            }
        }
        count += 1;
        let rim = Rim {
            center: (bounds.min + bounds.max) / 2.0,
            size: (bounds.max - bounds.min).norm(),
        };
        if largest.is_none_or(|largest| rim.size > largest.size) {
            largest = Some(rim);
        }
    }
    (count, largest)
}
