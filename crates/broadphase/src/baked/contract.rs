//! What a baked mesh promises: it is the mesh, but for an error that it states.

use super::{BakeError, BakedMesh, MOST_CELLS_OFF};
use pelletflow_core::mesh::{MOST_MEMORY, SidesError};
use pelletflow_core::{TriangleMesh, Vec3};

/// Rounding of lengths of order 0.1 m [m].
const ROUNDING: f64 = 1.0e-14;
/// Length of a cell [m].
const SPACING: f64 = 0.002;
/// Farthest that a pellet asks [m].
const REACH: f64 = 0.009;

fn mesh(vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> TriangleMesh {
    TriangleMesh::new(vertices, triangles).expect("a mesh")
}

const BOX: [[u32; 3]; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];

fn corners(half: Vec3) -> Vec<Vec3> {
    (0..8_usize)
        .map(|corner| {
            let side = |axis: usize| {
                if corner >> axis & 1 == 0 {
                    -half[axis]
                } else {
                    half[axis]
                }
            };
            Vec3::new(side(0), side(1), side(2))
        })
        .collect()
}

fn block(half: Vec3) -> TriangleMesh {
    mesh(corners(half), BOX.to_vec())
}

/// An octahedron, every face cut in four `times`, with its corners on a sphere.
fn sphere(radius: f64, times: usize) -> TriangleMesh {
    let mut vertices: Vec<Vec3> = [Vec3::x(), Vec3::y(), Vec3::z()]
        .into_iter()
        .flat_map(|axis| [axis, -axis])
        .collect();
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 2, 4],
        [2, 1, 4],
        [1, 3, 4],
        [3, 0, 4],
        [2, 0, 5],
        [1, 2, 5],
        [3, 1, 5],
        [0, 3, 5],
    ];
    for _ in 0..times {
        let mut middles = std::collections::BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                vertices.push((vertices[a as usize] + vertices[b as usize]).normalize());
                vertices.len() as u32 - 1
            })
        };
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    mesh(vertices.iter().map(|at| radius * at).collect(), triangles)
}

fn baked(mesh: TriangleMesh) -> BakedMesh {
    BakedMesh::new(mesh, SPACING, REACH).expect("a closed mesh")
}

/// Points spread evenly over a cube about the origin.
fn points(half_side: f64) -> impl Iterator<Item = Vec3> {
    (1..5000_u32).map(move |index| {
        let share = |step: f64| 2.0 * (f64::from(index) * step).fract() - 1.0;
        half_side * Vec3::new(share(0.819_172), share(0.671_043), share(0.549_700))
    })
}

#[test]
fn before_a_face_the_distance_and_its_normal_are_exact_on_both_sides() {
    let block = baked(block(Vec3::new(0.05, 0.05, 0.03)));
    for point in points(0.04) {
        let height = 0.2 * point.z;
        let center = Vec3::new(point.x, point.y, 0.03 + height);
        // Within the block, other faces are no nearer.
        let surface = block.surface_within(center, 0.0085).expect("within reach");
        assert!((surface.distance - height.abs()).abs() < ROUNDING);
        let normal = 1.0_f64.copysign(height) * Vec3::z();
        // Rounding of distances over the length of a cell.
        assert!((surface.normal - normal).norm() < 1.0e-10, "{surface:?}");
    }
}

#[test]
fn about_a_sphere_the_deviation_is_within_that_of_trilinear_interpolation() {
    let radius = 0.1;
    let sphere = sphere(radius, 5);
    let plane = |corners: [Vec3; 3]| {
        let normal = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
        normal.normalize().dot(&corners[0])
    };
    let sagitta = sphere
        .triangles()
        .map(|triangle| radius - plane(triangle.corners))
        .fold(0.0, f64::max);
    // Cells² over 8 times the sum of second derivatives, which is 2 over the distance from the center; the least of those
    // is that of the farthest corner of a cell. Triangles differ from the sphere by their sagitta, here and at the corners.
    let least_radius = radius - REACH - 2.0 * SPACING;
    let bound = SPACING * SPACING / 8.0 * 2.0 / least_radius + 2.0 * sagitta;
    let baked = baked(sphere);
    let mut seen = 0;
    for point in points(0.11) {
        let exact = baked.tree().distance(point);
        if let Some(surface) = baked.surface_within(point, REACH) {
            seen += 1;
            let off = (surface.distance - exact).abs();
            assert!(off < bound, "{point:?}: {off:e} against {bound:e}");
            let out = point.normalize() * 1.0_f64.copysign(point.norm() - radius);
            // Half a cell of the sphere's turn, and as much of a facet's.
            let is_clear = surface.distance > 2.0 * bound;
            assert!(
                !is_clear || (surface.normal - out).norm() < 0.05,
                "{surface:?}"
            );
        }
    }
    assert!(seen > 500, "{seen}");
    let deviation = baked.deviation(REACH);
    assert!(deviation.greatest < bound, "{deviation:?} {bound:e}");
    assert!(deviation.root_mean_square < deviation.greatest / 2.0);
}

