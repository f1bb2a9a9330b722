//! Flow through planes, times of stay, and what a box holds.

use super::common::{GRAVITY, floor, held, one, setup, simulation, smooth, wall};
use super::{G, advance_until, mass, meter, value};
use pelletflow::core::{Bounds, Shape, Vec3};
use pelletflow::sim::{
    Inlet, MeterKind, Outlet, PlaneFlow, Rate, Region, Residence, Setup, StepRequest,
};

fn plane_at(height: f64, radius: f64) -> MeterKind {
    MeterKind::PlaneFlow(PlaneFlow {
        point: height * Vec3::z(),
        normal: -Vec3::z_axis(),
        radius,
    })
}

/// Pellets fed in the open air, which fall through a plane.
fn rain(step: StepRequest) -> Setup {
    let mut setup = setup(smooth(0.5), smooth(0.5));
    setup.gravity = GRAVITY;
    setup.step = step;
    setup.inlets = vec![Inlet {
        name: "feed".into(),
        pellets: 0,
        region: Shape::Cuboid {
            half_sides: Vec3::new(0.1, 0.1, 0.02),
        }
        .translated(0.5 * Vec3::z()),
        rate: Rate::Mass(1.0),
        velocity: -Vec3::z(),
        start: 0.0,
        end: 0.8,
    }];
    setup.outlets = vec![Outlet {
        name: "below".into(),
        region: floor(0.0).translated(-Vec3::z()),
    }];
    setup.meters = vec![meter(plane_at(0.0, f64::INFINITY))];
    setup
}

#[test]
fn all_that_falls_through_a_plane_was_fed_whatever_the_step() {
    for step in [
        StepRequest::PeakForceError(1.0e-3),
        StepRequest::Fixed(4.0e-5),
    ] {
        let mut simulation = simulation(rain(step));
        advance_until(&mut simulation, 0.75);
        let above = simulation
            .pellets()
            .filter(|pellet| pellet.position.z > 0.0)
            .count();
        let fed = simulation.mass_ledger().inserted.count;
        assert!(
            above > 5 && fed > 40,
            "{above} of {fed} pellets are on their way"
        );
        assert_eq!(
            value(&simulation, "forward_pellets"),
            (fed - above as u64) as f64
        );
        // Steady for half a second: what is fed falls through, to within two pellets in a tenth of a second.
        let flow = value(&simulation, "mass_flow_kg_per_s");
        assert!((flow - 1.0).abs() < 2.0 * mass() / 0.1, "{flow} kg/s");
        advance_until(&mut simulation, 1.2);
        let inserted = simulation.mass_ledger().inserted;
        assert_eq!(value(&simulation, "pellets"), inserted.count as f64);
        assert_eq!(value(&simulation, "backward_pellets"), 0.0);
        // The same masses added one by one.
        assert!((value(&simulation, "mass_kg") / inserted.mass - 1.0).abs() < 1.0e-12);
    }
}

#[test]
fn a_bouncing_pellet_passes_a_plane_to_and_fro() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.fills = vec![one("ball", Vec3::new(0.0, 0.0, 0.1), Vec3::zeros())];
    setup.meters = vec![meter(plane_at(0.05, f64::INFINITY))];
    let mut simulation = simulation(setup);
    // A fall of 92.5 mm takes 0.137 s: three hits, seven ways.
    advance_until(&mut simulation, 6.5 * (2.0 * 0.0925 / G).sqrt());
    let forward = value(&simulation, "forward_pellets");
    assert_eq!(
        forward + value(&simulation, "backward_pellets"),
        7.0 - f64::from(forward < 4.0)
    );
    assert_eq!(
        forward - value(&simulation, "backward_pellets"),
        value(&simulation, "pellets")
    );
}

