//! The elastic impact of Hertz, exact (Johnson 1985, section 11.4).

use pelletflow_core::MaterialPair;

/// Contact time over greatest approach per speed: `2 ∫₀¹ dx / √(1 − x^2.5)` [-].
pub const CONTACT_TIME_FACTOR: f64 = 2.943_275_023_3;

/// Two elastic bodies meeting head on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticImpact {
    /// `E*` of the pair [Pa].
    pub effective_youngs_modulus: f64,
    /// `R*` of the contact [m].
    pub effective_radius: f64,
    /// `m*` of the two bodies [kg].
    pub effective_mass: f64,
    /// Approach speed [m/s].
    pub speed: f64,
}

impl ElasticImpact {
    /// A sphere of `radius` [m] and `mass` [kg] against a flat wall, at `speed` [m/s].
    pub fn on_plane(pair: &MaterialPair, radius: f64, mass: f64, speed: f64) -> Self {
        Self {
            effective_youngs_modulus: pair.effective_youngs_modulus,
            effective_radius: radius,
            effective_mass: mass,
            speed,
        }
    }

    /// Two equal spheres of `radius` [m] and `mass` [kg], meeting at `speed` [m/s].
    pub fn of_equals(pair: &MaterialPair, radius: f64, mass: f64, speed: f64) -> Self {
        Self {
            effective_youngs_modulus: pair.effective_youngs_modulus,
            effective_radius: radius / 2.0,
            effective_mass: mass / 2.0,
            speed,
        }
    }

    /// `k = 4/3 E* √R*` of `F = k δ^1.5` [N/m^1.5].
    pub fn stiffness(&self) -> f64 {
        4.0 / 3.0 * self.effective_youngs_modulus * self.effective_radius.sqrt()
    }

    /// Greatest approach, `(5 m* v² / 4 k)^(2/5)` [m].
    pub fn greatest_approach(&self) -> f64 {
        (1.25 * self.effective_mass * self.speed.powi(2) / self.stiffness()).powf(0.4)
    }

    /// Greatest force, `k δ^1.5` at the greatest approach [N].
    pub fn peak_force(&self) -> f64 {
        self.stiffness() * self.greatest_approach().powf(1.5)
    }

    /// Time from first touch to release [s].
    pub fn contact_time(&self) -> f64 {
        CONTACT_TIME_FACTOR * self.greatest_approach() / self.speed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The paper's pellet on steel: D 15 mm and an effective modulus 153.74e6 Pa.
    fn papers_pellet(density: f64, speed: f64) -> ElasticImpact {
        let radius = 7.5e-3_f64;
        ElasticImpact {
            effective_youngs_modulus: 153.74e6,
            effective_radius: radius,
            effective_mass: density * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3),
            speed,
        }
    }

    #[test]
    fn the_papers_pellet_meets_steel_with_the_tabulated_force_time_and_approach() {
        // Table computed from the stated equations by an error-controlled solver, three digits.
        let table = [
            (3500.0, 1.0, 42.9, 0.530e-3, 0.180e-3),
            (3500.0, 5.0, 296.1, 0.384e-3, 0.653e-3),
            (3800.0, 8.0, 546.8, 0.362e-3, 0.983e-3),
        ];
        for (density, speed, force, time, approach) in table {
            let impact = papers_pellet(density, speed);
            assert!((impact.peak_force() / force - 1.0).abs() < 2.0e-3);
            assert!((impact.contact_time() / time - 1.0).abs() < 2.0e-3);
            assert!((impact.greatest_approach() / approach - 1.0).abs() < 3.0e-3);
        }
    }

    #[test]
    fn impulse_over_force_and_time_is_the_constant_of_every_elastic_impact() {
        // k_P = 2 m v / (P t) = 0.543612.
        for speed in [0.5, 2.0, 8.0] {
            let impact = papers_pellet(3700.0, speed);
            let share =
                2.0 * impact.effective_mass * speed / (impact.peak_force() * impact.contact_time());
            assert!((share - 0.543_612).abs() < 1.0e-6);
        }
    }

    #[test]
    fn glass_spheres_of_chung_and_ooi_meet_with_the_published_force() {
        // Chung & Ooi 2011, test 1: R 10 mm, 10 m/s each, E 48 GPa, ν 0.2, ρ 2800.
        let impact = ElasticImpact {
            effective_youngs_modulus: 48.0e9 / (2.0 * (1.0 - 0.04)),
            effective_radius: 5.0e-3,
            effective_mass: 2800.0 * 4.0 / 3.0 * std::f64::consts::PI * 1.0e-6 / 2.0,
            speed: 20.0,
        };
        assert!((impact.peak_force() / 10_697.0 - 1.0).abs() < 1.0e-4);
        assert!((impact.contact_time() / 40.34e-6 - 1.0).abs() < 2.0e-4);
    }
}
