//! The time step: from the force error asked for and the fastest hit expected.

use crate::error::SetupError;
use crate::setup::Setup;
use pelletflow_core::contact::NormalLaw;
use pelletflow_core::{Bounds, MaterialPair, Vec3};
use pelletflow_impact::ElasticImpact;
use std::f64::consts::PI;

/// How the step is to be chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StepRequest {
    /// From the error of the peak force of the fastest hit expected, as a share [-].
    PeakForceError(f64),
    /// A fixed step [s].
    Fixed(f64),
    /// A fixed step that nobody looks at, before the run or in it [s]: for finding out at which step a run breaks.
    Unchecked(f64),
}

/// The step and why.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeStep {
    /// The step [s].
    pub seconds: f64,
    /// Why it is what it is, in one sentence to print.
    pub reason: String,
    /// Speed of the fastest hit expected [m/s].
    pub expected_speed: f64,
    /// Shortest contact at that speed [s].
    pub shortest_contact: f64,
    /// Speed of a pellet for which the step is too large [m/s]; infinite where nobody looks.
    pub speed_limit: f64,
}

/// Largest step over the Rayleigh time [-]: a bed has several contacts per pellet, each stiffening it.
const RAYLEIGH_SHARE: f64 = 0.2;
/// Largest forced step over the Rayleigh time [-].
const FORCED_RAYLEIGH_SHARE: f64 = 0.4;
/// Fewest steps per contact of a forced step [-].
const FEWEST_FORCED_STEPS: f64 = 10.0;
/// Way in one step at the fastest speed expected over the smallest radius, at most [-]: a pellet whose center has reached
/// a thin wall is pushed out on its other side, and the limit of the overlap must be met before.
const PASSING_SHARE: f64 = 0.25;
/// The same in a run, where a pellet is faster than expected [-]: what begins a step outside of a wall is still on the
/// same side of its middle after it, and pushed out there.
const PASSING_LIMIT: f64 = 0.5;
/// Fewest steps per contact in a run, where a hit is harder than expected [-]: below it an elastic hit errs by 4 %.
const FEWEST_STEPS: f64 = 5.0;
/// The same over the steps per contact expected, where few were asked for [-].
const FEWEST_STEPS_SHARE: f64 = 0.5;
/// Speed of a hit expected where nothing moves or falls [m/s].
const LEAST_SPEED: f64 = 0.1;

/// Chooses the step of a setup that has no other mistakes.
///
/// # Errors
/// A forced step too large for the hits expected.
pub(crate) fn choose(setup: &Setup) -> Result<TimeStep, SetupError> {
    let expected_speed = expected_speed(setup);
    let shortest = shortest_contact(setup, expected_speed);
    let wave = match setup.laws.normal {
        // A spring of given stiffness has no modulus for a wave to travel by.
        NormalLaw::Linear => f64::INFINITY,
        _ => rayleigh_time(setup),
    };
    let hit = format!(
        "fastest hit expected {expected_speed:.2} m/s ({}), contact {:.1} µs",
        shortest.bodies,
        1.0e6 * shortest.time
    );
    let passing = PASSING_SHARE * smallest_radius(setup) / expected_speed;
    let (seconds, reason) = match setup.step {
        StepRequest::PeakForceError(error) => {
            let steps = setup.integrator.steps_per_contact(error);
            let by_force = shortest.time / steps;
            let by_wave = RAYLEIGH_SHARE * wave;
            let share = 100.0 * error;
            if passing < by_force.min(by_wave) {
                let reason = format!(
                    "{PASSING_SHARE} of the smallest radius a step, so that nothing passes a thin wall; {hit}"
                );
                (passing, reason)
            } else if by_force <= by_wave {
                (
                    by_force,
                    format!("peak force within {share} %: {steps:.1} steps per contact; {hit}"),
                )
            } else {
                let reason = format!(
                    "{RAYLEIGH_SHARE} of the Rayleigh time {:.1} µs, less than a peak force within {share} % needs; {hit}",
                    1.0e6 * wave
                );
                (by_wave, reason)
            }
        }
        StepRequest::Fixed(step) => {
            let largest = (shortest.time / FEWEST_FORCED_STEPS).min(FORCED_RAYLEIGH_SHARE * wave);
            if step > passing && passing < largest {
                return Err(SetupError::new(
                    "time.step",
                    format!(
                        "is {step:.3e} s; expected at most {passing:.3e} s, or pellets pass thin walls: at most {PASSING_SHARE} of the \
                         smallest radius a step; {hit}; leave `step` out to have it chosen"
                    ),
                ));
            }
            if step > largest {
                return Err(SetupError::new(
                    "time.step",
                    format!(
                        "is {step:.3e} s; expected at most {largest:.3e} s: {FEWEST_FORCED_STEPS} steps per contact and {FORCED_RAYLEIGH_SHARE} \
                         of the Rayleigh time; {hit}; leave `step` out to have it chosen"
                    ),
                ));
            }
            (
                step,
                format!(
                    "as asked; {:.1} steps per contact; {hit}",
                    shortest.time / step
                ),
            )
        }
        StepRequest::Unchecked(step) => (
            step,
            format!(
                "as asked, unchecked; {:.1} steps per contact; {hit}",
                shortest.time / step
            ),
        ),
    };
    Ok(TimeStep {
        seconds,
        reason,
        expected_speed,
        shortest_contact: shortest.time,
        speed_limit: match setup.step {
            StepRequest::Unchecked(_) => f64::INFINITY,
            _ => speed_limit(setup, seconds, expected_speed, shortest.time),
        },
    })
}

