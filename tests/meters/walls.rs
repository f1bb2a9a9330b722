//! Force, impacts and wear on walls.

use super::common::{
    GRAVITY, ORE, RADIUS, STEEL, floor, held, one, setup, simulation, smooth, wall,
};
use super::{G, advance_until, column, mass, meter, value};
use pelletflow::core::{MaterialPair, PairProperties, Shape, Vec3};
use pelletflow::sim::{MeterKind, Motion, WallForce, WallImpacts, Wear};

#[test]
fn a_resting_pellet_loads_a_wall_with_its_weight_and_its_arm() {
    let mut setup = setup(smooth(0.5), smooth(0.2));
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.fills = vec![one("ball", Vec3::new(0.3, -0.2, RADIUS), Vec3::zeros())];
    setup.meters = vec![meter(MeterKind::WallForce(WallForce {
        wall: 0,
        about: Vec3::new(0.1, 0.0, 1.0),
    }))];
    let mut simulation = simulation(setup);
    advance_until(&mut simulation, 0.5);
    let weight = mass() * G;
    // What is left of the first bounces.
    let is_near = |quantity: &str, expected: f64| {
        let error = (value(&simulation, quantity) - expected) / weight;
        assert!(
            error.abs() < 1.0e-6,
            "{quantity} is off by {error} of the weight"
        );
    };
    is_near("force_x_n", 0.0);
    is_near("force_z_n", -weight);
    // (0.2, −0.2, z) × (0, 0, −W)
    held(
        "meters",
        "torque of a resting pellet about a point",
        value(&simulation, "torque_x_nm") / (0.2 * weight) - 1.0,
        1.0e-6,
        "weight times arm",
    );
    is_near("torque_y_nm", 0.2 * weight);
    is_near("torque_z_nm", 0.0);
}

pub(super) fn impacts_on(wall: usize) -> MeterKind {
    MeterKind::WallImpacts(WallImpacts {
        wall,
        cell: 0.05,
        least_speed: 0.1,
    })
}

#[test]
fn a_drop_brings_its_potential_energy_to_the_patch_that_it_hits() {
    let mut setup = setup(smooth(0.5), smooth(0.5));
    let fall = 0.4;
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    let start = Vec3::new(0.12, -0.03, RADIUS + fall);
    setup.fills = vec![one("ball", start, Vec3::new(0.5, 0.0, 0.0))];
    setup.meters = vec![meter(impacts_on(0))];
    let mut simulation = simulation(setup);
    let landing = (2.0 * fall / G).sqrt();
    advance_until(&mut simulation, landing + 0.01);
    assert_eq!(value(&simulation, "impacts"), 1.0);
    held(
        "meters",
        "energy that a drop brings to a wall",
        value(&simulation, "normal_energy_j") / (mass() * G * fall) - 1.0,
        // First touch is seen up to a step late, and the pellet falls on meanwhile.
        1.0e-3,
        "m g h",
    );
    let tangential = 0.5 * mass() * 0.25;
    assert!((value(&simulation, "tangential_energy_j") / tangential - 1.0).abs() < 1.0e-12);
    // It lands at x = 0.12 + 0.5 t = 0.263.
    assert_eq!(column(&simulation, "impacts"), [1.0]);
    let x = column(&simulation, "x_m")[0];
    assert!((x - 0.275).abs() < 1.0e-12, "{x}");
    assert!((column(&simulation, "y_m")[0] + 0.025).abs() < 1.0e-12);
    // A face that lies in a plane of the grid belongs to the cells under it.
    assert!((column(&simulation, "z_m")[0] + 0.025).abs() < 1.0e-12);
}

#[test]
fn a_moving_wall_carries_its_patches_and_slow_touches_are_no_impacts() {
    let mut setup = setup(smooth(0.1), smooth(0.1));
    let speed = 2.0;
    let mut plate = wall(
        "plate",
        Shape::Cuboid {
            half_sides: Vec3::new(1.0, 0.5, 0.1),
        }
        .translated(-0.1 * Vec3::z()),
    );
    plate.motion = Motion::Translating {
        velocity: speed * Vec3::x(),
        start: 0.0,
        end: f64::INFINITY,
    };
    setup.walls = vec![plate];
    setup.fills = vec![
        one("fast", Vec3::new(0.02, 0.01, RADIUS + 0.1), -Vec3::z()),
        one(
            "slow",
            Vec3::new(0.02, 0.31, RADIUS + 0.005),
            -0.09 * Vec3::z(),
        ),
    ];
    setup.meters = vec![meter(impacts_on(0))];
    let mut simulation = simulation(setup);
    advance_until(&mut simulation, 0.12);
    assert_eq!(value(&simulation, "impacts"), 1.0);
    let tangential = 0.5 * mass() * speed * speed;
    assert!((value(&simulation, "tangential_energy_j") / tangential - 1.0).abs() < 1.0e-12);
    // After 0.1 s the plate has moved by 0.2 m: 0.02 m of the world are −0.18 m of the plate.
    assert!((column(&simulation, "x_m")[0] + 0.175).abs() < 1.0e-12);
}

