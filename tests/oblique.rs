//! Oblique elastic hits of a sphere on a plane of its own material, by every tangential law.
//!
//! Exact values: partial slip of Mindlin and Deresiewicz (1953) by the method of dimensionality reduction (Popov & Heß
//! 2015, chapter 5), solved to 1e-4; the same as Maw, Barber & Fawcett (1976).

mod common;

use common::{ORE, RADIUS, STEEL, floor, held, one, pellet, setup, simulation, wall};
use pelletflow::core::contact::TangentialLaw;
use pelletflow::core::{Material, MaterialPair, PairProperties, Vec3};
use pelletflow::impact::ElasticImpact;
use pelletflow::sim::{SizeDistribution, StepRequest};

/// An elastic hit, and how the surfaces slide before it.
#[derive(Clone, Copy)]
struct Hit {
    law: TangentialLaw,
    poisson_ratio: f64,
    /// Tangential over normal speed and friction, `θ = v_t / (μ v_n)` [-].
    slide: f64,
    /// Steps per contact [-]; those chosen by default where none is given.
    steps: Option<f64>,
    /// Where in a step the sphere first touches [-].
    phase: f64,
}

/// What it comes to, over `μ v_n` [-].
struct Rebound {
    /// Speed of the contact point along the surface.
    slide: f64,
    /// Radius times spin; less than 0 where the sphere rolls on.
    spin: f64,
    /// Energy of sliding and spin after over that before.
    energy: f64,
}

const FRICTION: f64 = 0.3;
const SPEED: f64 = 1.0;

impl Hit {
    fn new(law: TangentialLaw, poisson_ratio: f64, slide: f64) -> Self {
        Self {
            law,
            poisson_ratio,
            slide,
            steps: None,
            phase: 0.4,
        }
    }

    fn run(&self) -> Rebound {
        let properties = PairProperties {
            friction: FRICTION,
            ..PairProperties::ELASTIC
        };
        let mut setup = setup(properties, properties);
        for material in [ORE, STEEL] {
            setup.materials[material].material = Material {
                density: 3700.0,
                youngs_modulus: 200.0e9,
                poisson_ratio: self.poisson_ratio,
            };
        }
        setup.laws.tangential = self.law;
        setup.walls = vec![wall("plane", floor(0.0))];
        if let Some(steps) = self.steps {
            let pair = MaterialPair::new(
                &setup.materials[ORE].material,
                &setup.materials[STEEL].material,
                &properties,
            );
            let hit = ElasticImpact::on_plane(&pair, RADIUS, setup.mass(0, RADIUS), SPEED);
            setup.step = StepRequest::Fixed(hit.contact_time() / steps);
        }
        let unit = FRICTION * SPEED;
        let velocity = Vec3::new(self.slide * unit, 0.0, -SPEED);
        let at = |gap: f64| {
            let mut setup = setup.clone();
            setup.fills = vec![one("sphere", Vec3::new(0.0, 0.0, RADIUS + gap), velocity)];
            simulation(setup)
        };
        let step = at(RADIUS).model().time_step().seconds;
        let mut simulation = at((2.0 + self.phase) * step * SPEED);
        while simulation.contact_statistics().finished == 0 {
            simulation.step().expect("one hit is no trouble");
        }
        let after = pellet(&simulation, 0);
        let (speed, spin) = (after.velocity.x / unit, -RADIUS * after.spin.y / unit);
        Rebound {
            slide: speed + spin,
            spin,
            energy: (speed * speed + 0.4 * spin * spin) / (self.slide * self.slide),
        }
    }
}

/// `θ`, then sliding and spin after the hit over `μ v_n`, exactly, by Poisson's ratio.
const EXACT: [(f64, [[f64; 3]; 6]); 2] = [
    (
        0.3,
        [
            [1.0 / 3.0, 0.053, -0.200],
            [1.0, -0.004, -0.717],
            [2.0, -0.673, -1.909],
            [3.0, -1.392, -3.137],
            [4.0, -1.764, -4.117],
            [5.0, -1.704, -4.789],
        ],
    ),
    (
        0.4,
        [
            [1.0 / 3.0, 0.004, -0.235],
            [1.0, -0.153, -0.824],
            [2.0, -0.848, -2.034],
            [3.0, -1.565, -3.261],
            [4.0, -1.907, -4.219],
            [5.0, -1.784, -4.846],
        ],
    ),
];

fn phases() -> impl Iterator<Item = f64> {
    (0..8).map(|phase| f64::from(phase) / 8.0)
}

/// Greatest error of the spin after a hit, over the spin [-].
fn partial_slip_error(steps: Option<f64>) -> f64 {
    let mut worst: f64 = 0.0;
    for (poisson_ratio, rows) in EXACT {
        for [slide, _, spin] in rows {
            for phase in phases() {
                let hit = Hit {
                    steps,
                    phase,
                    ..Hit::new(TangentialLaw::PartialSlip, poisson_ratio, slide)
                };
                // The slide changes by 7/5 of the spin, so that this is its error over its change too.
                worst = worst.max((hit.run().spin / spin - 1.0).abs());
            }
        }
    }
    worst
}