/// Speed of a pellet for which a step is too large [m/s]: it would pass walls, or its hits would have too few steps.
fn speed_limit(setup: &Setup, step: f64, expected_speed: f64, shortest_contact: f64) -> f64 {
    let passing = PASSING_LIMIT * smallest_radius(setup) / step - fastest_wall(setup);
    let steps = shortest_contact / step;
    let fewest = FEWEST_STEPS.min(FEWEST_STEPS_SHARE * steps);
    let hitting = match setup.laws.normal {
        // The time of a linear contact does not depend on the speed.
        NormalLaw::Linear => f64::INFINITY,
        // That of Hertz goes with its power −1/5.
        _ => expected_speed * (steps / fewest).powi(5),
    };
    passing.min(hitting)
}

struct ShortestContact {
    time: f64,
    bodies: String,
}

fn shortest_contact(setup: &Setup, speed: f64) -> ShortestContact {
    let mut shortest = ShortestContact {
        time: f64::INFINITY,
        bodies: String::new(),
    };
    let mut enter = |pair: &MaterialPair, impact: &ElasticImpact, bodies: String| {
        let time = match setup.laws.normal {
            NormalLaw::Linear => PI * (impact.effective_mass / pair.linear_stiffness).sqrt(),
            _ => impact.contact_time(),
        };
        if time < shortest.time {
            shortest = ShortestContact { time, bodies };
        }
    };
    for (a, kind) in setup.pellets.iter().enumerate() {
        let radius = kind.size.min_diameter() / 2.0;
        let mass = setup.mass(a, radius);
        for wall in &setup.walls {
            let pair = setup.pair(kind.material, wall.material);
            let impact = ElasticImpact::on_plane(&pair, radius, mass, speed);
            enter(
                &pair,
                &impact,
                format!("pellet `{}` on wall `{}`", kind.name, wall.name),
            );
        }
        for (b, other) in setup.pellets.iter().enumerate() {
            let other_radius = other.size.min_diameter() / 2.0;
            let pair = setup.pair(kind.material, other.material);
            let impact = ElasticImpact {
                effective_youngs_modulus: pair.effective_youngs_modulus,
                effective_radius: radius * other_radius / (radius + other_radius),
                effective_mass: 1.0 / (1.0 / mass + 1.0 / setup.mass(b, other_radius)),
                speed,
            };
            enter(
                &pair,
                &impact,
                format!("pellet `{}` on pellet `{}`", kind.name, other.name),
            );
        }
    }
    shortest
}

/// Stiffness of a spring that stores the fastest hit expected of the smallest pellet at the overlap of Hertz [N/m].
pub(crate) fn stiffness_of_fastest_hit(setup: &Setup, materials: [usize; 2]) -> f64 {
    let pair = setup.pair(materials[0], materials[1]);
    let of_materials = setup
        .pellets
        .iter()
        .enumerate()
        .filter(|(_, kind)| materials.contains(&kind.material));
    of_materials
        .map(|(index, kind)| {
            let radius = kind.size.min_diameter() / 2.0;
            let impact = ElasticImpact::on_plane(
                &pair,
                radius,
                setup.mass(index, radius),
                expected_speed(setup),
            );
            impact.effective_mass * (impact.speed / impact.greatest_approach()).powi(2)
        })
        .fold(f64::INFINITY, f64::min)
}

fn smallest_radius(setup: &Setup) -> f64 {
    setup
        .pellets
        .iter()
        .map(|kind| kind.size.min_diameter() / 2.0)
        .fold(f64::INFINITY, f64::min)
}

fn rayleigh_time(setup: &Setup) -> f64 {
    setup
        .pellets
        .iter()
        .map(|kind| {
            setup.materials[kind.material]
                .material
                .rayleigh_time(kind.size.min_diameter() / 2.0)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Speed of a pellet that falls freely from the highest source to the bottom of the domain, plus that of the
/// fastest wall or belt it may meet there [m/s].
fn expected_speed(setup: &Setup) -> f64 {
    let gravity = setup.gravity.norm();
    let bottom = reach(&setup.domain.bounds, setup.gravity);
    let source_speed = |bounds: Bounds, velocity: Vec3| {
        let fall = (bottom + reach(&bounds, -setup.gravity)).max(0.0);
        (velocity.norm_squared() + 2.0 * gravity * fall).sqrt()
    };
    let fills = setup
        .fills
        .iter()
        .map(|fill| source_speed(fill.bounds(), fill.velocity));
    let inlets = setup
        .inlets
        .iter()
        .map(|inlet| source_speed(inlet.region.bounds(), inlet.velocity));
    let of_pellets = fills.chain(inlets).fold(0.0, f64::max);
    (of_pellets + fastest_wall(setup)).max(LEAST_SPEED)
}

/// Speed of the fastest wall or belt [m/s].
fn fastest_wall(setup: &Setup) -> f64 {
    let walls = setup.walls.iter();
    walls
        .map(|wall| setup.wall_speed(wall) + wall.surface_velocity.norm())
        .fold(0.0, f64::max)
}

/// How far a box reaches along a direction, from the origin [m].
fn reach(bounds: &Bounds, direction: Vec3) -> f64 {
    let length = direction.norm();
    if length == 0.0 {
        return 0.0;
    }
    (0..3)
        .map(|axis| (bounds.min[axis] * direction[axis]).max(bounds.max[axis] * direction[axis]))
        .sum::<f64>()
        / length
}
