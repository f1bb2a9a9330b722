//! What a user asks for, in SI units and with names resolved to indices.

use crate::hit::HitRequest;
use crate::integrator::Integrator;
use crate::meter::Meter;
use crate::pellet::PelletKind;
use crate::time_step::StepRequest;
use crate::wall::Wall;
use pelletflow_core::{
    Bounds, ContactLaws, InstructionSet, Material, MaterialPair, PairProperties, Shape, Vec3,
};

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
    /// How forces become motion.
    pub integrator: Integrator,
    /// How the time step is chosen.
    pub step: StepRequest,
    /// How neighbors are found.
    pub search: NeighborSearch,
    /// Extra reach of a neighbor list [m]; it follows the motion seen where none is given.
    pub skin: Option<f64>,
    /// What is kept of the hits; none are followed where there is nothing.
    pub hits: Option<HitRequest>,
    /// When a run counts as failed.
    pub limits: Limits,
    /// Work that may be left out.
    pub skips: Skips,
    /// Vector instructions; the widest that the machine has where none are asked for. No bit depends on them.
    pub instructions: Option<InstructionSet>,
}

/// A material and the name it goes by.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedMaterial {
    /// Name in the scene.
    pub name: String,
    /// Its properties.
    pub material: Material,
    /// Young's modulus of the real body, where that above is softened to spare steps [Pa].
    pub true_youngs_modulus: Option<f64>,
}

impl NamedMaterial {
    /// The material as it really is.
    pub fn true_material(&self) -> Material {
        Material {
            youngs_modulus: self
                .true_youngs_modulus
                .unwrap_or(self.material.youngs_modulus),
            ..self.material
        }
    }
}

/// Pellets there before the first step.
#[derive(Debug, Clone, PartialEq)]
pub struct Fill {
    /// Name in the scene.
    pub name: String,
    /// Index of the pellet kind [-].
    pub pellets: usize,
    /// Where they are put.
    pub seats: Seats,
    /// Velocity at the start [m/s].
    pub velocity: Vec3,
    /// Spin at the start [rad/s].
    pub spin: Vec3,
}

/// Where the pellets of a fill are put.
#[derive(Debug, Clone, PartialEq)]
pub enum Seats {
    /// On a jittered lattice without overlap, from the bottom up.
    Lattice {
        /// A bounded region; each pellet lies wholly inside.
        region: Shape,
        /// How many, or how much.
        amount: FillAmount,
    },
    /// One after another, each in a low place on those before: a bed that is nearly settled, without overlap.
    Deposit {
        /// A bounded region; each pellet lies wholly inside.
        region: Shape,
        /// How many, or how much.
        amount: FillAmount,
    },
    /// Just here: one pellet about each center [m].
    Points(Vec<Vec3>),
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

/// Where pellets may be; one that leaves without an outlet is lost, and the run has failed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Domain {
    /// The box.
    pub bounds: Bounds,
    /// Axes along which a pellet that leaves the box comes in again at the opposite side.
    pub is_periodic: [bool; 3],
}

impl Domain {
    /// A box that pellets may leave by outlets only.
    pub fn closed(bounds: Bounds) -> Self {
        Self {
            bounds,
            is_periodic: [false; 3],
        }
    }
}

/// How neighbors are found; every way gives the same list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NeighborSearch {
    /// The grid for near-equal sizes, the hierarchical grid for wide ratios.
    #[default]
    Auto,
    /// A grid of cells as wide as the largest pellet.
    Grid,
    /// A grid of cells for each octave of sizes.
    HierarchicalGrid,
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
            energy_residual: 0.2,
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
    /// Many steps at once while no pellet is near anything.
    pub free_flight: bool,
}

impl Default for Skips {
    fn default() -> Self {
        Self {
            rotation: true,
            distant_walls: true,
            free_flight: true,
        }
    }
}

impl Fill {
    /// A box about all its pellets' centers, or about its region [m].
    pub fn bounds(&self) -> Bounds {
        match &self.seats {
            Seats::Lattice { region, .. } | Seats::Deposit { region, .. } => region.bounds(),
            Seats::Points(points) => points
                .iter()
                .map(|&point| Bounds {
                    min: point,
                    max: point,
                })
                .reduce(|a, b| a.merged(&b))
                .unwrap_or(Bounds {
                    min: Vec3::zeros(),
                    max: Vec3::zeros(),
                }),
        }
    }
}

impl Setup {
    /// Mass of a pellet of a kind and radius [m]; in [kg].
    pub fn mass(&self, kind: usize, radius: f64) -> f64 {
        let density = self.materials[self.pellets[kind].material].material.density;
        density * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)
    }

    /// Whether some material is softer in the run than it really is.
    pub fn is_softened(&self) -> bool {
        let mut materials = self.materials.iter();
        materials.any(|named| named.true_material() != named.material)
    }

    /// Measured properties of two materials, by index and in either order.
    pub fn pair_properties(&self, a: usize, b: usize) -> Option<&PairProperties> {
        let is_asked = |pair: &[usize; 2]| *pair == [a, b] || *pair == [b, a];
        self.pairs
            .iter()
            .find(|(pair, _)| is_asked(pair))
            .map(|(_, properties)| properties)
    }

    /// Effective values of two materials of a validated setup.
    pub(crate) fn pair(&self, a: usize, b: usize) -> MaterialPair {
        let properties = self
            .pair_properties(a, b)
            .expect("validation refuses a missing pair");
        MaterialPair::new(
            &self.materials[a].material,
            &self.materials[b].material,
            properties,
        )
    }

    /// Greatest speed of a wall's motion, without its belt [m/s].
    pub(crate) fn wall_speed(&self, wall: &Wall) -> f64 {
        wall.motion
            .greatest_speed(&wall.shape.bounds(), &self.domain.bounds)
    }
}
