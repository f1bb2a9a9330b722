//! Kinds of pellets, their sizes, and one pellet as others see it.

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

/// How large the pellets of a kind are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SizeDistribution {
    /// All alike.
    Single {
        /// Diameter [m].
        diameter: f64,
    },
    /// Any diameter between two is as likely, by number.
    Uniform {
        /// Smallest diameter [m].
        min_diameter: f64,
        /// Largest diameter [m].
        max_diameter: f64,
    },
}

impl SizeDistribution {
    /// Smallest diameter [m].
    pub fn min_diameter(&self) -> f64 {
        match *self {
            Self::Single { diameter } => diameter,
            Self::Uniform { min_diameter, .. } => min_diameter,
        }
    }

    /// Largest diameter [m].
    pub fn max_diameter(&self) -> f64 {
        match *self {
            Self::Single { diameter } => diameter,
            Self::Uniform { max_diameter, .. } => max_diameter,
        }
    }
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
