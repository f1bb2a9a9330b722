//! A wall of triangles is felt as the surface that they make up.

mod common;

use common::{
    GRAVITY, ORE, RADIUS, STEEL, assert_same_bits, floor, held, one, pellet, setup, sheets,
    simulation, simulation_on, smooth, wall,
};
use pelletflow::core::{MaterialPair, PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::impact::ElasticImpact;
use pelletflow::sim::{Fill, FillAmount, Motion, NeighborSearch, Seats, Setup, Wall, WallShape};

/// A pellet coming down onto a level wall above a place of it, at a speed [m/s].
fn drop_on(shape: impl Into<WallShape>, place: [f64; 2], speed: f64) -> Setup {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.walls = vec![wall("wall", shape)];
    setup.fills = vec![one(
        "drop",
        Vec3::new(place[0], place[1], 1.01 * RADIUS),
        Vec3::new(0.0, 0.0, -speed),
    )];
    setup
}

#[test]
fn a_hit_on_a_face_an_edge_and_a_corner_of_a_cut_plane_has_the_force_of_a_plane() {
    let speed = 3.0;
    let materials = setup(smooth(1.0), smooth(1.0)).materials;
    let pair = MaterialPair::new(
        &materials[ORE].material,
        &materials[STEEL].material,
        &smooth(1.0),
    );
    let mass = 3700.0 * 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3);
    let exact = ElasticImpact::on_plane(&pair, RADIUS, mass, speed).peak_force();
    for (name, cells) in [("coarse", 2_u32), ("fine", 400)] {
        let cell = 0.4 / f64::from(cells);
        let mut worst: f64 = 0.0;
        for place in [
            [0.0, 0.0],
            [0.5 * cell, 0.0],
            [0.5 * cell, 0.5 * cell],
            [0.7 * cell, 0.2 * cell],
            [1.0e-7, 0.4 * cell],
        ] {
            let mut simulation = simulation(drop_on(sheets::square(0.4, cells), place, speed));
            while simulation.contact_statistics().finished == 0 {
                simulation.step().expect("one hit is no trouble");
            }
            let peak = simulation.contact_statistics().max_force;
            worst = worst.max((peak / exact - 1.0).abs());
            let rebound = pellet(&simulation, 0).velocity;
            assert!((rebound.z / speed - 1.0).abs() < 5.0e-3, "{rebound:?}");
            // The way out leans by rounding alone.
            assert!(rebound.xy().norm() < 1.0e-6 * speed, "{rebound:?}");
        }
        let claim = format!("peak force on faces, edges and corners of a {name} mesh of a plane");
        held(
            "meshes",
            &claim,
            worst,
            5.0e-3,
            "Johnson 1985, section 11.4",
        );
    }
}

#[test]
fn a_pellet_rolls_over_the_seams_of_a_mesh_as_over_a_plane() {
    let rolled = |shape: WallShape| {
        let grippy = PairProperties {
            restitution: 0.5,
            friction: 0.5,
            ..PairProperties::ELASTIC
        };
        let mut setup = setup(grippy, grippy);
        setup.gravity = GRAVITY;
        setup.walls = vec![wall("floor", shape)];
        setup.fills = vec![one(
            "roll",
            Vec3::new(-0.1, 0.003, RADIUS),
            Vec3::new(1.0, 0.3, 0.0),
        )];
        setup.domain.bounds.min.z = -0.1;
        let mut simulation = simulation(setup);
        let steps = (0.15 / simulation.model().time_step().seconds) as u64;
        simulation.advance(steps).expect("it rolls");
        pellet(&simulation, 0)
    };
    let plane = rolled(floor(0.0).into());
    assert!(plane.position.x > 0.0, "it has crossed many seams");
    let mesh = rolled(sheets::square(0.4, 133).into());
    // Normals lean by a hundred-millionth where a seam is crossed.
    assert!((plane.position - mesh.position).norm() < 1.0e-7);
    assert!((plane.spin - mesh.spin).norm() < 1.0e-4 * plane.spin.norm());
}

