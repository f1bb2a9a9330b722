//! Sliding and rolling on a plane, against rigid-body mechanics.

mod common;

use common::{
    GRAVITY, ORE, RADIUS, STEEL, floor, held, one, pellet, setup, simulation, smooth, wall,
};
use pelletflow::core::{MaterialPair, PairProperties, Vec3};
use pelletflow::sim::{PelletView, Simulation};

/// A pellet at rest in its own dent on a plane tilted by an angle [rad], started at a speed down the slope [m/s].
fn on_plane(angle: f64, properties: PairProperties, speed: f64) -> Simulation {
    let mut setup = setup(smooth(1.0), properties);
    setup.gravity = GRAVITY;
    setup.domain.bounds.min = Vec3::repeat(-20.0);
    setup.domain.bounds.max = Vec3::repeat(20.0);
    setup.walls = vec![wall("floor", floor(angle))];
    let (ore, steel) = (
        &setup.materials[ORE].material,
        &setup.materials[STEEL].material,
    );
    let modulus = MaterialPair::new(ore, steel, &properties).effective_youngs_modulus;
    // Hertz's overlap under the pellet's own weight, so that it neither bounces nor sinks.
    let weight = setup.mass(0, RADIUS) * 9.81 * angle.cos();
    let overlap = (0.75 * weight / (modulus * RADIUS.sqrt())).powf(2.0 / 3.0);
    let normal = Vec3::new(angle.sin(), 0.0, angle.cos());
    let downhill = Vec3::new(angle.cos(), 0.0, -angle.sin());
    setup.fills = vec![one("ball", (RADIUS - overlap) * normal, speed * downhill)];
    simulation(setup)
}

fn run(simulation: &mut Simulation, time: f64) -> PelletView {
    let steps = time / simulation.model().time_step().seconds;
    simulation
        .advance(steps as u64)
        .expect("a rolling ball is no trouble");
    pellet(simulation, 0)
}

/// Speed of the pellet's surface at the contact [m/s].
fn slip(ball: &PelletView) -> f64 {
    // The arm is shorter than the radius by half the overlap, 10⁻⁴ of it here.
    (ball.velocity.norm() - RADIUS * ball.spin.norm()).abs()
}

#[test]
fn a_sliding_ball_ends_up_rolling_at_five_sevenths_of_its_speed() {
    let mut worst: f64 = 0.0;
    for speed in [0.5, 1.0, 3.0] {
        let friction = 0.4;
        let properties = PairProperties {
            restitution: 0.5,
            friction,
            rolling_friction: 0.0,
            ..PairProperties::ELASTIC
        };
        let mut simulation = on_plane(0.0, properties, speed);
        let ball = run(&mut simulation, 3.0 * 2.0 * speed / (7.0 * friction * 9.81));
        let error = ball.velocity.x / (speed * 5.0 / 7.0) - 1.0;
        worst = worst.max(error.abs());
    }
    let claim = "a sliding ball rolls at 5/7 of its speed";
    held("rolling", claim, worst, 1.0e-3, "rigid-body mechanics");
}

#[test]
fn sliding_lasts_two_sevenths_of_the_speed_over_friction_and_gravity() {
    let (speed, friction) = (1.0, 0.4);
    let properties = PairProperties {
        restitution: 0.5,
        friction,
        rolling_friction: 0.0,
        ..PairProperties::ELASTIC
    };
    let sliding_time = 2.0 * speed / (7.0 * friction * 9.81);
    let mut simulation = on_plane(0.0, properties, speed);
    let before = run(&mut simulation, 0.98 * sliding_time);
    // Slip falls evenly from the speed to zero.
    assert!((slip(&before) / (0.02 * speed) - 1.0).abs() < 0.05);
    let after = run(&mut simulation, 0.04 * sliding_time);
    assert!(slip(&after) < 1.0e-3 * speed);
}

#[test]
fn a_ball_on_an_incline_slips_just_above_the_angle_that_friction_and_rolling_allow() {
    for rolling_friction in [0.0, 0.1] {
        let friction = 0.2;
        let properties = PairProperties {
            restitution: 0.5,
            friction,
            rolling_friction,
            ..PairProperties::ELASTIC
        };
        // Rolling down, friction must turn the ball: F/N = 2/7 tan(angle) + 5/7 μ_r, at most μ.
        let critical: f64 = 3.5 * friction - 2.5 * rolling_friction;
        let sides = [0.98, 1.02].map(|share| {
            let mut simulation = on_plane((share * critical).atan(), properties, 0.0);
            let ball = run(&mut simulation, 0.5);
            assert!(ball.velocity.norm() > 1.0, "it rolls down");
            slip(&ball) / ball.velocity.norm()
        });
        assert!(
            sides[0] < 1.0e-3,
            "μ_r {rolling_friction}: slips below by {}",
            sides[0]
        );
        assert!(
            sides[1] > 5.0e-3,
            "μ_r {rolling_friction}: rolls above, {}",
            sides[1]
        );
    }
}

#[test]
fn a_rolling_ball_slows_down_by_five_sevenths_of_rolling_friction() {
    let (friction, rolling_friction) = (0.5, 0.05);
    let mut simulation = on_plane(
        0.0,
        PairProperties {
            restitution: 0.5,
            friction,
            rolling_friction,
            ..PairProperties::ELASTIC
        },
        1.0,
    );
    // Sliding ends at v = 5/7 − 2/7 μ_r/μ...; wait for it, then measure.
    let start = run(&mut simulation, 0.2);
    let end = run(&mut simulation, 0.3);
    let slowing = (start.velocity.x - end.velocity.x) / 0.3;
    let exact = 5.0 / 7.0 * rolling_friction * 9.81;
    let claim = "a rolling ball slows by 5/7 of rolling friction";
    held(
        "rolling",
        claim,
        slowing / exact - 1.0,
        2.0e-3,
        "rigid-body mechanics",
    );
}

#[test]
fn a_ball_below_the_angle_of_rolling_friction_stays_where_it_is() {
    let properties = PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.2,
        ..PairProperties::ELASTIC
    };
    let mut simulation = on_plane(0.1_f64.atan(), properties, 0.0);
    let start = pellet(&simulation, 0).position;
    let ball = run(&mut simulation, 1.0);
    // A constant torque has no spring: the ball creeps at the speed that one step's pull gives, 4 · 2.5 g sin Δt.
    let creep = 4.0 * 2.5 * 9.81 * 0.1 * simulation.model().time_step().seconds;
    assert!(
        (ball.position - start).norm() < creep,
        "crept {} m",
        (ball.position - start).norm()
    );
}
