//! What every search promises: the partners of the oracle, in its order.

use super::{Grid, HierarchicalGrid, MeshTree, PeriodicBox, Search, SphereRow, Tree};
use pelletflow_core::{Bounds, TriangleMesh, Vec3};
use proptest::prelude::*;

/// The partners that each pellet lists, with chunks of a size.
fn lists(search: &Search, count: usize, chunk_size: usize) -> Vec<Vec<u32>> {
    let mut lists = Vec::new();
    for first in (0..count).step_by(chunk_size) {
        let chunk = first..(first + chunk_size).min(count);
        // What is there already stays.
        let (mut offsets, mut partners) = (vec![1], vec![7]);
        search.list(&chunk, &mut offsets, &mut partners);
        assert_eq!(offsets.len(), chunk.len() + 1);
        let list = |ends: &[u32]| partners[ends[0] as usize..ends[1] as usize].to_vec();
        lists.extend(offsets.windows(2).map(list));
    }
    lists
}

/// Compares every search with the oracle.
fn assert_all_agree(
    rows: &[SphereRow],
    skin: f64,
    periodic: Option<PeriodicBox>,
    chunk_size: usize,
) {
    let oracle = Search::AllPairs {
        rows,
        skin,
        periodic,
    };
    let oracle = lists(&oracle, rows.len(), chunk_size);
    let searches = [
        Search::Grid(Grid::new(rows, skin, periodic)),
        Search::HierarchicalGrid(HierarchicalGrid::new(rows, skin, periodic)),
        Search::Tree(Tree::new(rows, skin, periodic)),
    ];
    for search in searches {
        assert_eq!(lists(&search, rows.len(), chunk_size), oracle, "{search:?}");
    }
}

/// A pellet in a box; radii are spread evenly over the octaves.
fn pellet(width: f64, size_ratio: f64) -> impl Strategy<Value = SphereRow> {
    (0.0..width, 0.0..width, 0.0..width, 0.0..size_ratio.ln())
        .prop_map(|(x, y, z, log)| [x, y, z, 0.5 * log.exp()])
}

/// Pellets of one size, of sizes 1:10 and of sizes 1:100, about as dense.
fn pellets() -> impl Strategy<Value = Vec<SphereRow>> {
    let among = |width, size_ratio| prop::collection::vec(pellet(width, size_ratio), 0..120);
    prop_oneof![among(6.0, 1.001), among(12.0, 10.0), among(60.0, 100.0)]
}

proptest! {
    #[test]
    fn every_search_lists_the_partners_of_the_oracle(
        rows in pellets(),
        skin in 0.0..0.5_f64,
        chunk_size in 1_usize..40,
    ) {
        assert_all_agree(&rows, skin, None, chunk_size);
    }

    #[test]
    fn every_search_finds_the_partners_across_periodic_borders(
        rows in pellets(),
        skin in 0.0..0.4_f64,
        chunk_size in 1_usize..40,
        is_periodic in prop::array::uniform3(prop::bool::ANY),
        longer in 0.0..2.0_f64,
    ) {
        // From the narrowest box allowed, of two reaches, on.
        let largest = rows.iter().map(|row| row[3]).fold(0.5, f64::max);
        let length = 2.0 * (2.0 * largest + skin) * (1.0 + longer);
        let width = rows.iter().flat_map(|row| row[..3].to_vec()).fold(0.0, f64::max);
        let bounds = Bounds { min: Vec3::repeat(-1.0), max: Vec3::repeat(length - 1.0) };
        let into_box = |&[x, y, z, r]: &SphereRow| {
            let along = |value: f64| value / (1.001 * width) * length - 1.0;
            [along(x), along(y), along(z), r]
        };
        let rows: Vec<SphereRow> = rows.iter().map(into_box).collect();
        assert_all_agree(&rows, skin, PeriodicBox::new(&bounds, is_periodic), chunk_size);
    }

    #[test]
    fn a_pair_is_listed_once_inside_a_chunk_and_twice_across(
        rows in prop::collection::vec(pellet(5.0, 1.5), 2..60),
        chunk_size in 1_usize..20,
    ) {
        let lists = lists(&Search::Grid(Grid::new(&rows, 0.1, None)), rows.len(), chunk_size);
        for (i, partners) in lists.iter().enumerate() {
            for &j in partners {
                let j = j as usize;
                let is_across = i / chunk_size != j / chunk_size;
                prop_assert_eq!(lists[j].contains(&(i as u32)), is_across);
            }
        }
    }

    #[test]
    fn the_mesh_tree_lists_just_the_triangles_in_reach_and_knows_the_nearest(
        corners in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64), 3..40),
        at in (-6.0..6.0_f64, -6.0..6.0_f64, -6.0..6.0_f64),
        reach in 0.1..4.0_f64,
    ) {
        let vertices: Vec<Vec3> = corners.iter().map(|&(x, y, z)| Vec3::new(x, y, z)).collect();
        let triangles: Vec<[u32; 3]> = (2..vertices.len() as u32).map(|last| [last - 2, last - 1, last]).collect();
        let tree = MeshTree::new(TriangleMesh::new(vertices, triangles).expect("no three in a row"));
        let center = Vec3::new(at.0, at.1, at.2);
        let distances: Vec<f64> = tree.mesh().triangles().map(|triangle| triangle.distance(center)).collect();
        let mut found = vec![7];
        tree.triangles_near(center, reach, &mut found);
        let expected = (0..distances.len() as u32).filter(|&index| distances[index as usize] < reach);
        prop_assert_eq!(&found[1..], expected.collect::<Vec<_>>());
        let nearest = distances.iter().copied().fold(f64::INFINITY, f64::min);
        // The boxes are compared by distances of their own rounding.
        prop_assert!((tree.distance(center) - nearest).abs() < 1.0e-12);
    }
}

#[test]
fn a_stray_pellet_far_away_costs_no_memory() {
    let mut rows: Vec<SphereRow> = (0..100)
        .map(|i| [f64::from(i) * 0.9, 0.0, 0.0, 0.5])
        .collect();
    for stray in [1.0e7, -1.0e12, 1.0e100] {
        rows.push([stray, stray, -stray, 0.5]);
        assert_all_agree(&rows, 0.1, None, 64);
    }
}

#[test]
fn pellets_of_one_place_and_pellets_without_size_are_found() {
    assert_all_agree(&[[0.1, 0.2, 0.3, 0.5]; 50], 0.1, None, 16);
    assert_all_agree(&[[0.1, 0.2, 0.3, 0.0]; 50], 0.1, None, 16);
    assert_all_agree(&[[0.1, 0.2, 0.3, 0.0]; 50], 0.0, None, 16);
    let mut rows = vec![[0.1, 0.2, 0.3, 0.0]; 50];
    rows.push([0.1, 0.2, 0.4, 1.0e9]);
    assert_all_agree(&rows, 0.0, None, 16);
}

#[test]
fn no_pellets_and_one_pellet_are_no_trouble() {
    for skin in [0.0, 0.1] {
        assert_all_agree(&[], skin, None, 8);
        assert_all_agree(&[[3.0, -2.0, 1.0, 0.5]], skin, None, 8);
    }
}