#[test]
fn the_stated_deviation_holds_at_edges_and_corners_and_is_less_than_a_cell() {
    let block = baked(block(Vec3::new(0.051, 0.043, 0.037)));
    let stated = block.deviation(REACH);
    assert!(
        stated.greatest < MOST_CELLS_OFF / 2.0 * SPACING,
        "{stated:?}"
    );
    assert!(
        stated.greatest > 0.1 * SPACING,
        "an edge is rounded: {stated:?}"
    );
    let mut worst: f64 = 0.0;
    for point in points(0.06) {
        if let Some(surface) = block.surface_within(point, REACH) {
            worst = worst.max((surface.distance - block.tree().distance(point)).abs());
        }
    }
    // The points here are others than those of the statement.
    assert!(worst < 1.1 * stated.greatest, "{worst:e} {stated:?}");
}

#[test]
fn half_the_cell_leaves_half_the_deviation_at_edges() {
    let deviation = |spacing: f64| {
        let half = Vec3::new(0.0511, 0.0437, 0.0373);
        let baked = BakedMesh::new(block(half), spacing, REACH).expect("a closed mesh");
        baked.deviation(REACH).greatest
    };
    let ratio = deviation(SPACING) / deviation(SPACING / 2.0);
    // How the edge lies among the cells differs.
    assert!((1.4..2.8).contains(&ratio), "{ratio}");
}

#[test]
fn beyond_what_it_was_baked_for_the_triangles_are_asked() {
    let block = baked(block(Vec3::repeat(0.05)));
    let far = Vec3::new(0.0, 0.01, 0.19);
    assert!(block.surface_within(far, REACH).is_none());
    let surface = block.surface_within(far, 0.2).expect("within reach");
    assert!((surface.distance - 0.14).abs() < ROUNDING);
    assert!((surface.normal - Vec3::z()).norm() < ROUNDING);
    assert!(!block.is_near(far, 0.13) && block.is_near(far, 0.141));
}

#[test]
fn a_mesh_without_two_sides_is_refused_with_the_number_of_edges_and_a_place() {
    let half = Vec3::repeat(0.05);
    let refused = |vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>| {
        BakedMesh::new(mesh(vertices, triangles), SPACING, REACH).err()
    };
    let tray = refused(corners(half), [&BOX[..2], &BOX[4..]].concat());
    let Some(BakeError::Sides(SidesError::Open { edges: 4, at })) = tray else {
        panic!("{tray:?}");
    };
    assert_eq!(at.z, 0.05);
    let mut turned = BOX.to_vec();
    turned[3].swap(0, 1);
    let turned = refused(corners(half), turned);
    assert!(
        matches!(
            turned,
            Some(BakeError::Sides(SidesError::Turned { edges: 3, .. }))
        ),
        "{turned:?}"
    );
    let mut with_fin = corners(half);
    with_fin.push(Vec3::new(0.0, -0.1, -0.1));
    let finned = [&BOX[..], &[[0, 1, 8]]].concat();
    assert!(matches!(
        refused(with_fin, finned),
        Some(BakeError::Sides(SidesError::Open { edges: 2, .. }))
    ));
    // One box inside another, both with their outside out: the space between has two sides at once.
    let nested = [corners(half), corners(half * 0.9)].concat();
    let both: Vec<[u32; 3]> = BOX
        .into_iter()
        .chain(BOX.map(|places| places.map(|place| place + 8)))
        .collect();
    let torn = refused(nested.clone(), both.clone());
    assert!(matches!(torn, Some(BakeError::Torn { .. })), "{torn:?}");
    // A hollow box has its inner faces turned.
    let hollow = [
        &both[..12],
        &both[12..]
            .iter()
            .map(|&[a, b, c]| [a, c, b])
            .collect::<Vec<_>>(),
    ]
    .concat();
    assert_eq!(refused(nested, hollow), None);
}

#[test]
fn a_grid_that_would_fill_the_memory_is_refused_before_it_is_made() {
    for spacing in [1.0e-4, 1.0e-9] {
        let fine = BakedMesh::new(block(Vec3::repeat(5.0)), spacing, REACH);
        let Err(BakeError::TooFine(fine)) = fine else {
            panic!("{spacing}: not refused");
        };
        assert!(fine.bytes > MOST_MEMORY, "{fine:?}");
    }
}

#[test]
fn the_same_mesh_is_baked_to_the_same_bits_and_however_it_is_wound() {
    let once = baked(sphere(0.03, 3));
    let again = baked(sphere(0.03, 3));
    assert_eq!(once.grid, again.grid);
    assert_eq!(once.deviation(REACH), again.deviation(REACH));
    let inside_out: Vec<[u32; 3]> = BOX.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let half = Vec3::new(0.05, 0.04, 0.03);
    let (block, turned) = (baked(block(half)), baked(mesh(corners(half), inside_out)));
    for point in points(0.06) {
        let felt = |baked: &BakedMesh| baked.surface_within(point, REACH);
        assert_eq!(felt(&block), felt(&turned));
    }
}

#[test]
fn a_pellet_that_is_touched_after_a_move_was_near_before() {
    let (skin, mut touched) = (0.001, 0);
    let block = baked(block(Vec3::new(0.05, 0.04, 0.03)));
    for (start, way) in points(0.06).zip(points(1.0).skip(7)) {
        let moved = start + skin * way.normalize();
        for radius in [0.001, 0.004, 0.008] {
            if block.surface_within(moved, radius).is_some() {
                touched += 1;
                assert!(block.is_near(start, radius + skin), "{start:?} {radius}");
            }
        }
    }
    assert!(touched > 1000, "{touched}");
}
