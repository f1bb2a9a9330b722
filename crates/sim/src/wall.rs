//! Walls: a shape with a material, a motion, a belt speed and a schedule.

use crate::motion::Motion;
use crate::schedule::Schedule;
use pelletflow_core::{Shape, Vec3};
use serde::{Deserialize, Serialize};

/// A piece of equipment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// Name in the scene.
    pub name: String,
    /// Index of its material [-].
    pub material: usize,
    /// Its solid, in its own frame, which is the world's before it moves.
    pub shape: Shape,
    /// How it moves.
    pub motion: Motion,
    /// Velocity of its surface beside its motion, as of a belt; only the part along the surface acts [m/s].
    pub surface_velocity: Vec3,
    /// When it is there.
    pub schedule: Schedule,
}
