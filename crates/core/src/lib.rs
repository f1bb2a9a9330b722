//! What a touch is and what it does: shapes, materials and contact laws, as pure functions.
//!
//! SI units throughout, always `f64`. This crate knows no threads, files or clocks.

pub mod bounds;
pub mod contact;
pub mod instructions;
pub mod material;
pub mod mesh;
pub mod pose;
pub mod shape;
pub mod solid;

pub use bounds::Bounds;
pub use contact::{Contact, ContactForce, ContactHistory, ContactLaws};
pub use instructions::InstructionSet;
pub use material::{Material, MaterialPair, PairProperties};
pub use mesh::{MeshError, TriangleMesh};
pub use nalgebra::{UnitQuaternion, UnitVector3};
pub use pose::Pose;
pub use shape::{Profile, Shape, ShapeError, Surface};
pub use solid::{Solid, Touches};

/// A point, a direction or a vector in space; the unit is that of its use.
pub type Vec3 = nalgebra::Vector3<f64>;