pub(super) fn wear(archard: f64, finnie: f64) -> MeterKind {
    MeterKind::Wear(Wear {
        wall: 0,
        cell: 10.0,
        archard,
        finnie,
        least_speed: 0.1,
    })
}

#[test]
fn archards_wear_of_a_sliding_pellet_is_load_times_slip() {
    let friction: f64 = 0.2;
    let rough = PairProperties {
        friction,
        ..smooth(0.5)
    };
    let mut setup = setup(rough, rough);
    // Steeper than tan⁻¹(3.5 μ): it slips while it rolls.
    let angle = 60.0_f64.to_radians();
    setup.gravity = G * Vec3::new(angle.sin(), 0.0, -angle.cos());
    setup.walls = vec![wall("floor", floor(0.0))];
    let load = mass() * G * angle.cos();
    let materials = [ORE, STEEL].map(|index| setup.materials[index].material);
    let pair = MaterialPair::new(&materials[0], &materials[1], &rough);
    let overlap =
        (load / (4.0 / 3.0 * pair.effective_youngs_modulus * RADIUS.sqrt())).powf(2.0 / 3.0);
    setup.fills = vec![one(
        "ball",
        Vec3::new(0.0, 0.0, RADIUS - overlap),
        Vec3::zeros(),
    )];
    let coefficient = 1.0e-12;
    setup.meters = vec![meter(wear(coefficient, 0.0))];
    let mut simulation = simulation(setup);
    let time = 0.3;
    advance_until(&mut simulation, time);
    // A solid ball of m a = m g sin θ − F_t and 2/5 m R² α = F_t R, with F_t = μ m g cos θ.
    let slip = 0.5 * G * (angle.sin() - 3.5 * friction * angle.cos()) * time * time;
    held(
        "meters",
        "Archard's wear of a pellet that slides down an incline",
        value(&simulation, "volume_m3") / (coefficient * load * slip) - 1.0,
        // The arm is shorter than the radius by half of the overlap; the spring loads at first.
        2.0e-3,
        "Archard 1953, V = k F s",
    );
    let work = friction * load * slip;
    assert!((value(&simulation, "sliding_work_j") / work - 1.0).abs() < 2.0e-3);
    assert_eq!(value(&simulation, "impact_volume_m3"), 0.0);
    let depth = value(&simulation, "volume_m3") / 100.0;
    assert!((value(&simulation, "greatest_depth_m") / depth - 1.0).abs() < 1.0e-12);
}

#[test]
fn finnies_wear_of_one_impact_is_that_of_its_angle() {
    let constant = 1.0e-11;
    let speed: f64 = 3.0;
    for (degrees, share) in [
        (
            10.0_f64,
            (2.0 * 10.0_f64.to_radians()).sin() - 3.0 * 10.0_f64.to_radians().sin().powi(2),
        ),
        (45.0, 0.5 / 3.0),
        (90.0, 0.0),
    ] {
        let angle = degrees.to_radians();
        let mut setup = setup(smooth(0.5), smooth(0.5));
        setup.walls = vec![wall("floor", floor(0.0))];
        let velocity = speed * Vec3::new(angle.cos(), 0.0, -angle.sin());
        setup.fills = vec![one("ball", Vec3::new(0.0, 0.0, RADIUS + 0.01), velocity)];
        setup.meters = vec![meter(wear(0.0, constant))];
        let mut simulation = simulation(setup);
        advance_until(&mut simulation, 0.03);
        let found = value(&simulation, "volume_m3") / (constant * mass() * speed * speed);
        held(
            "meters",
            &format!("Finnie's share of the energy of an impact at {degrees}°"),
            found - share,
            // Rounding: nothing acts before first touch.
            1.0e-12,
            "Finnie 1960, f(α)",
        );
    }
}
