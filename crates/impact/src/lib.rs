//! One impact from first touch to release, and the speed that pellets withstand.
//!
//! [`ElasticImpact`] is Hertz's impact in closed form: the oracle of the stepper, and what the time step is chosen
//! from. [`Impact`] is any hit in full: damped or viscoelastic, head on or oblique, with its force over time and the
//! curves fitted to it. [`Strength`] and [`SafeSpeed`] turn a crushing strength into an arrival speed.
//! [`CrushTest`] and [`DropFit`] make a strength of a sheet of the laboratory, and [`score()`] broken pellets of hits.

pub mod arrival;
pub mod crush_test;
pub mod damage;
pub mod damping;
pub mod drop_test;
pub mod elastic;
mod error;
pub mod fit;
pub mod fracture_energy;
pub mod goodness;
mod head_on;
pub mod impact;
mod interval;
pub mod oblique;
mod pivots;
pub mod safe_speed;
pub mod scatter;
pub mod score;
mod share_band;
pub mod strength;
pub mod yielding;

pub use arrival::Arrival;
pub use crush_test::{CrushFit, CrushTest};
pub use damping::Damping;
pub use drop_test::{DropFit, DropLevel};
pub use elastic::ElasticImpact;
pub use error::ImpactError;
pub use fit::{BellFit, LogisticFit, SineFit};
pub use fracture_energy::{FractureEnergy, MedianEnergy};
pub use goodness::Goodness;
pub use impact::{Impact, Sample};
pub use interval::Interval;
pub use oblique::{Approach, ObliqueSample, Rebound, Slip};
pub use safe_speed::SafeSpeed;
pub use scatter::{Scatter, ScatterLaw};
pub use score::{Blow, Chance, Score, StrengthLaw, score};
pub use strength::Strength;
