//! Materials, and the effective values of two in contact, computed once per pair.

pub mod library;

use crate::contact::normal;
use serde::{Deserialize, Serialize};

/// An isotropic elastic material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Mass per volume of the body itself, not of its bulk [kg/m³].
    pub density: f64,
    /// Young's modulus E [Pa].
    pub youngs_modulus: f64,
    /// Poisson's ratio ν [-].
    pub poisson_ratio: f64,
}

impl Material {
    /// A material from its shear modulus: `E = 2 G (1 + ν)`.
    pub fn from_shear_modulus(density: f64, shear_modulus: f64, poisson_ratio: f64) -> Self {
        Self {
            density,
            youngs_modulus: 2.0 * shear_modulus * (1.0 + poisson_ratio),
            poisson_ratio,
        }
    }

    /// Shear modulus `G = E / (2 (1 + ν))` [Pa].
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }

    /// Time step of Rayleigh's surface wave over a sphere, `π R √(ρ/G) / (0.1631 ν + 0.8766)` [s].
    pub fn rayleigh_time(&self, radius: f64) -> f64 {
        std::f64::consts::PI * radius * (self.density / self.shear_modulus()).sqrt()
            / (0.1631 * self.poisson_ratio + 0.8766)
    }
}

/// What is measured on two materials together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PairProperties {
    /// Rebound speed over approach speed of a normal impact, in (0, 1] [-].
    pub restitution: f64,
    /// Coulomb's coefficient of sliding friction [-].
    pub friction: f64,
    /// Coefficient of rolling friction: lever arm of the resisting torque over the effective radius [-].
    pub rolling_friction: f64,
    /// Damping of rolling and twisting over critical damping, where a spring resists them [-].
    pub rolling_damping: f64,
    /// Stiffness of a linear contact, where there is one [N/m].
    pub stiffness: Option<f64>,
    /// Pressure in the middle of a contact at which the softer body yields, where one does [Pa].
    pub yield_pressure: Option<f64>,
    /// Work of adhesion, where the bodies stick: what parting takes per area of contact [J/m²].
    pub surface_energy: Option<f64>,
}

impl PairProperties {
    /// Elastic and smooth, to start from; rolling is damped as by Ai et al. (2011).
    pub const ELASTIC: Self = Self {
        restitution: 1.0,
        friction: 0.0,
        rolling_friction: 0.0,
        rolling_damping: 0.3,
        stiffness: None,
        yield_pressure: None,
        surface_energy: None,
    };
}

/// The effective values of two materials in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaterialPair {
    /// `E* = 1 / ((1 − ν₁²)/E₁ + (1 − ν₂²)/E₂)` [Pa] (Johnson 1985, eq. 4.1).
    pub effective_youngs_modulus: f64,
    /// `G* = 1 / ((2 − ν₁)/G₁ + (2 − ν₂)/G₂)` [Pa] (Mindlin 1949).
    pub effective_shear_modulus: f64,
    /// Damping ratio β that gives the restitution with the force clamped at zero [-].
    pub damping_ratio: f64,
    /// Tangential over normal damping, `√(8 G* a / (2 E* a))` [-].
    pub tangential_damping_share: f64,
    /// Coulomb's coefficient of sliding friction [-].
    pub friction: f64,
    /// Coefficient of rolling friction [-].
    pub rolling_friction: f64,
    /// Damping of rolling and twisting over critical damping [-].
    pub rolling_damping: f64,
    /// `1 / (1/G₁ + 1/G₂)`, which resists twisting [Pa].
    pub series_shear_modulus: f64,
    /// Stiffness of a linear contact; not a number where none is given [N/m].
    pub linear_stiffness: f64,
    /// Pressure in the middle of a contact at which the softer body yields [Pa].
    pub yield_pressure: f64,
    /// Work of adhesion [J/m²].
    pub surface_energy: f64,
}

impl MaterialPair {
    /// The effective values of `a` touching `b`.
    pub fn new(a: &Material, b: &Material, properties: &PairProperties) -> Self {
        let compliance = |m: &Material| (1.0 - m.poisson_ratio.powi(2)) / m.youngs_modulus;
        let shear_compliance = |m: &Material| (2.0 - m.poisson_ratio) / m.shear_modulus();
        let effective_youngs_modulus = 1.0 / (compliance(a) + compliance(b));
        let effective_shear_modulus = 1.0 / (shear_compliance(a) + shear_compliance(b));
        Self {
            effective_youngs_modulus,
            effective_shear_modulus,
            tangential_damping_share: (4.0 * effective_shear_modulus / effective_youngs_modulus)
                .sqrt(),
            damping_ratio: normal::damping_ratio_for_clamped_restitution(properties.restitution),
            friction: properties.friction,
            rolling_friction: properties.rolling_friction,
            rolling_damping: properties.rolling_damping,
            series_shear_modulus: 1.0 / (1.0 / a.shear_modulus() + 1.0 / b.shear_modulus()),
            linear_stiffness: properties.stiffness.unwrap_or(f64::NAN),
            yield_pressure: properties.yield_pressure.unwrap_or(f64::INFINITY),
            surface_energy: properties.surface_energy.unwrap_or(0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_pellet_on_steel_has_the_published_effective_modulus() {
        // E* = 1 / ((1 − 0.22²) / 146.4 MPa + (1 − 0.28²) / 207.36 GPa), by hand.
        let pellet = Material::from_shear_modulus(3700.0, 60.0e6, 0.22);
        let steel = Material::from_shear_modulus(7800.0, 81.0e9, 0.28);
        let pair = MaterialPair::new(&pellet, &steel, &PairProperties::ELASTIC);
        assert!((pair.effective_youngs_modulus / 153.74e6 - 1.0).abs() < 5.0e-5);
    }

    #[test]
    fn rayleigh_time_of_a_12_mm_pellet_is_63_microseconds_at_1_gpa() {
        let pellet = Material {
            density: 3800.0,
            youngs_modulus: 1.0e9,
            poisson_ratio: 0.25,
        };
        assert!((pellet.rayleigh_time(6.0e-3) - 63.0e-6).abs() < 0.5e-6);
    }
}
