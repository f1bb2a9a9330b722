//! Feeders and gates: rates held by mass and by number, and what is refused with its cure.

mod common;

use common::{GRAVITY, floor, run_until, setup, simulation, wall};
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{
    Fill, FillAmount, Inlet, Model, Outlet, Rate, Schedule, Seats, Setup, Simulation,
    SizeDistribution, StepError,
};

const ROUGH: PairProperties = PairProperties {
    restitution: 0.4,
    friction: 0.5,
    rolling_friction: 0.05,
    ..PairProperties::ELASTIC
};

fn cuboid(center: Vec3, half_sides: Vec3) -> Shape {
    Shape::Cuboid { half_sides }.translated(center)
}

/// A feeder of screened ore over an outlet.
fn shaft(rate: Rate) -> Setup {
    let mut setup = setup(ROUGH, ROUGH);
    setup.gravity = GRAVITY;
    setup.pellets[0].size = SizeDistribution::Sieve {
        openings: vec![0.008, 0.010, 0.012, 0.016],
        passing: vec![0.0, 0.1, 0.6, 1.0],
    };
    setup.inlets = vec![Inlet {
        name: "feed".into(),
        pellets: 0,
        region: cuboid(0.5 * Vec3::z(), Vec3::new(0.1, 0.1, 0.05)),
        rate,
        velocity: Vec3::new(0.0, 0.0, -2.0),
        start: 0.0,
        end: f64::INFINITY,
    }];
    setup.outlets = vec![Outlet {
        name: "below".into(),
        region: Shape::HalfSpace {
            point: Vec3::zeros(),
            normal: Vec3::z_axis(),
        },
    }];
    setup
}

#[test]
fn a_feeder_of_screened_ore_holds_its_rate_from_the_first_second_on() {
    // 25 t/h, and 1500 pellets per second, whose mass follows from the screen analysis.
    for rate in [Rate::Mass(25.0 / 3.6), Rate::Count(1500.0)] {
        let setup = shaft(rate);
        let mut simulation = simulation(setup);
        for time in [1.0, 1.3, 1.6] {
            run_until(&mut simulation, time).expect("the shaft is free");
            let fed = simulation.mass_ledger().by_inlet[0];
            let mean_mass = simulation.model().mean_mass(0);
            let (fed, due) = match rate {
                Rate::Mass(rate) => (fed.mass, rate * time),
                Rate::Count(rate) => (fed.mass, rate * time * mean_mass),
            };
            // The mass of 1500 pellets drawn at random scatters by a percent of its own.
            let bound = if matches!(rate, Rate::Mass(_)) {
                0.01
            } else {
                0.03
            };
            assert!(
                (fed / due - 1.0).abs() < bound,
                "{fed} of {due} kg at {time} s"
            );
        }
        let count = simulation.mass_ledger().by_inlet[0].count as f64;
        if let Rate::Count(rate) = rate {
            assert!((count / (1.6 * rate) - 1.0).abs() < 1.0e-3);
        }
    }
}

#[test]
fn a_feeder_that_falls_behind_by_a_percent_stops_the_run_and_says_what_it_could_feed() {
    let mut setup = shaft(Rate::Mass(1.5));
    // A pocket below the feeder takes what comes in more than a second; then it is full.
    setup.walls = vec![
        wall("lid", floor(0.0)),
        wall(
            "pocket",
            Shape::Difference {
                of: Box::new(cuboid(Vec3::zeros(), Vec3::new(0.4, 0.4, 1.0))),
                minus: Box::new(cuboid(Vec3::zeros(), Vec3::new(0.041, 0.041, 2.0))),
            },
        ),
    ];
    setup.outlets.clear();
    setup.inlets[0].region = cuboid(0.2 * Vec3::z(), Vec3::new(0.04, 0.04, 0.03));
    let mut simulation = simulation(setup);
    let error = run_until(&mut simulation, 6.0).expect_err("the pocket fills up");
    let StepError::InletBlocked { fed, due, time, .. } = &error else {
        panic!("{error}");
    };
    assert!(*time > 1.0, "{error}");
    // As soon as a percent is missed, or one of the largest pellets.
    assert!(due - fed < 0.011 * due + 0.01, "{error}");
    let told = error.to_string();
    assert!(
        told.contains("in place of 1.5000 kg/s") && told.contains("widen the region"),
        "{told}"
    );
}

