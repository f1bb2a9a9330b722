//! One step in parallel, and all that it owns.
//!
//! Data has three owners: [`Model`] (a step never changes it), [`State`] (all that a restart needs)
//! and [`Workspace`] (scratch: deleting it changes no answer). [`Simulation`] holds the three together.

pub mod error;
pub mod ledger;
pub mod model;
pub mod motion;
pub mod pellet;
pub mod plan;
pub mod schedule;
pub mod simulation;
pub mod time_step;
pub mod wall;

pub use error::{SetupError, StepError};
pub use ledger::{ContactStatistics, EnergyLedger, MassLedger, PelletTally};
pub use model::{
    Domain, Fill, FillAmount, Inlet, Limits, Meter, Model, NamedMaterial, NeighborSearch, Outlet,
    Rate, Setup, Skips,
};
pub use motion::Motion;
pub use pellet::{PelletKind, PelletView, SizeDistribution};
pub use plan::{RunPlan, StopCondition};
pub use schedule::Schedule;
pub use simulation::{MeterReading, Phase, Simulation, Skipped, WallView};
pub use time_step::{StepRequest, TimeStep};
pub use wall::Wall;
