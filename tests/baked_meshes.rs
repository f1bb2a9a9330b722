//! A baked mesh holds pellets as its triangles do, but for the error that it states.

mod common;

use common::{
    GRAVITY, ORE, RADIUS, STEEL, assert_same_bits, held, one, pellet, setup, sheets, simulation,
    simulation_on, smooth, wall,
};
use pelletflow::core::{MaterialPair, PairProperties, Shape, TriangleMesh, Vec3};
use pelletflow::impact::ElasticImpact;
use pelletflow::sim::{BakedMesh, Fill, FillAmount, NeighborSearch, Seats, Setup, WallShape};

/// Length of a cell [m].
const SPACING: f64 = 2.0e-3;

fn baked(mesh: TriangleMesh) -> BakedMesh {
    BakedMesh::new(mesh, SPACING, 1.2 * RADIUS).expect("a closed mesh")
}

#[test]
fn a_hit_on_a_baked_face_has_the_force_of_a_plane_from_outside_and_from_inside() {
    let speed = 3.0;
    let materials = setup(smooth(1.0), smooth(1.0)).materials;
    let pair = MaterialPair::new(
        &materials[ORE].material,
        &materials[STEEL].material,
        &smooth(1.0),
    );
    let mass = 3700.0 * 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3);
    let exact = ElasticImpact::on_plane(&pair, RADIUS, mass, speed).peak_force();
    let half = Vec3::new(0.1, 0.1, 0.0503);
    for (side, claim) in [
        (1.0, "from outside of a baked box"),
        (-1.0, "from inside of a baked box"),
    ] {
        let mut setup = setup(smooth(1.0), smooth(1.0));
        setup.walls = vec![wall("box", baked(sheets::block(half)))];
        let place = Vec3::new(0.0007, 0.013, half.z + 1.01 * side * RADIUS);
        setup.fills = vec![one("drop", place, Vec3::new(0.0, 0.0, -side * speed))];
        let mut simulation = simulation(setup);
        while simulation.contact_statistics().finished == 0 {
            simulation.step().expect("one hit is no trouble");
        }
        let peak = simulation.contact_statistics().max_force;
        // The step is chosen for 0.1 %.
        held(
            "baked-meshes",
            claim,
            (peak / exact - 1.0).abs(),
            5.0e-3,
            "Johnson 1985, section 11.4",
        );
        let rebound = pellet(&simulation, 0).velocity;
        assert!(
            (rebound.z - side * speed).abs() < 5.0e-3 * speed,
            "{rebound:?}"
        );
        assert!(rebound.xy().norm() < 1.0e-9 * speed, "{rebound:?}");
    }
}

#[test]
fn a_baked_distance_is_off_by_less_than_half_the_diagonal_of_a_cell() {
    for (name, mesh) in [
        (
            "box of 500 x 400 x 300 mm",
            sheets::block(Vec3::new(0.25, 0.2, 0.15)),
        ),
        (
            "sphere of 500 mm in 3,968 triangles",
            sheets::globe(0.25, 64),
        ),
    ] {
        let stated = baked(mesh).deviation(RADIUS);
        for (kind, off) in [
            ("greatest", stated.greatest),
            ("root mean square", stated.root_mean_square),
        ] {
            held(
                "baked-meshes",
                &format!("{name} in cells of 2 mm, {kind} deviation over the cell"),
                off / SPACING,
                3.0_f64.sqrt() / 2.0,
                "a distance changes by no more than the way",
            );
        }
    }
}

#[test]
fn a_pellet_rests_on_a_baked_sphere_within_the_stated_deviation() {
    let damped = PairProperties {
        restitution: 0.1,
        ..PairProperties::ELASTIC
    };
    let rest = |shape: WallShape| {
        let mut setup = setup(damped, damped);
        setup.gravity = GRAVITY;
        setup.walls = vec![wall("bowl", shape)];
        setup.fills = vec![one(
            "drop",
            Vec3::new(0.0, 0.0, -0.1 + 1.05 * RADIUS),
            Vec3::zeros(),
        )];
        let mut simulation = simulation(setup);
        let steps = (0.2 / simulation.model().time_step().seconds) as u64;
        simulation.advance(steps).expect("it comes to rest");
        pellet(&simulation, 0).position.z
    };
    let bowl = sheets::globe(0.1, 96);
    let baked = baked(bowl.clone());
    let stated = baked.deviation(RADIUS).greatest;
    let off = (rest(baked.into()) - rest(bowl.into())).abs();
    // Contacts with one or with several facets give way differently, by less than a hundredth of that.
    assert!(off < 1.1 * stated, "{off:e} against {stated:e}");
}

/// Pellets in a box without a way out.
fn boxed(shape: WallShape, search: NeighborSearch) -> Setup {
    let rough = PairProperties {
        restitution: 0.4,
        friction: 0.4,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(rough, rough);
    setup.gravity = GRAVITY;
    setup.search = search;
    setup.walls = vec![wall("box", shape)];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::new(0.06, 0.05, 0.07),
            },
            amount: FillAmount::Count(200),
        },
        velocity: Vec3::new(0.5, 0.3, 0.0),
        spin: Vec3::zeros(),
    }];
    setup
}

#[test]
fn pellets_in_a_baked_mesh_have_the_same_bits_for_any_threads_and_any_search() {
    let half = Vec3::new(0.07, 0.06, 0.08);
    let run = |search, threads, distant_walls| {
        let mut setup = boxed(baked(sheets::block(half)).into(), search);
        setup.skips.distant_walls = distant_walls;
        let mut simulation = simulation_on(setup, threads);
        simulation.advance(4000).expect("they settle");
        simulation.state_hash()
    };
    assert_same_bits(run);
}

#[test]
fn pellets_stay_in_a_baked_box_and_their_energy_is_kept() {
    let half = Vec3::new(0.07, 0.06, 0.08);
    let mut simulation = simulation(boxed(
        baked(sheets::block(half)).into(),
        NeighborSearch::Auto,
    ));
    simulation.advance(8000).expect("they settle");
    for id in 0..200 {
        let at = pellet(&simulation, id).position.abs();
        let inside = half.add_scalar(-0.9 * RADIUS);
        assert!(
            at.x < inside.x && at.y < inside.y && at.z < inside.z,
            "{at:?}"
        );
    }
    let energy = simulation.energy_ledger();
    // As among triangles.
    assert!(
        energy.residual.abs() < 5.0e-3 * energy.throughput,
        "{energy:?}"
    );
}
