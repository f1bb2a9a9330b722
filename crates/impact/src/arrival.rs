//! A pellet that arrives at a flat surface, told in the words of a plant.

use crate::damping::Damping;
use crate::elastic::ElasticImpact;
use crate::error::{ImpactError, positive};
use crate::impact::{Impact, Sample};
use crate::oblique::{Approach, ObliqueSample, Slip};
use crate::outline::{Outline, Outlines};
use pelletflow_core::{Material, MaterialPair, PairProperties};
use std::f64::consts::{FRAC_PI_2, PI};

/// A spherical pellet without spin that arrives at a flat surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrival {
    /// What the pellet is made of.
    pub pellet: Material,
    /// What the surface is made of.
    pub surface: Material,
    /// Diameter of the pellet [m].
    pub diameter: f64,
    /// Speed of the pellet [m/s].
    pub speed: f64,
    /// Angle between the path and the normal of the surface: the slope of a surface that the pellet falls on from
    /// above [rad].
    pub angle: f64,
    /// Coulomb's coefficient of friction [-].
    pub friction: f64,
    /// How the surfaces resist sliding.
    pub slip: Slip,
    /// What is lost along the normal.
    pub damping: Damping,
}

impl Arrival {
    /// The hit along the normal, without losses.
    pub fn elastic(&self) -> ElasticImpact {
        let radius = 0.5 * self.diameter;
        let mass = self.pellet.density * 4.0 / 3.0 * PI * radius.powi(3);
        ElasticImpact::on_plane(&self.pair(), radius, mass, self.speed * self.angle.cos())
    }

    /// Follows the hit.
    ///
    /// # Errors
    ///
    /// When a quantity is outside its bounds, or the solver finds no release.
    pub fn impact(&self) -> Result<Impact, ImpactError> {
        self.check_angle()?;
        let pair = self.pair();
        let approach = Approach {
            tangential_speed: self.speed * self.angle.sin(),
            spin: 0.0,
            radius: 0.5 * self.diameter,
            friction: self.friction,
            stiffness_ratio: 4.0 * pair.effective_shear_modulus / pair.effective_youngs_modulus,
            slip: self.slip,
        };
        let is_oblique = self.angle > 0.0;
        Impact::new(
            &self.elastic(),
            self.damping,
            is_oblique.then_some(&approach),
        )
    }

    /// The numbers of the hit along the normal, without its curve.
    ///
    /// # Errors
    ///
    /// When a quantity is outside its bounds, or the solver finds no release.
    pub fn outline(&self, outlines: &mut Outlines) -> Result<Outline, ImpactError> {
        self.validate()?;
        outlines.of(&self.elastic(), self.damping)
    }

    /// Refuses a pellet or a surface that is none, and a path that does not lead to the surface.
    ///
    /// # Errors
    ///
    /// When a quantity is outside its bounds.
    pub fn validate(&self) -> Result<(), ImpactError> {
        positive("diameter", "m", self.diameter)?;
        positive("speed", "m/s", self.speed)?;
        positive("density", "kg/m3", self.pellet.density)?;
        for material in [&self.pellet, &self.surface] {
            positive("Young's modulus", "Pa", material.youngs_modulus)?;
            let ratio = material.poisson_ratio;
            if !(ratio > -1.0 && ratio < 0.5) {
                return Err(ImpactError::OutOfBounds {
                    quantity: "Poisson's ratio",
                    value: ratio,
                    unit: "",
                    expected: "more than -1 and less than 0.5",
                });
            }
        }
        self.check_angle()
    }

    fn check_angle(&self) -> Result<(), ImpactError> {
        if (0.0..FRAC_PI_2).contains(&self.angle) {
            return Ok(());
        }
        Err(ImpactError::OutOfBounds {
            quantity: "angle",
            value: self.angle,
            unit: "rad",
            expected: "0 or more and less than a right angle, from the normal of the surface",
        })
    }

    /// Horizontal speed of a pellet that has fallen straight down on a surface of slope [`Self::angle`] [m/s].
    pub fn horizontal_speed(&self, sample: &Sample, oblique: &ObliqueSample) -> f64 {
        oblique.tangential_speed * self.angle.cos() - sample.approach_speed * self.angle.sin()
    }

    fn pair(&self) -> MaterialPair {
        let properties = PairProperties {
            restitution: 1.0,
            friction: self.friction,
            rolling_friction: 0.0,
            ..PairProperties::ELASTIC
        };
        MaterialPair::new(&self.pellet, &self.surface, &properties)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pelletflow_core::material::library::LibraryMaterial;

    fn arrival(angle: f64) -> Arrival {
        let named = |name| LibraryMaterial::named(name).expect("in the library");
        Arrival {
            pellet: named("papers-pellet").material,
            surface: named("steel").material,
            diameter: 0.015,
            speed: 4.0,
            angle,
            friction: 0.45,
            slip: Slip::Coulomb,
            damping: Damping::None,
        }
    }

    #[test]
    fn the_papers_pellet_comes_from_the_library_with_its_force() {
        // Closed form: 296.1 and 311.1 N at 5 m/s for 3500 and 3800 kg/m³, and P ∝ ρ^0.6.
        let hit = Arrival {
            speed: 5.0,
            ..arrival(0.0)
        };
        let expected = 296.1 * (3700.0_f64 / 3500.0).powf(0.6);
        assert!((hit.elastic().peak_force() / expected - 1.0).abs() < 2.0e-4);
    }

    #[test]
    fn a_pellet_dropped_on_a_slope_of_45_degrees_leaves_it_sideways() {
        let arrival = arrival(std::f64::consts::FRAC_PI_4);
        let impact = arrival.impact().expect("a hit that ends");
        let rebound = impact.rebound.as_ref().expect("an oblique hit");
        let speeds: Vec<f64> = impact
            .samples
            .iter()
            .zip(&rebound.samples)
            .map(|(sample, oblique)| arrival.horizontal_speed(sample, oblique))
            .collect();
        assert!(speeds[0].abs() < 1.0e-12);
        // Normal rebound v cos², tangential speed 5/7 of v sin cos once it rolls: v/2 (1 + 5/7).
        let end = speeds.last().expect("samples");
        assert!(
            (end / (2.0 * (1.0 + 5.0 / 7.0)) - 1.0).abs() < 1.0e-6,
            "{end}"
        );
    }

    #[test]
    fn a_path_along_the_surface_is_no_hit() {
        for angle in [FRAC_PI_2, -0.1, f64::NAN] {
            assert!(arrival(angle).impact().is_err(), "{angle}");
        }
    }
}
