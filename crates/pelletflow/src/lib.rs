//! Multi-body flows of iron-ore pellets: Hertz contact between spheres and signed-distance walls.
//!
//! This crate re-exports the parts; each has a page of its own.
//!
//! ```
//! use pelletflow::core::Material;
//! use pelletflow::impact::ElasticImpact;
//!
//! // How hard does a 15 mm pellet hit a steel plate at 3 m/s?
//! let pellet = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
//! let impact = ElasticImpact {
//!     effective_youngs_modulus: 153.74e6,
//!     effective_radius: 7.5e-3,
//!     effective_mass: pellet.density * 4.0 / 3.0 * std::f64::consts::PI * 7.5e-3_f64.powi(3),
//!     speed: 3.0,
//! };
//! assert_eq!(impact.peak_force().round(), 166.0);
//! ```

pub use pelletflow_broadphase as broadphase;
pub use pelletflow_core as core;
pub use pelletflow_impact as impact;
pub use pelletflow_log as log;
pub use pelletflow_scene as scene;
pub use pelletflow_sim as sim;
