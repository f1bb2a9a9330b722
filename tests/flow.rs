//! Pellets that come and go: feeders, gates, outlets, losses.

mod common;

use common::{GRAVITY, RADIUS, floor, one, pellet, run_until, setup, simulation, smooth, wall};
use pelletflow::core::{Bounds, PairProperties, Shape, Vec3};
use pelletflow::sim::{
    Domain, Fill, FillAmount, Inlet, Model, Motion, Outlet, Rate, Schedule, Seats, Setup,
    Simulation, StepError, StepRequest,
};

const ROUGH: PairProperties = PairProperties {
    restitution: 0.5,
    friction: 0.5,
    rolling_friction: 0.05,
    ..PairProperties::ELASTIC
};

/// A feeder over an open shaft with an outlet below.
fn shaft(rate: Rate) -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    setup.inlets = vec![Inlet {
        name: "feed".into(),
        pellets: 0,
        region: Shape::Cuboid {
            half_sides: Vec3::new(0.1, 0.1, 0.05),
        }
        .translated(0.5 * Vec3::z()),
        rate,
        velocity: Vec3::new(0.0, 0.0, -2.0),
        start: 0.1,
        end: f64::INFINITY,
    }];
    setup.outlets = vec![Outlet {
        name: "below".into(),
        region: Shape::HalfSpace {
            point: -0.5 * Vec3::z(),
            normal: Vec3::z_axis(),
        },
    }];
    setup
}

#[test]
fn every_pellet_is_inside_or_discharged_at_every_moment() {
    let mut simulation = simulation(shaft(Rate::Mass(6.0)));
    for moment in 1..=10 {
        run_until(&mut simulation, 0.1 * f64::from(moment)).expect("the shaft is free");
        let ledger = simulation.mass_ledger();
        assert_eq!(
            ledger.inserted.count,
            ledger.inside.count + ledger.discharged.count
        );
        assert_eq!(ledger.inside.count, simulation.pellet_count() as u64);
        assert_eq!(ledger.lost.count, 0);
        let residual = ledger.inserted.mass - ledger.inside.mass - ledger.discharged.mass;
        // A thousand sums of 6.5 g, each rounded by 10⁻¹⁶ of the total.
        assert!(residual.abs() < 1.0e-12, "{residual:e} kg");
    }
    assert!(
        simulation.mass_ledger().discharged.count > 300,
        "pellets reached the outlet"
    );
}

#[test]
fn a_feeder_holds_its_rate_within_one_percent() {
    let mass_of_one = shaft(Rate::Mass(1.0)).mass(0, RADIUS);
    for (rate, kg_per_s) in [
        (Rate::Mass(6.0), 6.0),
        (Rate::Count(500.0), 500.0 * mass_of_one),
    ] {
        let mut simulation = simulation(shaft(rate));
        run_until(&mut simulation, 1.1).expect("the shaft is free");
        let fed = simulation.mass_ledger().by_inlet[0].mass;
        assert!(
            (fed / kg_per_s - 1.0).abs() < 0.01,
            "{fed} kg in 1 s for {kg_per_s} kg/s"
        );
    }
}

#[test]
fn no_pellet_is_fed_before_the_start() {
    let mut simulation = simulation(shaft(Rate::Mass(6.0)));
    run_until(&mut simulation, 0.099).expect("nothing happens");
    assert_eq!(simulation.mass_ledger().inserted.count, 0);
}

#[test]
fn a_feeder_that_is_dammed_up_fails_the_run_and_names_itself() {
    let mut setup = shaft(Rate::Mass(1.0));
    // A lid right under the feeder's region.
    setup.walls = vec![wall(
        "lid",
        Shape::HalfSpace {
            point: 0.45 * Vec3::z(),
            normal: Vec3::z_axis(),
        },
    )];
    setup.inlets[0].region = Shape::Cuboid {
        half_sides: Vec3::new(0.04, 0.04, 0.05),
    }
    .translated(0.505 * Vec3::z());
    let ring = Shape::Difference {
        of: Box::new(Shape::Cuboid {
            half_sides: Vec3::new(0.3, 0.3, 1.0),
        }),
        minus: Box::new(Shape::Cuboid {
            half_sides: Vec3::new(0.041, 0.041, 2.0),
        }),
    };
    setup.walls.push(wall("ring", ring));
    let mut simulation = simulation(setup);
    let error = run_until(&mut simulation, 3.0).expect_err("the region fills up");
    assert!(
        matches!(error, StepError::InletBlocked { ref inlet, .. } if inlet == "feed"),
        "{error}"
    );
    assert!(error.to_string().contains("widen the region"));
}

