//! One pellet thrown up in an empty box.

use crate::bed;
use crate::places::Place;
use pelletflow::core::{Bounds, Vec3};
use pelletflow::sim::{Domain, Setup, StepRequest};

/// Velocity at the start [m/s].
const VELOCITY: Vec3 = Vec3::new(1.0, 0.0, 9.81);
/// Time step: a million of them end where the throw began [s].
const TIME_STEP: f64 = 2.0e-6;

pub(crate) fn setup() -> Setup {
    let mut setup = bed::setup([1, 1]);
    setup.walls.clear();
    setup.domain = Domain::closed(Bounds::about_origin(Vec3::repeat(10.0)));
    setup.step = StepRequest::Fixed(TIME_STEP);
    setup
}

/// The pellet at the start.
pub(crate) fn pellet() -> Place {
    Place {
        position: Vec3::zeros(),
        velocity: VELOCITY,
    }
}

/// How far a pellet is from where a throw ends after a time [s], over the length of its way [-].
pub(crate) fn error(position: Vec3, time: f64, gravity: Vec3) -> f64 {
    let exact = time * VELOCITY + 0.5 * time * time * gravity;
    (position - exact).norm() / (VELOCITY.norm() * time)
}
