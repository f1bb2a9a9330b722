//! A validated setup, and what follows from it.

use crate::error::SetupError;
use crate::hit::Arrivals;
use crate::neighbors::SkinChoice;
use crate::pellet::PelletKind;
use crate::setup::{Outlet, Rate, Setup};
use crate::size::SizeDistribution;
use crate::time_step::{self, TimeStep};
use crate::validate;
use crate::wall::Wall;
use crate::wall_contacts::LEAST_CURVATURE_SHARE;
use crate::wall_shape::{Touchable, WallShape};
use pelletflow_broadphase::PeriodicBox;
use pelletflow_core::contact::Sampling;
use pelletflow_core::{ContactLaws, InstructionSet, MaterialPair};
use std::f64::consts::PI;

/// A validated setup with what follows from it; a step never changes it.
#[derive(Debug, Clone)]
pub struct Model {
    setup: Setup,
    time_step: TimeStep,
    sampling: Sampling,
    instructions: InstructionSet,
    derived: Derived,
}

/// What follows from a setup and is read in every step.
#[derive(Debug, Clone)]
struct Derived {
    /// Effective values by two kinds of pellets.
    pairs_of_kinds: Vec<MaterialPair>,
    /// Effective values by kind of pellet and wall.
    pairs_with_walls: Vec<MaterialPair>,
    /// By kind [kg].
    mean_masses: Vec<f64>,
    skin: SkinChoice,
    smallest_diameter: f64,
    largest_diameter: f64,
    has_rotation: bool,
    greatest_wall_speed: f64,
    /// The walls, ready to be touched.
    touchables: Vec<Touchable>,
    holding_gap: f64,
    /// Whether a meter watches the contacts with a wall, by wall.
    watched_walls: Vec<bool>,
    periodic: Option<PeriodicBox>,
    arrivals: Arrivals,
}

impl Model {
    /// Validates a setup and derives pair constants and the time step.
    ///
    /// # Errors
    /// Every mistake found, each with the key of the scene that it belongs to.
    pub fn new(setup: Setup) -> Result<Self, Vec<SetupError>> {
        let mistakes = validate::mistakes(&setup);
        if !mistakes.is_empty() {
            return Err(mistakes);
        }
        let time_step = time_step::choose(&setup).map_err(|mistake| vec![mistake])?;
        let mut derived = Derived::new(&setup);
        let held = derived.holding_gap;
        if let SkinChoice::Fixed(skin) = derived.skin
            && skin <= held
        {
            let message = format!(
                "is {skin:.3e} m; expected more than {held:.3e} m, the gap up to which sticky bodies hold on to each other; \
                 leave `skin` out to have it chosen"
            );
            return Err(vec![SetupError::new("contact.skin", message)]);
        }
        let largest = derived.largest_diameter;
        let mistakes = |skin| validate::periodic::mistakes(&setup, largest, skin);
        if !mistakes(derived.skin.widest(held)).is_empty() {
            // What is too near for the widest skin need not be so for a thinner one.
            derived.skin = derived.skin.narrowed();
            let mistakes = mistakes(derived.skin.widest(held));
            if !mistakes.is_empty() {
                return Err(mistakes);
            }
        }
        Ok(Self {
            derived,
            instructions: setup.instructions.unwrap_or_else(InstructionSet::widest),
            sampling: setup.integrator.sampling(time_step.seconds),
            setup,
            time_step,
        })
    }

    /// The setup as asked for.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The time step and the reason for it.
    pub fn time_step(&self) -> &TimeStep {
        &self.time_step
    }

    /// How the extra reach of the neighbor lists is chosen.
    pub(crate) fn skin_choice(&self) -> SkinChoice {
        self.derived.skin
    }

    /// Whether any law turns pellets, or turning is asked for all the same.
    pub fn has_rotation(&self) -> bool {
        self.derived.has_rotation
    }

    /// Smallest diameter that a pellet may have [m].
    pub fn smallest_diameter(&self) -> f64 {
        self.derived.smallest_diameter
    }

    /// Largest diameter that a pellet may have [m].
    pub fn largest_diameter(&self) -> f64 {
        self.derived.largest_diameter
    }

    /// Mass of a pellet of a kind and radius [m]; in [kg].
    pub fn mass(&self, kind: usize, radius: f64) -> f64 {
        self.setup.mass(kind, radius)
    }

    /// Mean mass of the pellets of a kind [kg].
    pub fn mean_mass(&self, kind: usize) -> f64 {
        self.derived.mean_masses[kind]
    }

    /// Pellets that all inlets feed up to a time [s], at their nominal rates [-].
    pub fn fed_until(&self, time: f64) -> f64 {
        let inlets = self.setup.inlets.iter();
        let fed = inlets.map(|inlet| {
            let seconds = (inlet.end.min(time) - inlet.start).max(0.0);
            match inlet.rate {
                Rate::Count(rate) => rate * seconds,
                Rate::Mass(rate) => rate * seconds / self.mean_mass(inlet.pellets),
            }
        });
        // Not `sum`, which is −0 where there is no inlet.
        fed.fold(0.0, |total, fed| total + fed)
    }

    /// How samples of the contact forces stand for steps.
    #[inline]
    pub(crate) fn sampling(&self) -> &Sampling {
        &self.sampling
    }

    /// The vector instructions that the step uses.
    #[inline]
    pub fn instructions(&self) -> InstructionSet {
        self.instructions
    }

    #[inline]
    pub(crate) fn laws(&self) -> ContactLaws {
        self.setup.laws
    }

