//! Kinds of pellets, their sizes, and one pellet as others see it.

use crate::size::SizeDistribution;
use pelletflow_core::Vec3;
use serde::{Deserialize, Serialize};

/// Pellets that share a material and a size distribution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PelletKind {
    /// Name in the scene.
    pub name: String,
    /// Index of the material [-].
    pub material: usize,
    /// Sizes.
    pub size: SizeDistribution,
}

/// One pellet at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PelletView {
    /// Permanent number, counted from 0 in order of insertion [-].
    pub id: u32,
    /// Index of its kind [-].
    pub kind: usize,
    /// Radius [m].
    pub radius: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Center, in the world [m].
    pub position: Vec3,
    /// Velocity [m/s].
    pub velocity: Vec3,
    /// Spin [rad/s].
    pub spin: Vec3,
    /// Greatest normal force of its contacts in the last step [N].
    pub max_normal_force: f64,
}
