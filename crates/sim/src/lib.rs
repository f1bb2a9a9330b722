//! One step in parallel, and all that it owns.
//!
//! Data has three owners: [`Model`] (a step never changes it), [`State`] (all that a restart needs)
//! and [`Workspace`] (scratch: deleting it changes no answer). [`Simulation`] holds the three together.

pub mod books;
pub mod error;
pub mod hit;
pub mod integrator;
pub mod ledger;

pub mod memory;
pub mod meter;
pub mod model;
pub mod motion;
pub mod pellet;
pub mod plan;
pub mod schedule;
pub mod setup;
pub mod simulation;
pub mod size;
pub mod skipped;
pub mod snapshot;
pub mod state;
pub mod time_step;
pub mod wall;
pub mod wall_shape;
pub mod wall_trial;
pub mod workspace;

mod advance;
mod chunk;
mod contact_view;
mod deposit;
mod exchange;
mod fill;
mod free_flight;
mod hash;
mod health;
mod inlet;
mod law_needs;
mod neighbors;
mod pair_contacts;
mod profile;
mod random;
mod share;
mod step;
mod tally;
mod validate;
mod wall_contacts;

pub use contact_view::{ContactPartner, ContactView};
pub use error::{SetupError, StepError};
pub use hit::{Cause, Hit, HitClass, HitClassKey, HitLedger, HitPartner, HitRequest};
pub use integrator::Integrator;
pub use ledger::{ContactStatistics, EnergyLedger, MOST_COUNTED, MassLedger, PelletTally};
pub use meter::{
    Heap, MassFlow, Meter, MeterKind, MeterReading, PatchTable, PlaneFlow, Region, Residence,
    WallForce, WallImpacts, Wear,
};
pub use model::Model;
pub use motion::{Interpolation, Motion, MotionTable, Swing};
pub use pellet::{PelletKind, PelletView};
pub use pelletflow_broadphase::{BakeError, BakedMesh, Deviation};
pub use plan::{KeptFrames, RunPlan, StopCondition};
pub use schedule::Schedule;
pub use setup::{
    Domain, Fill, FillAmount, Inlet, Limits, NamedMaterial, NeighborSearch, Outlet, Rate, Seats,
    Setup, Skips,
};
pub use simulation::{Phase, Simulation, WallView};
pub use size::SizeDistribution;
pub use skipped::Skipped;
pub use snapshot::{RestoreError, Snapshot};
pub use state::{Pellets, Row, State};
pub use time_step::{StepRequest, TimeStep};
pub use wall::Wall;
pub use wall_shape::WallShape;
pub use wall_trial::{Spot, TrialError, WallTrial, WallTrials};
pub use workspace::Workspace;