#[test]
fn a_disc_counts_what_passes_within_it() {
    let mut setup = setup(smooth(1.0), smooth(1.0));
    setup.fills = vec![
        one(
            "slanted in",
            Vec3::new(0.3, 0.0, 0.3),
            Vec3::new(-3.0, 0.0, -4.0),
        ),
        one(
            "slanted out",
            Vec3::new(0.0, 0.2, 0.3),
            Vec3::new(0.0, 3.0, -4.0),
        ),
        one(
            "straight in",
            Vec3::new(0.0, 0.09, 0.1),
            Vec3::new(0.0, 0.0, -4.0),
        ),
        one(
            "straight out",
            Vec3::new(0.0, -0.11, 0.1),
            Vec3::new(0.0, 0.0, -4.0),
        ),
    ];
    setup.meters = vec![meter(plane_at(0.0, 0.1))];
    let mut simulation = simulation(setup);
    advance_until(&mut simulation, 0.1);
    assert!(simulation.pellets().all(|pellet| pellet.position.z < 0.0));
    assert_eq!(value(&simulation, "forward_pellets"), 2.0);
}

#[test]
fn a_pellet_in_free_fall_stays_for_the_root_of_twice_the_height_over_gravity() {
    let mut setup = setup(smooth(0.5), smooth(0.5));
    let fall = 1.0;
    setup.gravity = GRAVITY;
    setup.fills = vec![
        one("high", fall * Vec3::z(), Vec3::zeros()),
        one("low", Vec3::new(0.1, 0.0, fall / 4.0), Vec3::zeros()),
        one("lower", Vec3::new(-0.1, 0.0, fall / 4.0), Vec3::zeros()),
    ];
    setup.outlets = vec![Outlet {
        name: "below".into(),
        region: floor(0.0),
    }];
    setup.meters = vec![meter(MeterKind::Residence(Residence))];
    let mut simulation = simulation(setup);
    advance_until(&mut simulation, 0.4);
    assert_eq!(value(&simulation, "pellets"), 2.0);
    // The age of the one that is still there.
    let age = value(&simulation, "mean_age_inside_s");
    assert!((age - simulation.time()).abs() < 1.0e-12);
    advance_until(&mut simulation, 0.5);
    let whole = (2.0 * fall / G).sqrt();
    let skin = simulation.state().skin;
    held(
        "meters",
        "residence time of a pellet in free fall",
        value(&simulation, "max_s") / whole - 1.0,
        // It is seen to leave within the skin, at a speed of 4.4 m/s.
        skin / (G * whole) / whole,
        "sqrt(2 h / g)",
    );
    // A quarter of the height takes half the time, and twice the share of the skin.
    let late = 2.0 * skin / (G * whole);
    for (quantity, expected) in [
        ("min_s", whole / 2.0),
        ("median_s", whole / 2.0),
        ("mean_s", whole * 2.0 / 3.0),
        ("deviation_s", whole / 2.0 / 3.0_f64.sqrt()),
    ] {
        let error = value(&simulation, quantity) - expected;
        assert!(error.abs() < late, "{quantity} is off by {error} s");
    }
    assert_eq!(value(&simulation, "mean_age_inside_s"), 0.0);
}

#[test]
fn a_box_weighs_its_pellets_and_knows_their_agitation() {
    let mut setup = setup(smooth(0.5), smooth(0.5));
    setup.fills = vec![
        one("left", Vec3::new(-0.05, 0.0, 0.0), Vec3::new(1.0, 0.0, 2.0)),
        one(
            "right",
            Vec3::new(0.05, 0.0, 0.0),
            Vec3::new(1.0, 0.0, -2.0),
        ),
        one(
            "outside",
            Vec3::new(0.15, 0.0, 0.0),
            Vec3::new(9.0, 9.0, 9.0),
        ),
    ];
    setup.meters = vec![meter(MeterKind::Region(Region {
        bounds: Bounds::about_origin(Vec3::new(0.1, 0.05, 0.05)),
    }))];
    let simulation = simulation(setup);
    let volume = 0.2 * 0.1 * 0.1;
    for (quantity, expected) in [
        ("pellets", 2.0),
        ("bulk_density_kg_per_m3", 2.0 * mass() / volume),
        ("solid_fraction", 2.0 * mass() / 3700.0 / volume),
        ("velocity_x_m_per_s", 1.0),
        ("velocity_z_m_per_s", 0.0),
        // Each is 2 m/s off the mean along one of three axes.
        ("granular_temperature_m2_per_s2", 4.0 / 3.0),
    ] {
        let error = value(&simulation, quantity) - expected;
        assert!(
            error.abs() <= 1.0e-12 * expected,
            "{quantity} is off by {error}"
        );
    }
}