#[test]
fn partial_slip_has_the_spin_and_slide_of_the_exact_solution() {
    // Ten sliders are within 0.6 % where the step no longer matters.
    let exact = "Mindlin & Deresiewicz 1953, by Popov & Heß 2015";
    held(
        "oblique",
        "spin after an elastic hit by partial slip, 6 angles, ν 0.3 and 0.4, at 160 steps per contact",
        partial_slip_error(Some(160.0)),
        0.01,
        exact,
    );
    // Here the stiff sphere's default is 36 steps per contact.
    held(
        "oblique",
        "spin after an elastic hit by partial slip, 6 angles, ν 0.3 and 0.4, at the default step",
        partial_slip_error(None),
        0.03,
        exact,
    );
}

#[test]
fn the_slide_after_a_hit_is_that_of_the_exact_solution() {
    for (poisson_ratio, rows) in EXACT {
        for [slide, after, _] in rows {
            let hit = Hit {
                steps: Some(160.0),
                ..Hit::new(TangentialLaw::PartialSlip, poisson_ratio, slide)
            };
            let error = (hit.run().slide - after).abs();
            // 1 % of the change.
            assert!(error < 0.01 * (slide - after), "θ = {slide}: {error}");
        }
    }
}

#[test]
fn a_hit_that_slides_throughout_ends_alike_by_every_law() {
    for law in LAWS {
        for slide in [7.5, 10.0, 20.0] {
            let rebound = Hit::new(law, 0.3, slide).run();
            // The impulse of friction is that of the normal force, which the default step meets within 0.1 %.
            assert!(
                (rebound.slide - (slide - 7.0)).abs() < 0.02,
                "{law:?}, θ = {slide}"
            );
            assert!((rebound.spin + 5.0).abs() < 0.02, "{law:?}, θ = {slide}");
        }
    }
}

const LAWS: [TangentialLaw; 3] = [
    TangentialLaw::Coulomb,
    TangentialLaw::Mindlin,
    TangentialLaw::PartialSlip,
];

#[test]
fn no_tangential_law_creates_energy_in_an_elastic_hit() {
    for law in LAWS {
        let mut most = f64::NEG_INFINITY;
        for poisson_ratio in [0.0, 0.1, 0.25, 0.4] {
            for slide in [0.1, 0.3, 0.6, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0] {
                for phase in phases() {
                    let hit = Hit {
                        phase,
                        ..Hit::new(law, poisson_ratio, slide)
                    };
                    most = most.max(hit.run().energy - 1.0);
                }
            }
        }
        // The integrator's own error; a spring that remembers its displacement gains up to 3.6 %.
        let claim = format!("greatest gain of tangential energy in an elastic hit, {law:?}");
        held("oblique", &claim, most.max(0.0), 1.0e-3, "conservation");
    }
}

/// Angle from the normal [°] and tangential restitution of aluminum oxide spheres on glass
/// (Kharaz, Gorham & Salman 2001, Powder Technol. 120, 281–291).
const KHARAZ: [[f64; 2]; 8] = [
    [2.03, 0.794],
    [3.93, 0.745],
    [9.63, 0.673],
    [20.1, 0.596],
    [30.2, 0.688],
    [39.3, 0.772],
    [49.5, 0.847],
    [59.8, 0.902],
];

/// Root mean square error of the tangential restitution against the experiment [-], at default settings.
fn error_against_experiment(law: TangentialLaw) -> f64 {
    let (radius, speed) = (2.5e-3, 3.9);
    let properties = PairProperties {
        restitution: 0.98,
        friction: 0.092,
        ..PairProperties::ELASTIC
    };
    let squares: f64 = KHARAZ
        .iter()
        .map(|[degrees, measured]| {
            let mut setup = setup(properties, properties);
            setup.materials[ORE].material = material(380.0e9, 0.23, 4000.0);
            setup.materials[STEEL].material = material(70.0e9, 0.25, 2500.0);
            setup.pellets[0].size = SizeDistribution::Single {
                diameter: 2.0 * radius,
            };
            setup.laws.tangential = law;
            setup.walls = vec![wall("glass", floor(0.0))];
            let angle = degrees.to_radians();
            let velocity = speed * Vec3::new(angle.sin(), 0.0, -angle.cos());
            let start = Vec3::new(0.0, 0.0, 1.001 * radius);
            setup.fills = vec![one("sphere", start, velocity)];
            let mut simulation = simulation(setup);
            while simulation.contact_statistics().finished == 0 {
                simulation.step().expect("one hit is no trouble");
            }
            let found = pellet(&simulation, 0).velocity.x / velocity.x;
            (found - measured).powi(2)
        })
        .sum();
    (squares / KHARAZ.len() as f64).sqrt()
}

#[test]
fn partial_slip_meets_the_experiment_of_kharaz_and_single_springs_come_near_it() {
    for (law, bound) in [
        (TangentialLaw::PartialSlip, 0.02),
        (TangentialLaw::Coulomb, 0.06),
        (TangentialLaw::Mindlin, 0.1),
    ] {
        held(
            "oblique",
            &format!("tangential restitution of alumina on glass, root mean square error, {law:?}"),
            error_against_experiment(law),
            bound,
            "experiment of Kharaz, Gorham & Salman 2001",
        );
    }
}

fn material(youngs_modulus: f64, poisson_ratio: f64, density: f64) -> Material {
    Material {
        density,
        youngs_modulus,
        poisson_ratio,
    }
}
