//! One hit on each wall of a setup, where its face, edge, tip and corner are, against the force of a plane.
//!
//! The hits are elastic and by Hertz, without gravity and with the wall at rest, so that what is seen is the wall's geometry
//! and the step, and so that the right answer is known.

mod places;

use crate::error::{SetupError, StepError};
use crate::model::Model;
use crate::motion::Motion;
use crate::schedule::Schedule;
use crate::setup::{Domain, Fill, Limits, Seats, Setup};
use crate::simulation::Simulation;
use crate::size::SizeDistribution;
use crate::wall::Wall;
use pelletflow_core::contact::NormalLaw;
use pelletflow_core::{Bounds, ContactLaws, Vec3};
use pelletflow_impact::ElasticImpact;
use places::{Place, find};
use std::f64::consts::PI;

/// Gap between pellet and wall at the start over the radius [-].
const GAP: f64 = 0.01;
/// Contact times after which a hit that has not ended is given up [-].
const PATIENCE: f64 = 20.0;

/// What of a wall a pellet meets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Spot {
    /// A face, flat or curved.
    Face,
    /// An edge between two faces.
    Edge,
    /// A point where edges meet.
    Tip,
    /// A hollow of two or three faces square to each other.
    Corner,
}

impl Spot {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Face, Self::Edge, Self::Tip, Self::Corner];

    /// Its name, to print.
    pub fn name(self) -> &'static str {
        match self {
            Self::Face => "face",
            Self::Edge => "edge",
            Self::Tip => "tip",
            Self::Corner => "corner",
        }
    }
}

/// One hit on a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallTrial {
    /// What was met.
    pub spot: Spot,
    /// Where, in the wall's frame: the point of the wall that is nearest to the pellet as it starts [m].
    pub place: Vec3,
    /// Greatest normal force [N].
    pub peak_force: f64,
    /// Hertz's greatest force, on a plane or on a wall of the curvature there [N].
    pub expected_force: f64,
    /// Speed after the hit over that before; 1 is right [-].
    pub rebound: f64,
}

impl WallTrial {
    /// Relative error of the force [-].
    pub fn force_error(&self) -> f64 {
        self.peak_force / self.expected_force - 1.0
    }
}

/// A wall and what came of the hits on it, one for each of [`Spot::ALL`].
#[derive(Debug, Clone, PartialEq)]
pub struct WallTrials {
    /// Name of the wall.
    pub wall: String,
    /// The hits; none where the wall has no such spot, or none that was found.
    pub trials: [Option<WallTrial>; Spot::ALL.len()],
}

/// Why a trial came to nothing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TrialError {
    /// The scene of one pellet is refused.
    #[error("a hit on wall `{wall}` cannot be tried: {error}")]
    Setup {
        /// Name of the wall.
        wall: String,
        /// The first mistake.
        error: SetupError,
    },
    /// The hit failed.
    #[error("a hit on wall `{wall}` failed: {error}")]
    Step {
        /// Name of the wall.
        wall: String,
        /// Why.
        error: StepError,
    },
}

impl WallTrials {
    /// Drops a pellet of the first kind onto every wall of a model, at the fastest speed expected.
    ///
    /// # Errors
    /// A hit could not be followed.
    pub fn run(model: &Model) -> Result<Vec<Self>, TrialError> {
        let setup = model.setup();
        (0..setup.walls.len())
            .map(|index| {
                let wall = &setup.walls[index];
                let places = find(&wall.shape, radius(setup), &setup.domain.bounds);
                let mut trials = [None; Spot::ALL.len()];
                for (trial, place) in trials.iter_mut().zip(places) {
                    if let Some(place) = place {
                        *trial = Some(hit(model, index, &place)?);
                    }
                }
                Ok(Self {
                    wall: wall.name.clone(),
                    trials,
                })
            })
            .collect()
    }
}

/// Radius of a pellet of the first kind with their mean volume [m].
fn radius(setup: &Setup) -> f64 {
    (setup.pellets[0].size.mean_volume() * 3.0 / (4.0 * PI)).cbrt()
}

fn hit(model: &Model, wall: usize, place: &Place) -> Result<WallTrial, TrialError> {
    let speed = model.time_step().expected_speed;
    let setup = lone(model.setup(), wall, place, speed);
    let radius = radius(&setup);
    let pair = setup.pair(setup.pellets[0].material, setup.walls[0].material);
    // In a corner each face takes its share of the speed.
    let impact = ElasticImpact {
        effective_youngs_modulus: pair.effective_youngs_modulus,
        effective_radius: place.effective_radius,
        effective_mass: setup.mass(0, radius),
        speed: speed / (place.faces as f64).sqrt(),
    };
    let name = || model.setup().walls[wall].name.clone();
    let refused = |mut errors: Vec<SetupError>| TrialError::Setup {
        wall: name(),
        error: errors.swap_remove(0),
    };
    let model = Model::new(setup).map_err(refused)?;
    let way = GAP * radius * (place.faces as f64).sqrt();
    let time = way / speed + PATIENCE * impact.contact_time();
    let steps = (time / model.time_step().seconds) as u64;
    let mut simulation = Simulation::new(model, 1).map_err(refused)?;
    let mut taken = 0;
    while simulation.contact_statistics().finished < place.faces as u64 && taken < steps {
        simulation.step().map_err(|error| TrialError::Step {
            wall: name(),
            error,
        })?;
        taken += 1;
    }
    let after = simulation.pellets().next().map(|pellet| pellet.velocity);
    Ok(WallTrial {
        spot: place.spot,
        place: place.at,
        peak_force: simulation.contact_statistics().max_force,
        expected_force: impact.peak_force(),
        rebound: after.map_or(0.0, |velocity| velocity.dot(&place.way_out) / speed),
    })
}

/// One pellet on its way to one wall, and nothing else.
fn lone(setup: &Setup, wall: usize, place: &Place, speed: f64) -> Setup {
    let radius = radius(setup);
    let of_pair = setup.pairs.iter().map(|(materials, properties)| {
        let mut elastic = *properties;
        (elastic.restitution, elastic.friction) = (1.0, 0.0);
        (*materials, elastic)
    });
    let mut kind = setup.pellets[0].clone();
    kind.size = SizeDistribution::Single {
        diameter: 2.0 * radius,
    };
    let start = place.start;
    Setup {
        gravity: Vec3::zeros(),
        hits: None,
        pairs: of_pair.collect(),
        pellets: vec![kind],
        laws: ContactLaws {
            normal: NormalLaw::Hertz,
            ..setup.laws
        },
        walls: vec![Wall {
            motion: Motion::Fixed,
            surface_velocity: Vec3::zeros(),
            schedule: Schedule::always(),
            ..setup.walls[wall].clone()
        }],
        fills: vec![Fill {
            name: "trial".into(),
            pellets: 0,
            seats: Seats::Points(vec![start]),
            velocity: -speed * place.way_out,
            spin: Vec3::zeros(),
        }],
        inlets: Vec::new(),
        outlets: Vec::new(),
        meters: Vec::new(),
        domain: Domain::closed(
            Bounds {
                min: start,
                max: start,
            }
            .grown(10.0 * radius),
        ),
        // Whether a hit is too hard for the law is for the run to say; the energy of one step is that of the whole hit.
        limits: Limits {
            overlap_ratio: 0.99,
            energy_residual: 1.0e3,
        },
        skin: None,
        ..setup.clone()
    }
}