#[test]
fn a_pellet_that_leaves_the_domain_fails_the_run_with_place_and_speed() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.gravity = GRAVITY;
    setup.walls = vec![wall(
        "shelf",
        Shape::Sphere { radius: 0.05 }.translated(Vec3::new(0.5, 0.0, 0.0)),
    )];
    setup.fills = vec![one("stray", Vec3::zeros(), Vec3::zeros())];
    let mut simulation = simulation(setup);
    let error = run_until(&mut simulation, 2.0).expect_err("it falls out below");
    let StepError::Lost {
        position,
        speed,
        nearest_wall,
        ..
    } = &error
    else {
        panic!("{error}")
    };
    // The domain ends at z = −2 m; the search that sees it leave comes within half the skin of 1.5 mm.
    assert!((position.z + 2.0).abs() < 2.0e-3 && position.z < -2.0);
    assert!((speed / (2.0 * 9.81 * 2.0_f64).sqrt() - 1.0).abs() < 1.0e-3);
    assert!(nearest_wall.contains("shelf"));
    assert!(
        error
            .to_string()
            .contains(&format!("at step {}", simulation.step_count()))
    );
    assert_eq!(simulation.mass_ledger().lost.count, 1);
}

#[test]
fn a_gate_holds_until_it_opens_and_then_lets_go() {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    let mut gate = wall("gate", floor(0.0));
    gate.schedule = Schedule::opening_at(vec![0.2]);
    setup.walls = vec![gate];
    setup.fills = vec![one(
        "ball",
        Vec3::new(0.0, 0.0, 1.01 * RADIUS),
        Vec3::zeros(),
    )];
    let mut simulation = simulation(setup);
    run_until(&mut simulation, 0.199).expect("it rests");
    assert!(pellet(&simulation, 0).position.z > 0.99 * RADIUS);
    run_until(&mut simulation, 0.3).expect("it falls");
    let fall = RADIUS - pellet(&simulation, 0).position.z;
    assert!(
        (fall / (0.5 * 9.81 * 0.01) - 1.0).abs() < 0.01,
        "fell {fall} m in 0.1 s"
    );
}

#[test]
fn a_moving_wall_pushes_a_pellet_to_its_own_speed_and_back_again() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    let mut piston = wall("piston", floor(0.0));
    piston.motion = Motion::Translating {
        velocity: 0.5 * Vec3::z(),
        start: 0.0,
        end: f64::INFINITY,
    };
    setup.walls = vec![piston];
    setup.fills = vec![one(
        "ball",
        Vec3::new(0.0, 0.0, 2.0 * RADIUS),
        Vec3::zeros(),
    )];
    let mut simulation = simulation(setup);
    run_until(&mut simulation, 0.1).expect("one hit");
    let ball = pellet(&simulation, 0);
    // An elastic hit by a wall at V leaves a pellet at rest with 2 V.
    assert!((ball.velocity.z - 1.0).abs() < 1.0e-3);
    // The wall did the work of that motion.
    let work = simulation.energy_ledger().wall_work;
    assert!((work / (0.5 * ball.mass) - 1.0).abs() < 5.0e-3, "{work} J");
}

