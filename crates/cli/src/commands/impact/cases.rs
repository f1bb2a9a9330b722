//! Which hits are asked for: one for each speed, or those of a figure of the paper.

use crate::args::impact::{ImpactArguments, View};
use crate::commands::hit::{Hit, bad_input};
use crate::exit::Failure;
use crate::table::chosen;
use pelletflow_core::Material;
use pelletflow_impact::{Arrival, Damping};
use std::f64::consts::FRAC_PI_4;

/// A hit to follow.
#[derive(Debug, Clone)]
pub(super) struct Case {
    /// What tells it from the others.
    pub(super) label: String,
    /// What it has in common with some of the others, for curves over the speed.
    pub(super) group: String,
    pub(super) arrival: Arrival,
}

/// The hits of one call and what its plot shows.
#[derive(Debug, Clone)]
pub(super) struct Cases {
    pub(super) title: String,
    pub(super) view: View,
    pub(super) all: Vec<Case>,
}

/// The paper's speeds of figures 6 and 7 are not told; this one shows them well [m/s].
const SPEED_OF_OTHERS: f64 = 5.0;

impl Cases {
    pub(super) fn new(arguments: &ImpactArguments) -> Result<Self, Failure> {
        let pellet = arguments.figure.map(|_| "papers-pellet");
        let hit = Hit::new(&arguments.hit, pellet)?;
        let angle = arguments.angle.unwrap_or(match arguments.figure {
            Some(3..=5) => FRAC_PI_4,
            _ => 0.0,
        });
        let speeds = arguments.speed.as_ref().map_or_else(
            || match arguments.figure {
                Some(4 | 5) => vec![2.0, 4.0, 6.0, 8.0],
                Some(6 | 7) => vec![SPEED_OF_OTHERS],
                _ => (1..=8).map(f64::from).collect(),
            },
            |speeds| speeds.0.clone(),
        );
        let view = match arguments.figure {
            Some(4) => View::HorizontalSpeed,
            Some(5) => View::Spin,
            Some(8) => View::PeakForce,
            Some(9) => View::Shape,
            Some(_) => View::Force,
            None => arguments.show.unwrap_or(View::Force),
        };
        if view.is_of_sliding() && angle == 0.0 {
            let message =
                "a hit along the normal slides nowhere; give --angle, for example --angle 45deg";
            return Err(bad_input(message.into()));
        }
        let arrival = Arrival {
            pellet: hit.pellet,
            surface: hit.surface,
            diameter: hit.diameter,
            speed: 1.0,
            angle,
            friction: friction(arguments, &hit, angle)?,
            slip: arguments.slip.into(),
            damping: damping(arguments),
        };
        let cases = match arguments.figure {
            Some(6) => shear_moduli(&arrival, &speeds),
            Some(7) => diameters(&arrival, &speeds),
            Some(8) => flat_and_sloped(
                &Arrival {
                    angle: 0.0,
                    ..arrival
                },
                arguments,
                &hit,
                &speeds,
            )?,
            _ => at_speeds(&arrival, &speeds, ""),
        };
        Ok(Self {
            title: title(arguments, &hit, angle),
            view,
            all: cases,
        })
    }
}

fn damping(arguments: &ImpactArguments) -> Damping {
    match (arguments.restitution, arguments.relaxation_time) {
        (Some(restitution), _) => Damping::Restitution(restitution),
        (None, Some(time)) => Damping::Viscoelastic(time),
        (None, None) => Damping::None,
    }
}

fn friction(arguments: &ImpactArguments, hit: &Hit, angle: f64) -> Result<f64, Failure> {
    match arguments.friction.or(hit.onto.friction) {
        Some(friction) => Ok(friction),
        None if angle == 0.0 => Ok(0.0),
        None => Err(bad_input(format!(
            "the library knows no friction on {}; give --friction, for example --friction 0.5",
            hit.onto.name
        ))),
    }
}

fn title(arguments: &ImpactArguments, hit: &Hit, angle: f64) -> String {
    let slope = if angle > 0.0 {
        format!(" at {}° from its normal", chosen(angle.to_degrees()))
    } else {
        String::new()
    };
    let pellet = match arguments.figure {
        Some(7) => "Pellets".into(),
        _ => format!("{} mm pellet", chosen(hit.diameter * 1.0e3)),
    };
    format!("{pellet} on {}{slope}", hit.onto.name)
}

fn at_speeds(arrival: &Arrival, speeds: &[f64], group: &str) -> Vec<Case> {
    speeds
        .iter()
        .map(|&speed| Case {
            label: format!("{} m/s", chosen(speed)),
            group: group.into(),
            arrival: Arrival { speed, ..*arrival },
        })
        .collect()
}

/// The cases of one thing that changes, named after it and, where there are more of them, after the speed.
fn changed(arrival: &Arrival, speeds: &[f64], name: &str) -> Vec<Case> {
    let mut cases = at_speeds(arrival, speeds, name);
    for case in &mut cases {
        case.label = match speeds {
            [_] => name.to_owned(),
            _ => format!("{name}, {}", case.label),
        };
    }
    cases
}

fn shear_moduli(arrival: &Arrival, speeds: &[f64]) -> Vec<Case> {
    let Material {
        density,
        poisson_ratio,
        ..
    } = arrival.pellet;
    [10.0, 25.0, 50.0, 75.0, 100.0, 150.0]
        .iter()
        .flat_map(|megapascal| {
            let pellet = Material::from_shear_modulus(density, megapascal * 1.0e6, poisson_ratio);
            changed(
                &Arrival { pellet, ..*arrival },
                speeds,
                &format!("{megapascal} MPa"),
            )
        })
        .collect()
}

fn diameters(arrival: &Arrival, speeds: &[f64]) -> Vec<Case> {
    [3.0, 5.0, 10.0, 15.0, 20.0, 25.0]
        .iter()
        .flat_map(|millimeter| {
            let diameter = millimeter * 1.0e-3;
            changed(
                &Arrival {
                    diameter,
                    ..*arrival
                },
                speeds,
                &format!("{millimeter} mm"),
            )
        })
        .collect()
}

fn flat_and_sloped(
    flat: &Arrival,
    arguments: &ImpactArguments,
    hit: &Hit,
    speeds: &[f64],
) -> Result<Vec<Case>, Failure> {
    let angle = arguments.angle.unwrap_or(FRAC_PI_4);
    let sloped = Arrival {
        angle,
        friction: friction(arguments, hit, angle)?,
        ..*flat
    };
    let name = format!("slope of {}°", chosen(angle.to_degrees()));
    let mut cases = at_speeds(flat, speeds, "flat");
    let mut on_slope = at_speeds(&sloped, speeds, &name);
    for case in &mut on_slope {
        case.label = format!("{}, {name}", case.label);
    }
    cases.append(&mut on_slope);
    Ok(cases)
}