#[test]
fn a_mesh_moves_as_a_solid_does() {
    let motions = [
        Motion::Vibrating {
            swing: None,
            amplitude: Vec3::new(0.0, 0.0, 0.002),
            frequency: 40.0,
        },
        Motion::Translating {
            velocity: Vec3::new(0.0, 0.0, 0.3),
            start: 0.0,
            end: 0.05,
        },
        Motion::Rotating {
            center: Vec3::new(-1.0, 0.0, 0.0),
            axis: UnitVector3::new_normalize(-Vec3::y()),
            rate: 0.5,
            start: 0.0,
            end: 0.06,
        },
    ];
    for motion in motions {
        let carried = |shape: WallShape| {
            let mut setup = setup(smooth(0.6), smooth(0.6));
            setup.gravity = GRAVITY;
            setup.walls = vec![Wall {
                motion: motion.clone(),
                ..wall("floor", shape)
            }];
            setup.fills = vec![one(
                "drop",
                Vec3::new(0.01, 0.02, 1.05 * RADIUS),
                Vec3::zeros(),
            )];
            setup.domain.bounds.min.z = -0.1;
            let mut simulation = simulation(setup);
            let steps = (0.1 / simulation.model().time_step().seconds) as u64;
            simulation.advance(steps).expect("it is carried");
            pellet(&simulation, 0).position
        };
        // Of one size, so that both have the same step.
        let plate = Shape::Cuboid {
            half_sides: Vec3::new(0.2, 0.2, 0.01),
        };
        let solid = carried(plate.translated(Vec3::new(0.0, 0.0, -0.01)).into());
        let mesh = carried(sheets::square(0.4, 40).into());
        assert!(
            (solid - mesh).norm() < 1.0e-6,
            "{motion:?}: {solid:?}, {mesh:?}"
        );
    }
}

/// Pellets in a funnel of triangles that shakes.
fn shaken(search: NeighborSearch) -> Setup {
    let rough = PairProperties {
        restitution: 0.4,
        friction: 0.4,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(rough, rough);
    setup.gravity = GRAVITY;
    setup.search = search;
    setup.walls = vec![Wall {
        motion: Motion::Vibrating {
            swing: None,
            amplitude: Vec3::new(0.001, 0.0, 0.0),
            frequency: 30.0,
        },
        ..wall("funnel", sheets::funnel(96, 0.03, 0.12, 0.15))
    }];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cylinder {
                radius: 0.06,
                half_length: 0.06,
            }
            .translated(Vec3::new(0.0, 0.0, 0.16)),
            amount: FillAmount::Count(250),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    setup.domain.bounds.min = Vec3::new(-0.3, -0.3, -0.1);
    setup.domain.bounds.max = Vec3::new(0.3, 0.3, 0.4);
    setup
}

#[test]
fn pellets_in_a_mesh_have_the_same_bits_for_any_threads_and_any_search() {
    let run = |search, threads, distant_walls| {
        let mut setup = shaken(search);
        setup.skips.distant_walls = distant_walls;
        let mut simulation = simulation_on(setup, threads);
        simulation.advance(6000).expect("they settle");
        assert_eq!(simulation.mass_ledger().inside.count, 250);
        simulation.state_hash()
    };
    assert_same_bits(run);
}

#[test]
fn a_mesh_keeps_the_energy_of_the_pellets_in_it() {
    let mut simulation = simulation(shaken(NeighborSearch::Auto));
    simulation.advance(8000).expect("they settle");
    let energy = simulation.energy_ledger();
    // As in a funnel of a solid.
    assert!(
        energy.residual.abs() < 5.0e-3 * energy.throughput,
        "{energy:?}"
    );
}

#[test]
fn a_fill_that_crosses_a_mesh_is_refused() {
    let mut setup = drop_on(sheets::square(0.4, 8), [0.01, 0.01], 1.0);
    setup.fills = vec![one(
        "drop",
        Vec3::new(0.01, 0.01, 0.5 * RADIUS),
        Vec3::zeros(),
    )];
    let model = pelletflow::sim::Model::new(setup).expect("the setup itself is right");
    let errors = pelletflow::sim::Simulation::new(model, 1).expect_err("it overlaps");
    assert!(
        errors[0].message.contains("overlaps wall `wall`"),
        "{errors:?}"
    );
}