/// A bed that rests on a floor, with a gate through its middle that closes at a moment.
fn gated(closes_at: f64) -> Simulation {
    let mut setup = shaft(Rate::Mass(1.0));
    setup.inlets.clear();
    setup.outlets.clear();
    let mut gate = wall(
        "slide",
        cuboid(0.05 * Vec3::z(), Vec3::new(0.2, 0.2, 0.004)),
    );
    gate.schedule = Schedule::closing_at(vec![closes_at]);
    setup.walls = vec![wall("floor", floor(0.0)), gate];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Deposit {
            region: cuboid(0.1 * Vec3::z(), Vec3::new(0.05, 0.05, 0.09)),
            amount: FillAmount::Count(300),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    simulation(setup)
}

#[test]
fn a_gate_that_closes_onto_pellets_is_named_with_its_moment_and_the_cure() {
    let mut simulation = gated(0.01);
    let error = run_until(&mut simulation, 0.02).expect_err("pellets are in the way");
    assert!(
        matches!(error, StepError::GateClosed { ref wall, .. } if wall == "slide"),
        "{error}"
    );
    let told = error.to_string();
    for part in [
        "wall `slide` closed onto pellets at t = 0.0100",
        "earlier or later",
        "`translating`",
    ] {
        assert!(told.contains(part), "{told}");
    }
}

#[test]
fn a_gate_that_closes_above_the_bed_does_no_harm() {
    // By then the heap has spread out below the gate.
    let mut simulation = gated(0.6);
    run_until(&mut simulation, 0.65).expect("nothing is in the way");
}

/// The only mistake of a setup, as printed.
fn mistake(setup: Setup) -> String {
    let errors = Model::new(setup).expect_err("something is wrong");
    assert_eq!(errors.len(), 1, "{errors:?}");
    errors[0].to_string()
}

#[test]
fn feeders_and_outlets_where_no_pellet_can_be_are_refused_with_the_cure() {
    let mut buried = shaft(Rate::Mass(1.0));
    buried.walls = vec![wall(
        "hood",
        cuboid(0.5 * Vec3::z(), Vec3::new(0.2, 0.2, 0.1)),
    )];
    let told = mistake(buried);
    assert!(
        told.starts_with("inlets.feed.region: the region has no free place")
            && told.contains("wall `hood` takes it up; move"),
        "{told}"
    );

    let mut outside = shaft(Rate::Mass(1.0));
    outside.domain.bounds.max.z = 0.52;
    let told = mistake(outside);
    assert!(
        told.starts_with("inlets.feed.region: reaches to z = 0.55 m, outside of the domain")
            && told.contains("widen `domain`"),
        "{told}"
    );

    let mut beyond = shaft(Rate::Mass(1.0));
    beyond.domain.bounds.min.z = 0.1;
    let told = mistake(beyond);
    assert!(
        told.starts_with("outlets.below.region: the outlet lies outside of the domain")
            && told.contains("widen `domain`"),
        "{told}"
    );
}

#[test]
fn a_wall_in_a_feeder_lowers_the_rate_that_it_can_pass_on() {
    let rate_at_most = |half_width: f64| {
        let mut setup = shaft(Rate::Mass(400.0));
        setup.walls = vec![wall(
            "post",
            cuboid(0.5 * Vec3::z(), Vec3::new(half_width, 0.2, 0.2)),
        )];
        let told = mistake(setup);
        let (_, rate) = told
            .split_once("no faster than ")
            .expect("it tells the rate");
        rate.split_once(" t/h")
            .and_then(|(rate, _)| rate.parse::<f64>().ok())
            .expect("a number")
    };
    // Half of the region is post; 4000 places tell that within 3 %.
    let share = rate_at_most(0.05) / rate_at_most(1.0e-6);
    assert!((share - 0.5).abs() < 0.03, "{share}");
}
