//! The elastic impact of Hertz, exact (Johnson 1985, section 11.4).

use pelletflow_core::MaterialPair;

/// Contact time over greatest approach per speed: `2 ∫₀¹ dx / √(1 − x^2.5)` [-].
pub const CONTACT_TIME_FACTOR: f64 = 2.943_275_023_3;

/// Specific impulse `k_P = 2 m v / (P t) = 8 / (5 · 2.943…)` of every elastic impact of Hertz [-].
pub const SPECIFIC_IMPULSE: f64 = 1.6 / CONTACT_TIME_FACTOR;

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

    /// Radius of the contact circle at the greatest approach, `√(R* δ)` [m].
    pub fn contact_radius(&self) -> f64 {
        (self.effective_radius * self.greatest_approach()).sqrt()
    }

    /// Greatest pressure, in the middle of the contact at the greatest force [Pa].
    pub fn peak_pressure(&self) -> f64 {
        self.pressure(self.peak_force())
    }

    /// Pressure in the middle of the contact under a `force` [N], `(6 P E*² / (π³ R*²))^(1/3)` [Pa].
    ///
    /// The paper's (8) with the modulus squared and without the 4/3 of its (7) (Johnson 1985, eq. 4.24).
    pub fn pressure(&self, force: f64) -> f64 {
        let curvature = 1.0 / self.effective_radius;
        (6.0 * force * (self.effective_youngs_modulus * curvature).powi(2)).cbrt()
            / std::f64::consts::PI
    }

    /// Impulse of the whole hit, `2 m* v` [N·s].
    pub fn impulse(&self) -> f64 {
        2.0 * self.effective_mass * self.speed
    }

    /// Peak parameter `χ_P = P / t` [N/s].
    pub fn peak_parameter(&self) -> f64 {
        self.peak_force() / self.contact_time()
    }

    /// Speed whose greatest force is `force` [N]: the inverse of [`Self::peak_force`], which grows as `v^1.2` [m/s].
    pub fn speed_of_peak_force(&self, force: f64) -> f64 {
        let at_unit_speed = Self {
            speed: 1.0,
            ..*self
        };
        (force / at_unit_speed.peak_force()).powf(1.0 / 1.2)
    }

    /// Length of the hit, `(m* v² / k)^(2/5)`, in which its motion is the same for all [m].
    pub fn length(&self) -> f64 {
        (self.effective_mass * self.speed.powi(2) / self.stiffness()).powf(0.4)
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
            assert!((share / SPECIFIC_IMPULSE - 1.0).abs() < 1.0e-12);
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

    #[test]
    fn peak_pressure_is_one_and_a_half_times_the_mean_and_does_not_depend_on_size() {
        let impact = papers_pellet(3800.0, 1.0);
        let area = std::f64::consts::PI * impact.contact_radius().powi(2);
        let mean = impact.peak_force() / area;
        assert!((impact.peak_pressure() / (1.5 * mean) - 1.0).abs() < 1.0e-12);
        // 15.42 MPa at 1 m/s for every diameter of this pellet: four digits of an independent computation.
        assert!((impact.peak_pressure() / 15.42e6 - 1.0).abs() < 5.0e-4);
        let larger = ElasticImpact {
            effective_radius: 2.0 * impact.effective_radius,
            effective_mass: 8.0 * impact.effective_mass,
            ..impact
        };
        assert!((larger.peak_pressure() / impact.peak_pressure() - 1.0).abs() < 1.0e-12);
    }

    #[test]
    fn the_peak_parameter_grows_with_size_where_the_paper_calls_it_free_of_size() {
        // P ∝ R², t ∝ R.
        let small = papers_pellet(3700.0, 1.0);
        let large = ElasticImpact {
            effective_radius: 3.0 * small.effective_radius,
            effective_mass: 27.0 * small.effective_mass,
            ..small
        };
        let ratio = large.peak_parameter() / small.peak_parameter();
        assert!((ratio - 3.0).abs() < 1.0e-12);
    }

    #[test]
    fn the_speed_of_a_peak_force_is_the_inverse_of_the_peak_force() {
        let impact = papers_pellet(3700.0, 4.2);
        let speed = impact.speed_of_peak_force(impact.peak_force());
        assert!((speed / 4.2 - 1.0).abs() < 1.0e-14);
    }
}