#[test]
fn a_wall_that_turns_drags_a_ball_around_with_its_surface() {
    let mut setup = setup(
        smooth(1.0),
        PairProperties {
            rolling_friction: 0.0,
            ..ROUGH
        },
    );
    setup.gravity = GRAVITY;
    let mut table = wall("table", floor(0.0));
    table.motion = Motion::Rotating {
        center: Vec3::zeros(),
        axis: Vec3::z_axis(),
        rate: 2.0,
        start: 0.0,
        end: f64::INFINITY,
    };
    setup.walls = vec![table];
    setup.fills = vec![one(
        "ball",
        Vec3::new(0.2, 0.0, 0.9999 * RADIUS),
        Vec3::zeros(),
    )];
    let mut simulation = simulation(setup);
    run_until(&mut simulation, 0.05).expect("it is dragged along");
    // While sliding, friction pulls along the surface velocity, (0, 0.4, 0) m/s here: v = μ g t until 2/7 of it.
    let ball = pellet(&simulation, 0);
    assert!(
        (ball.velocity.y / (2.0 / 7.0 * 0.4) - 1.0).abs() < 0.02,
        "{:?}",
        ball.velocity
    );
    assert!(ball.velocity.x.abs() < 0.05);
}

#[test]
fn a_fill_that_overlaps_a_wall_is_refused_with_its_name() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.walls = vec![wall(
        "post",
        Shape::Cylinder {
            radius: 0.05,
            half_length: 0.5,
        },
    )];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::repeat(0.1),
            },
            amount: FillAmount::Count(500),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    let model = Model::new(setup).expect("the setup itself is sound");
    let errors = Simulation::new(model, 1).expect_err("the post is in the way");
    assert_eq!(errors.len(), 1);
    assert!(errors[0].key.starts_with("fill.bed") && errors[0].message.contains("`post`"));
}

#[test]
fn an_inlet_that_cannot_pass_its_rate_on_is_refused_with_the_rate_it_can() {
    let errors = Model::new(shaft(Rate::Mass(500.0))).expect_err("500 kg/s do not fit");
    assert!(
        errors[0].key == "inlets.feed.rate" && errors[0].message.contains("t/h"),
        "{errors:?}"
    );
}

#[test]
fn a_step_forced_too_large_is_refused_with_the_largest_that_holds() {
    let mut setup = shaft(Rate::Mass(1.0));
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.step = StepRequest::Fixed(1.0e-3);
    let errors = Model::new(setup).expect_err("1 ms is longer than a contact");
    assert!(
        errors[0].key == "time.step" && errors[0].message.contains("expected at most"),
        "{errors:?}"
    );
}

#[test]
fn an_explosion_stops_the_run_with_the_bodies_and_the_cure() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.walls = vec![wall("floor", floor(0.0))];
    // The step is chosen for the hits expected; a soft pellet at 60 m/s overlaps too far all the same.
    setup.fills = vec![one(
        "shot",
        Vec3::new(0.0, 0.0, 0.02),
        Vec3::new(0.0, 0.0, -60.0),
    )];
    let mut simulation = simulation(setup);
    let error = simulation.advance(1000).expect_err("it goes too deep");
    assert!(matches!(error, StepError::Overlap { .. }), "{error}");
    assert!(error.to_string().contains("wall `floor`") && error.to_string().contains("stiffen"));
}

#[test]
fn a_pellet_too_fast_for_the_step_stops_the_run_with_its_speed_and_the_cure() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    // It falls through a periodic box for ever, and so faster than from its top to its bottom.
    setup.gravity = 1.0e3 * GRAVITY;
    setup.domain = Domain {
        bounds: Bounds {
            min: Vec3::repeat(-0.2),
            max: Vec3::repeat(0.2),
        },
        is_periodic: [true; 3],
    };
    setup.fills = vec![one("stone", Vec3::zeros(), Vec3::zeros())];
    let mut simulation = simulation(setup);
    let error = simulation.advance(100_000).expect_err("nothing stops it");
    let StepError::StepTooLarge {
        speed,
        limit,
        expected,
        seconds,
        ..
    } = error
    else {
        panic!("{error}")
    };
    assert!(limit > 2.0 * expected, "{error}");
    // Half of its radius a step, at which it could pass a thin wall.
    assert!(
        (limit * seconds / (0.5 * RADIUS) - 1.0).abs() < 1.0e-9,
        "{error}"
    );
    // In free flight it is looked at every 64 steps.
    assert!(speed > limit && speed < 1.1 * limit, "{error}");
    let told = error.to_string();
    for part in [
        "pellet 0 moves at",
        "at step ",
        "t = ",
        "too large beyond",
        "lower `time.peak_force_error` or `time.step`",
    ] {
        assert!(told.contains(part), "{told}");
    }
}
