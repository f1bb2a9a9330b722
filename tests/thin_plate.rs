//! Nothing passes a thin wall: the step chosen is short enough, and one that is not is refused.

mod common;

use common::{RADIUS, floor, one, pellet, setup, sheets, smooth, wall};
use pelletflow::core::contact::NormalLaw;
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{Model, Setup, Simulation, StepError, StepRequest, WallShape};

/// A plate of 2 mm and a sheet without thickness.
fn plates() -> [(&'static str, WallShape); 2] {
    let plate = Shape::Cuboid {
        half_sides: Vec3::new(0.2, 0.2, 0.001),
    };
    [
        ("plate", plate.into()),
        ("mesh", sheets::square(0.4, 16).into()),
    ]
}

/// A pellet on its way to a level wall at 20 m/s, at an angle from its normal [rad].
fn shot(shape: WallShape, angle: f64, height: f64) -> Setup {
    let mut setup = setup(smooth(0.5), smooth(0.5));
    setup.walls = vec![wall("wall", shape)];
    let way = Vec3::new(angle.sin(), 0.0, -angle.cos());
    let from = Vec3::new(0.0, 0.0, height) - 0.02 * way / angle.cos();
    setup.fills = vec![one("shot", from, 20.0 * way)];
    setup
}

/// Whether a pellet ends above the level where it began, or the run says why not.
fn is_stopped(setup: Setup) -> bool {
    let model = Model::new(setup).expect("the setup has no mistakes");
    let steps = (0.004 / model.time_step().seconds) as u64;
    let mut simulation = Simulation::new(model, 1).expect("the fill fits");
    match simulation.advance(steps) {
        Ok(()) => pellet(&simulation, 0).velocity.z > 0.0,
        Err(StepError::Overlap { .. }) => true,
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn a_pellet_at_20_m_per_s_does_not_pass_a_plate_of_2_mm_or_a_mesh_at_the_default_step() {
    for (name, shape) in plates() {
        for angle in [0.0, 0.5, 1.0] {
            // Where in a step it arrives must not matter.
            for offset in 0..5 {
                let height = 1.1 * RADIUS + 2.0e-5 * f64::from(offset);
                let setup = shot(shape.clone(), angle, height);
                assert!(is_stopped(setup), "{name} at {angle} rad");
            }
        }
    }
}

/// A pellet so soft that its longest step by force alone would take it across the wall.
fn soft(shape: WallShape) -> Setup {
    let soft = PairProperties {
        stiffness: Some(300.0),
        ..smooth(0.5)
    };
    let mut setup = shot(shape, 0.0, 1.1 * RADIUS);
    setup.pairs.iter_mut().for_each(|(_, pair)| *pair = soft);
    setup.laws.normal = NormalLaw::Linear;
    setup
}

#[test]
fn a_step_that_would_carry_a_pellet_through_is_refused_with_the_one_that_holds() {
    for (name, shape) in plates() {
        let mut setup = soft(shape);
        setup.step = StepRequest::Fixed(8.0e-4);
        let error = Model::new(setup.clone()).expect_err("it goes 16 mm a step");
        assert_eq!(error[0].key, "time.step");
        // A quarter of the radius at 20 m/s.
        let holds = 0.25 * RADIUS / 20.0;
        let expected = format!("expected at most {holds:.3e} s, or pellets pass thin walls");
        assert!(error[0].message.contains(&expected), "{error:?}");
        setup.step = StepRequest::Fixed(0.999 * holds);
        assert!(is_stopped(setup), "{name}");
    }
}

#[test]
fn the_step_chosen_for_a_soft_pellet_does_not_carry_it_through() {
    for (name, shape) in plates() {
        assert!(is_stopped(soft(shape)), "{name}");
    }
}

#[test]
fn a_scene_of_hard_pellets_has_the_step_that_its_forces_ask_for() {
    let model = Model::new(shot(floor(0.0).into(), 0.0, RADIUS)).expect("no mistakes");
    let reason = &model.time_step().reason;
    assert!(!reason.contains("thin wall"), "{reason}");
}
