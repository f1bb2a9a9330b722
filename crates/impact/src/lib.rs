//! One impact from first touch to release, in closed form.
//!
//! The oracle of the stepper, and what the time step is chosen from.

pub mod elastic;

pub use elastic::ElasticImpact;
