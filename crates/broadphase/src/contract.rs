//! What every search promises: the partners of the oracle, in its order.

use super::{Grid, MeshTree, PeriodicBox, Search, SphereRow, Tree, WallTree};
use pelletflow_core::{Bounds, TriangleMesh, Vec3};
use proptest::prelude::*;

fn lists(search: &Search, count: usize, chunk_size: usize) -> Vec<Vec<u32>> {
    (0..count)
        .map(|index| {
            let first = index / chunk_size * chunk_size;
            let mut partners = Vec::new();
            search.partners_into(index, &(first..first + chunk_size), &mut partners);
            partners
        })
        .collect()
}

fn pellet(width: f64, size_ratio: f64) -> impl Strategy<Value = SphereRow> {
    (0.0..width, 0.0..width, 0.0..width, 0.5..0.5 * size_ratio)
        .prop_map(|(x, y, z, r)| [x, y, z, r])
}

proptest! {
    #[test]
    fn every_search_lists_the_partners_of_the_oracle(
        rows in prop::collection::vec(pellet(9.0, 6.0), 1..120),
        skin in 0.0..0.5_f64,
        chunk_size in 1_usize..40,
    ) {
        let oracle = lists(&Search::AllPairs { rows: &rows, skin, periodic: None }, rows.len(), chunk_size);
        let grid = lists(&Search::Grid(Grid::new(&rows, skin, None)), rows.len(), chunk_size);
        let tree = lists(&Search::Tree(Tree::new(&rows, skin, None)), rows.len(), chunk_size);
        prop_assert_eq!(&grid, &oracle);
        prop_assert_eq!(&tree, &oracle);
    }

    #[test]
    fn every_search_finds_the_partners_across_periodic_borders(
        rows in prop::collection::vec(pellet(9.0, 4.0), 1..120),
        skin in 0.0..0.4_f64,
        chunk_size in 1_usize..40,
        is_periodic in prop::array::uniform3(prop::bool::ANY),
        longer in 0.0..4.0_f64,
    ) {
        // From the narrowest box allowed, of two reaches, on.
        let length = 2.0 * (4.0 + skin) + longer;
        let bounds = Bounds { min: Vec3::repeat(-1.0), max: Vec3::repeat(length - 1.0) };
        let into_box = |&[x, y, z, r]: &SphereRow| {
            let along = |value: f64| value / 9.0 * length - 1.0;
            [along(x), along(y), along(z), r]
        };
        let rows: Vec<SphereRow> = rows.iter().map(into_box).collect();
        let periodic = PeriodicBox::new(&bounds, is_periodic);
        let oracle = lists(&Search::AllPairs { rows: &rows, skin, periodic }, rows.len(), chunk_size);
        let grid = lists(&Search::Grid(Grid::new(&rows, skin, periodic)), rows.len(), chunk_size);
        let tree = lists(&Search::Tree(Tree::new(&rows, skin, periodic)), rows.len(), chunk_size);
        prop_assert_eq!(&grid, &oracle);
        prop_assert_eq!(&tree, &oracle);
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

    #[test]
    fn the_wall_tree_never_misses_a_wall_in_reach(
        corners in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64), 1..8),
        at in (-6.0..6.0_f64, -6.0..6.0_f64, -6.0..6.0_f64),
    ) {
        let bounds: Vec<Bounds> = corners
            .iter()
            .map(|&(x, y, z)| Bounds { min: Vec3::new(x, y, z), max: Vec3::new(x + 1.0, y + 2.0, f64::INFINITY) })
            .collect();
        let center = Vec3::new(at.0, at.1, at.2);
        let mut found = Vec::new();
        WallTree::new(&bounds).near_into(center, 0.5, 0.1, &mut found);
        for (index, bounds) in bounds.iter().enumerate() {
            let nearest = center.sup(&bounds.min).inf(&bounds.max);
            if (nearest - center).norm() < 0.6 {
                prop_assert!(found.contains(&(index as u32)));
            }
        }
    }
}

#[test]
fn a_stray_pellet_far_away_costs_no_memory() {
    let mut rows: Vec<SphereRow> = (0..100)
        .map(|i| [f64::from(i) * 0.9, 0.0, 0.0, 0.5])
        .collect();
    rows.push([1.0e7, 1.0e7, 1.0e7, 0.5]);
    let grid = lists(&Search::Grid(Grid::new(&rows, 0.1, None)), rows.len(), 64);
    let oracle = lists(
        &Search::AllPairs {
            rows: &rows,
            skin: 0.1,
            periodic: None,
        },
        rows.len(),
        64,
    );
    assert_eq!(grid, oracle);
}

#[test]
fn no_pellets_and_no_walls_are_no_trouble() {
    let _ = Grid::new(&[], 0.1, None);
    let _ = Grid::new(&[], 0.0, None);
    let _ = Tree::new(&[], 0.1, None);
    let mut walls = vec![7];
    WallTree::new(&[]).near_into(Vec3::zeros(), 1.0, 0.1, &mut walls);
    assert_eq!(walls, Vec::<u32>::new());
}
