//! Tangential restitution of a sphere against the angle at which it comes, by every tangential law, beside the experiment
//! of Kharaz, Gorham & Salman (2001, Powder Technol. 120, 281–291).
//!
//! `cargo run --release --example oblique_hits -- picture.svg`

use pelletflow::core::contact::{ContactLaws, TangentialLaw};
use pelletflow::core::{Bounds, Material, PairProperties, Shape, UnitVector3, Vec3};
use pelletflow::log::plot::{Axis, Chart, Series, SeriesStyle};
use pelletflow::sim::{
    Domain, Fill, Integrator, Limits, Model, Motion, NamedMaterial, NeighborSearch, PelletKind,
    Schedule, Seats, Setup, Simulation, SizeDistribution, Skips, StepRequest, Wall,
};
use std::error::Error;

/// Aluminum oxide spheres [m].
const RADIUS: f64 = 2.5e-3;
/// Speed at any angle [m/s].
const SPEED: f64 = 3.9;

/// Angle from the normal [°] and tangential restitution [-], as measured.
const MEASURED: [[f64; 2]; 8] = [
    [2.03, 0.794],
    [3.93, 0.745],
    [9.63, 0.673],
    [20.1, 0.596],
    [30.2, 0.688],
    [39.3, 0.772],
    [49.5, 0.847],
    [59.8, 0.902],
];

/// A sphere that comes to a glass plane at an angle from its normal [rad].
fn setup(law: TangentialLaw, angle: f64) -> Setup {
    let named = |name: &str, youngs_modulus, poisson_ratio, density| NamedMaterial {
        name: name.into(),
        material: Material {
            density,
            youngs_modulus,
            poisson_ratio,
        },
        true_youngs_modulus: None,
    };
    let properties = PairProperties {
        restitution: 0.98,
        friction: 0.092,
        ..PairProperties::ELASTIC
    };
    Setup {
        seed: 1,
        gravity: Vec3::zeros(),
        materials: vec![
            named("alumina", 380.0e9, 0.23, 4000.0),
            named("glass", 70.0e9, 0.25, 2500.0),
        ],
        pairs: vec![([0, 0], properties), ([0, 1], properties)],
        pellets: vec![PelletKind {
            name: "sphere".into(),
            material: 0,
            size: SizeDistribution::Single {
                diameter: 2.0 * RADIUS,
            },
        }],
        laws: ContactLaws {
            tangential: law,
            ..ContactLaws::default()
        },
        walls: vec![Wall {
            name: "plane".into(),
            material: 1,
            shape: Shape::HalfSpace {
                point: Vec3::zeros(),
                normal: UnitVector3::new_normalize(Vec3::z()),
            }
            .into(),
            motion: Motion::Fixed,
            surface_velocity: Vec3::zeros(),
            schedule: Schedule::always(),
        }],
        fills: vec![Fill {
            name: "shot".into(),
            pellets: 0,
            seats: Seats::Points(vec![Vec3::new(0.0, 0.0, 1.001 * RADIUS)]),
            velocity: SPEED * Vec3::new(angle.sin(), 0.0, -angle.cos()),
            spin: Vec3::zeros(),
        }],
        inlets: Vec::new(),
        outlets: Vec::new(),
        meters: Vec::new(),
        domain: Domain::closed(Bounds {
            min: Vec3::repeat(-1.0),
            max: Vec3::repeat(1.0),
        }),
        integrator: Integrator::default(),
        step: StepRequest::PeakForceError(1.0e-3),
        search: NeighborSearch::Auto,
        skin: None,
        limits: Limits::default(),
        skips: Skips::default(),
        instructions: None,
        hits: None,
    }
}

/// Speed along the plane after the hit over that before [-].
fn tangential_restitution(law: TangentialLaw, degrees: f64) -> Result<f64, Box<dyn Error>> {
    let angle = degrees.to_radians();
    let model = Model::new(setup(law, angle)).map_err(|mistakes| format!("{mistakes:?}"))?;
    let mut simulation = Simulation::new(model, 1).map_err(|mistakes| format!("{mistakes:?}"))?;
    while simulation.contact_statistics().finished == 0 {
        simulation.step()?;
    }
    let after = simulation.pellets().next().ok_or("the sphere is gone")?;
    Ok(after.velocity.x / (SPEED * angle.sin()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args()
        .nth(1)
        .ok_or("name the picture to write, such as oblique-hits.svg")?;
    let mut series = vec![Series {
        label: "measured".into(),
        points: MEASURED.to_vec(),
        style: SeriesStyle::Markers,
    }];
    for (label, law) in [
        ("partial slip", TangentialLaw::PartialSlip),
        ("Mindlin's spring", TangentialLaw::Mindlin),
        ("Coulomb", TangentialLaw::Coulomb),
    ] {
        let mut points = Vec::new();
        for half_degrees in 3..=120 {
            let degrees = 0.5 * f64::from(half_degrees);
            points.push([degrees, tangential_restitution(law, degrees)?]);
        }
        series.push(Series {
            label: label.into(),
            points,
            style: SeriesStyle::Line,
        });
    }
    let chart = Chart {
        title: "Aluminum oxide on glass at 3.9 m/s".into(),
        x: Axis::linear("angle from the normal [°]"),
        y: Axis::linear("tangential restitution [-]"),
        series,
    };
    std::fs::write(path, chart.to_svg()?)?;
    Ok(())
}