    /// Whether two pellets may be of different kinds.
    #[inline]
    pub(crate) fn has_many_kinds(&self) -> bool {
        self.setup.pellets.len() > 1
    }

    /// Effective values of two kinds of pellets.
    #[inline]
    pub(crate) fn pair_of_kinds(&self, a: u16, b: u16) -> &MaterialPair {
        let kinds = self.setup.pellets.len();
        &self.derived.pairs_of_kinds[usize::from(a) * kinds + usize::from(b)]
    }

    /// Effective values of a kind of pellet and a wall.
    #[inline]
    pub(crate) fn pair_with_wall(&self, kind: u16, wall: usize) -> &MaterialPair {
        &self.derived.pairs_with_walls[usize::from(kind) * self.setup.walls.len() + wall]
    }

    /// What a wall is made of, in its own frame.
    #[inline]
    pub(crate) fn touchable(&self, wall: usize) -> &Touchable {
        &self.derived.touchables[wall]
    }

    /// Contacts that a pellet may have with a wall at the same time [-].
    #[inline]
    pub(crate) fn touches_at(&self, wall: usize) -> usize {
        self.derived.touchables[wall].most_touches()
    }

    /// Gap up to which some bodies that have touched hold on to each other [m].
    #[inline]
    pub(crate) fn holding_gap(&self) -> f64 {
        self.derived.holding_gap
    }

    /// Whether a meter watches the contacts with a wall.
    #[inline]
    pub(crate) fn is_watched(&self, wall: usize) -> bool {
        self.derived.watched_walls[wall]
    }

    /// The same model, in which no hits are followed.
    #[must_use]
    pub fn without_hits(mut self) -> Self {
        self.setup.hits = None;
        self
    }

    /// Whether every contact is followed from first touch to release.
    #[inline]
    pub(crate) fn follows_hits(&self) -> bool {
        self.setup.hits.is_some()
    }

    /// What arrivals alone make of forces.
    pub(crate) fn arrivals(&self) -> &Arrivals {
        &self.derived.arrivals
    }

    /// The box, where the domain is periodic along some axis.
    #[inline]
    pub(crate) fn periodic(&self) -> Option<PeriodicBox> {
        self.derived.periodic
    }

    /// Greatest speed of any moving wall [m/s].
    pub(crate) fn greatest_wall_speed(&self) -> f64 {
        self.derived.greatest_wall_speed
    }
}

impl Derived {
    fn new(setup: &Setup) -> Self {
        let materials = || setup.pellets.iter().map(|kind| kind.material);
        let diameters = || setup.pellets.iter().map(|kind| &kind.size);
        let smallest_diameter = diameters()
            .map(SizeDistribution::min_diameter)
            .fold(f64::INFINITY, f64::min);
        let largest_diameter = diameters()
            .map(SizeDistribution::max_diameter)
            .fold(0.0, f64::max);
        let pairs_of_kinds: Vec<MaterialPair> = materials()
            .flat_map(|a| materials().map(move |b| setup.pair(a, b)))
            .collect();
        let pairs_with_walls: Vec<MaterialPair> = materials()
            .flat_map(|a| {
                setup
                    .walls
                    .iter()
                    .map(move |wall| setup.pair(a, wall.material))
            })
            .collect();
        let widest = 0.5 * largest_diameter / LEAST_CURVATURE_SHARE;
        let holding_gap = pairs_of_kinds
            .iter()
            .chain(&pairs_with_walls)
            .map(|pair| setup.laws.holding_gap(widest, pair))
            .fold(0.0, f64::max);
        Self {
            pairs_of_kinds,
            pairs_with_walls,
            mean_masses: setup
                .pellets
                .iter()
                .map(|kind| {
                    setup.materials[kind.material].material.density * kind.size.mean_volume()
                })
                .collect(),
            holding_gap,
            watched_walls: (0..setup.walls.len())
                .map(|wall| {
                    setup
                        .meters
                        .iter()
                        .any(|meter| meter.kind.wall() == Some(wall))
                })
                .collect(),
            arrivals: Arrivals::new(setup),
            skin: skin_choice(setup),
            smallest_diameter,
            largest_diameter,
            periodic: PeriodicBox::new(&setup.domain.bounds, setup.domain.is_periodic),
            has_rotation: setup.laws.turns() || !setup.skips.rotation,
            touchables: setup
                .walls
                .iter()
                .map(|wall| Touchable::new(&wall.shape))
                .collect(),
            greatest_wall_speed: setup
                .walls
                .iter()
                .map(|wall| setup.wall_speed(wall))
                .fold(0.0, f64::max),
        }
    }
}

/// How the skin of a setup is chosen.
fn skin_choice(setup: &Setup) -> SkinChoice {
    let of_mean_volume = |kind: &PelletKind| (6.0 / PI * kind.size.mean_volume()).cbrt();
    let finest = setup.pellets.iter().map(of_mean_volume);
    let tuned = SkinChoice::tuned(finest.fold(f64::INFINITY, f64::min));
    // A grid of distances answers for pellets that are near, and its triangles, slowly, for those beyond.
    let is_baked = |wall: &Wall| matches!(wall.shape, WallShape::Baked(_));
    // Between two searches a pellet moves by half the skin, and must not pass an outlet unseen.
    let is_thin = |outlet: &Outlet| {
        let bounds = outlet.region.bounds();
        (bounds.max - bounds.min).min() < tuned.widest(0.0)
    };
    match setup.skin {
        Some(skin) => SkinChoice::Fixed(skin),
        None if setup.walls.iter().any(is_baked) || setup.outlets.iter().any(is_thin) => {
            tuned.narrowed()
        }
        None => tuned,
    }
}
