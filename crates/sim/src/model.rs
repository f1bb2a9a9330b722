//! What a run is made of: the setup as asked for, and the model as validated.

use crate::error::SetupError;
use crate::pellet::PelletKind;
use crate::time_step::{StepRequest, TimeStep};
use crate::wall::Wall;
use pelletflow_core::{Bounds, ContactLaws, Material, MaterialPair, PairProperties, Shape, Vec3};

/// Everything that a user decides about the physics, in SI units and with names resolved to indices.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    /// Seed of every random draw [-].
    pub seed: u64,
    /// Acceleration of gravity [m/s²].
    pub gravity: Vec3,
    /// Materials; the other tables refer to their positions here.
    pub materials: Vec<NamedMaterial>,
    /// Properties of two materials together, by material index, in either order.
    pub pairs: Vec<([usize; 2], PairProperties)>,
    /// Kinds of pellets.
    pub pellets: Vec<PelletKind>,
    /// Contact law, in its three parts.
    pub laws: ContactLaws,
    /// Walls.
    pub walls: Vec<Wall>,
    /// Pellets there at the start.
    pub fills: Vec<Fill>,
    /// Feeders.
    pub inlets: Vec<Inlet>,
    /// Where pellets leave.
    pub outlets: Vec<Outlet>,
    /// What is measured.
    pub meters: Vec<Meter>,
    /// Where pellets may be.
    pub domain: Domain,
    /// How the time step is chosen.
    pub step: StepRequest,
    /// How neighbors are found.
    pub search: NeighborSearch,
    /// Extra reach of a neighbor list [m]; chosen from the pellets where none is given.
    pub skin: Option<f64>,
    /// When a run counts as failed.
    pub limits: Limits,
    /// Work that may be left out.
    pub skips: Skips,
}

/// A material and the name it goes by.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedMaterial {
    /// Name in the scene.
    pub name: String,
    /// Its properties.
    pub material: Material,
}

/// Pellets placed before the first step, on a jittered lattice without overlap.
#[derive(Debug, Clone, PartialEq)]
pub struct Fill {
    /// Name in the scene.
    pub name: String,
    /// Index of the pellet kind [-].
    pub pellets: usize,
    /// Where the pellets are put; each lies wholly inside.
    pub region: Shape,
    /// How many, or how much.
    pub amount: FillAmount,
    /// Velocity at the start [m/s].
    pub velocity: Vec3,
}

/// How much a fill holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FillAmount {
    /// A number of pellets [-].
    Count(usize),
    /// At least this mass, to the next whole pellet [kg].
    Mass(f64),
}

/// A feeder: pellets appear at a rate, at random places of a region.
#[derive(Debug, Clone, PartialEq)]
pub struct Inlet {
    /// Name in the scene.
    pub name: String,
    /// Index of the pellet kind [-].
    pub pellets: usize,
    /// Where pellets appear; each lies wholly inside. Its bounds are finite.
    pub region: Shape,
    /// How fast they come.
    pub rate: Rate,
    /// Velocity as they appear [m/s].
    pub velocity: Vec3,
    /// First moment of feeding [s].
    pub start: f64,
    /// Last moment of feeding [s]; infinite where there is none.
    pub end: f64,
}

/// How fast pellets come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rate {
    /// Mass per time [kg/s].
    Mass(f64),
    /// Pellets per time [1/s].
    Count(f64),
}

/// Where pellets leave: one whose center is inside is discharged.
#[derive(Debug, Clone, PartialEq)]
pub struct Outlet {
    /// Name in the scene.
    pub name: String,
    /// The region.
    pub region: Shape,
}

/// What is measured while the run goes on.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Meter {
    /// Mass discharged through one outlet, and its rate.
    MassFlow {
        /// Name in the scene.
        name: String,
        /// Index of the outlet [-].
        outlet: usize,
    },
    /// Force of all pellets on one wall.
    WallForce {
        /// Name in the scene.
        name: String,
        /// Index of the wall [-].
        wall: usize,
    },
}

impl Meter {
    /// Name in the scene.
    pub fn name(&self) -> &str {
        match self {
            Self::MassFlow { name, .. } | Self::WallForce { name, .. } => name,
        }
    }
}

/// Where pellets may be; one that leaves without an outlet is lost, and the run has failed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Domain {
    /// The box.
    pub bounds: Bounds,
}

/// How neighbors are found; every way gives the same list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NeighborSearch {
    /// The grid for near-equal sizes, the tree for wide ratios.
    #[default]
    Auto,
    /// A grid of cells as wide as the largest pellet.
    Grid,
    /// Parry's tree of boxes.
    Tree,
    /// Every pair; the oracle of the others.
    AllPairs,
}

/// When a run counts as failed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest overlap over the smaller radius of a contact [-].
    pub overlap_ratio: f64,
    /// Largest residual of the energy ledger over the energy that went through it [-].
    pub energy_residual: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            overlap_ratio: 0.3,
            energy_residual: 0.05,
        }
    }
}

/// Work that may be left out because it changes nothing; each can be forced back in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Skips {
    /// No spin where no law acts on it.
    pub rotation: bool,
    /// No wall evaluated for a pellet that cannot reach it.
    pub distant_walls: bool,
}

impl Default for Skips {
    fn default() -> Self {
        Self {
            rotation: true,
            distant_walls: true,
        }
    }
}

/// A validated setup with what follows from it; a step never changes it.
#[derive(Debug, Clone)]
pub struct Model {
    setup: Setup,
    pair_table: Vec<MaterialPair>,
    time_step: TimeStep,
}

impl Model {
    /// Validates a setup and derives pair constants and the time step.
    ///
    /// # Errors
    /// Every mistake found, each with the key of the scene that it belongs to.
    pub fn new(setup: Setup) -> Result<Self, Vec<SetupError>> {
        let _ = &setup;
        Err(Vec::new())
    }

    /// The setup as asked for.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The time step and the reason for it.
    pub fn time_step(&self) -> &TimeStep {
        &self.time_step
    }

    /// Effective values of two materials, by index.
    pub fn pair(&self, a: usize, b: usize) -> &MaterialPair {
        &self.pair_table[a * self.setup.materials.len() + b]
    }
}
