//! A scene as the bench tells it, so that each number is written once.

use serde::Deserialize;

/// What another code has to know of a scene, in SI units.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Description {
    pub(crate) diameter: f64,
    pub(crate) density: f64,
    pub(crate) youngs_modulus: f64,
    pub(crate) poisson_ratio: f64,
    pub(crate) restitution: f64,
    pub(crate) friction: f64,
    pub(crate) time_step: f64,
    /// Extra reach of the neighbor lists; none where each code may choose.
    pub(crate) skin: Option<f64>,
    pub(crate) gravity: [f64; 3],
    /// Lowest and highest corner of the box.
    #[serde(rename = "box")]
    pub(crate) bounds: [[f64; 3]; 2],
    pub(crate) place: Place,
}

/// What is about the pellets.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(crate) enum Place {
    Silo(Silo),
    Chute(Chute),
    Nothing {},
}

/// A cylinder over a cone.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Silo {
    pub(crate) radius: f64,
    pub(crate) outlet_radius: f64,
    pub(crate) cone_height: f64,
}

/// A slope with a bottom of balls, springs and dashpots between all.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Chute {
    /// Inclination [°].
    pub(crate) angle: f64,
    pub(crate) normal_stiffness: f64,
    pub(crate) tangential_stiffness: f64,
    /// Damping coefficients over the effective mass [1/s].
    pub(crate) normal_damping: f64,
    pub(crate) tangential_damping: f64,
    pub(crate) balls: Vec<[f64; 3]>,
}

impl Description {
    /// Mass of a pellet [kg].
    pub(crate) fn mass(&self) -> f64 {
        self.density * std::f64::consts::PI / 6.0 * self.diameter.powi(3)
    }

    /// Acceleration of gravity [m/s²].
    pub(crate) fn weight(&self) -> f64 {
        self.gravity
            .iter()
            .map(|part| part * part)
            .sum::<f64>()
            .sqrt()
    }
}
