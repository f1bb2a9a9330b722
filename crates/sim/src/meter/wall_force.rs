//! Force and torque of all pellets on one wall.

use super::{Instrument, Values, Watched};
use crate::model::Model;
use crate::setup::Setup;
use crate::state::State;
use pelletflow_core::Vec3;

/// Force and torque of all pellets on one wall, in the last step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallForce {
    /// Index of the wall [-].
    pub wall: usize,
    /// The point of the world that the torque is about; it stays where the wall moves [m].
    pub about: Vec3,
}

impl Instrument for WallForce {
    /// Torque [N·m].
    type Record = Vec3;

    const NAME: &'static str = "wall-force";

    fn mistakes(&self, setup: &Setup) -> Vec<(&'static str, String)> {
        let mut mistakes = super::unknown("wall", self.wall, setup.walls.len());
        mistakes.extend(super::not_finite("about", self.about));
        mistakes
    }

    fn wall(&self) -> Option<usize> {
        Some(self.wall)
    }

    fn watch(&self, record: &mut Vec3, step: &Watched) {
        let torques = step.touches_of(self.wall).map(|touch| {
            let moment = (touch.point - self.about).cross(&touch.force.force);
            moment + touch.force.turning_torque
        });
        *record = torques.fold(Vec3::zeros(), |sum, torque| sum - torque);
    }

    fn values(&self, torque: &Vec3, _model: &Model, state: &State) -> Values {
        let force = state.books.wall_force[self.wall];
        vec![
            ("force_x_n", force.x),
            ("force_y_n", force.y),
            ("force_z_n", force.z),
            ("torque_x_nm", torque.x),
            ("torque_y_nm", torque.y),
            ("torque_z_nm", torque.z),
        ]
    }
}
