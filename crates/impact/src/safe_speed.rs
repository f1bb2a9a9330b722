//! How fast a pellet may arrive before a share of them breaks.
//!
//! The force is Hertz's, elastic: `P ∝ v^1.2`, so the speed follows in closed form from the load that breaks the share.

use crate::ElasticImpact;
use crate::error::{ImpactError, positive};
use crate::interval::Interval;
use crate::strength::Strength;
use crate::yielding::speed_of_yielded_force;

/// Standard gravity [m/s²].
const GRAVITY: f64 = 9.806_65;

/// The arrival speed at which a share of pellets breaks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SafeSpeed {
    /// Hits like the one asked about, whose speed does not matter: of the softest, the best and the stiffest modulus.
    hits: [ElasticImpact; 3],
    /// Force that breaks the share, with the interval that the sample of the strength test leaves.
    pub load: Interval,
    /// Speed across the surface at which an elastic hit reaches the load.
    ///
    /// The interval pairs the weakest load with the stiffest hit, and the strongest with the softest.
    pub speed: Interval,
}

impl SafeSpeed {
    /// For a share `risk` [-] of pellets of `diameter` [m] in hits like `hit`, whose speed does not matter.
    ///
    /// `softest` and `stiffest` bound the effective Young's modulus of the hit [Pa].
    ///
    /// # Errors
    ///
    /// When a quantity is outside its bounds.
    pub fn new(
        strength: &Strength,
        risk: f64,
        diameter: f64,
        hit: &ElasticImpact,
        [softest, stiffest]: [f64; 2],
    ) -> Result<Self, ImpactError> {
        positive("effective radius", "m", hit.effective_radius)?;
        positive("effective mass", "kg", hit.effective_mass)?;
        for modulus in [softest, hit.effective_youngs_modulus, stiffest] {
            positive("effective Young's modulus", "Pa", modulus)?;
        }
        let load = strength.load(risk, diameter)?;
        let hits = [softest, hit.effective_youngs_modulus, stiffest].map(|modulus| ElasticImpact {
            effective_youngs_modulus: modulus,
            ..*hit
        });
        Ok(Self {
            hits,
            load,
            speed: Interval {
                low: hits[2].speed_of_peak_force(load.low),
                best: hits[1].speed_of_peak_force(load.best),
                high: hits[0].speed_of_peak_force(load.high),
            },
        })
    }

    /// Speed across the surface at which a hit reaches the load whose contact yields under a pressure [Pa] [m/s].
    pub fn yielding_speed(&self, yield_pressure: f64) -> Interval {
        let speed = |hit, load| speed_of_yielded_force(hit, load, yield_pressure);
        let [softest, best, stiffest] = &self.hits;
        Interval {
            low: speed(stiffest, self.load.low),
            best: speed(best, self.load.best),
            high: speed(softest, self.load.high),
        }
    }

    /// Height of a fall from rest that ends at the speed, `v²/2g`, without drag [m].
    pub fn drop_height(&self) -> Interval {
        self.speed.map(|speed| speed.powi(2) / (2.0 * GRAVITY))
    }

    /// Least slope against the horizontal of a chute that pellets falling straight down at `arrival_speed` [m/s] may
    /// land on: there only `v cos(slope)` goes across the surface [rad].
    ///
    /// 0 where they may land on the flat. The greatest slope belongs to the least speed.
    pub fn chute_slope(&self, arrival_speed: f64) -> Interval {
        self.speed
            .map(|speed| (speed / arrival_speed).min(1.0).acos())
    }
}

/// Speed at the end of a fall from rest through `height` [m], `√(2 g h)`, without drag [m/s].
pub fn speed_of_fall(height: f64) -> f64 {
    (2.0 * GRAVITY * height).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scatter::Scatter;
    use pelletflow_core::{Material, MaterialPair, PairProperties};

    fn hit(youngs_modulus: f64) -> ElasticImpact {
        let pellet = Material {
            density: 3800.0,
            youngs_modulus,
            poisson_ratio: 0.25,
        };
        let steel = Material {
            density: 7850.0,
            youngs_modulus: 207.0e9,
            poisson_ratio: 0.28,
        };
        let properties = PairProperties {
            restitution: 1.0,
            friction: 0.0,
            rolling_friction: 0.0,
            ..PairProperties::ELASTIC
        };
        let radius = 6.0e-3_f64;
        let mass = 3800.0 * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        ElasticImpact::on_plane(
            &MaterialPair::new(&pellet, &steel, &properties),
            radius,
            mass,
            1.0,
        )
    }

    fn safe(strength: Scatter, size: Option<u32>) -> SafeSpeed {
        let strength = Strength {
            scatter: strength,
            test_diameter: None,
            sample_size: size,
        };
        let best = hit(1.0e9);
        let modulus = best.effective_youngs_modulus;
        SafeSpeed::new(
            &strength,
            0.01,
            0.012,
            &best,
            [modulus / 2.0, modulus * 2.0],
        )
        .expect("good numbers")
    }

    #[test]
    fn a_12_mm_pellet_of_1_gpa_reaches_2_5_kn_at_21_6_m_per_s() {
        // And 12.7, 10.2 and 8.2 m/s at 5, 10 and 20 GPa: closed form worked out by hand, three digits.
        for (modulus, expected) in [(1.0e9, 21.6), (5.0e9, 12.7), (10.0e9, 10.2), (20.0e9, 8.2)] {
            let speed = hit(modulus).speed_of_peak_force(2500.0);
            assert!((speed - expected).abs() < 0.05, "{modulus:e}: {speed}");
        }
    }

    #[test]
    fn a_hit_at_the_safe_speed_breaks_the_share_asked_for() {
        let scatter = Scatter::log_normal_from_mean(2450.0, 0.3).expect("good numbers");
        let safe = safe(scatter, Some(60));
        let at_speed = ElasticImpact {
            speed: safe.speed.best,
            ..hit(1.0e9)
        };
        let strength = Strength {
            scatter,
            test_diameter: None,
            sample_size: None,
        };
        let broken = strength
            .broken(at_speed.peak_force(), 0.012)
            .expect("a share");
        assert!((broken / 0.01 - 1.0).abs() < 1.0e-7, "{broken}");
        assert!(safe.speed.low < safe.speed.best && safe.speed.best < safe.speed.high);
    }

    #[test]
    fn stiffness_twice_as_large_takes_a_fifth_off_the_speed() {
        // P ∝ v^1.2 E^0.4, so v ∝ E^(−1/3).
        let safe = safe(Scatter::Fixed(2450.0), None);
        assert!((safe.speed.best / safe.speed.low - 2.0_f64.cbrt()).abs() < 1.0e-12);
        assert!((safe.speed.high / safe.speed.best - 2.0_f64.cbrt()).abs() < 1.0e-12);
    }

    #[test]
    fn pellets_that_yield_may_arrive_faster_and_those_that_never_do_no_faster() {
        let safe = safe(Scatter::Fixed(2450.0), None);
        let pressure = hit(1.0e9).pressure(2450.0);
        let [early, never] = [0.5, 2.0].map(|share| safe.yielding_speed(share * pressure));
        assert!(early.best > safe.speed.best && early.low < early.best && early.best < early.high);
        assert!((never.best / safe.speed.best - 1.0).abs() < 1.0e-14);
    }

    #[test]
    fn drop_height_and_chute_slope_follow_from_the_speed() {
        let safe = safe(Scatter::Fixed(2450.0), None);
        let height = safe.drop_height();
        assert!((speed_of_fall(height.best) / safe.speed.best - 1.0).abs() < 1.0e-14);
        let slope = safe.chute_slope(2.0 * safe.speed.best);
        assert!((slope.best - std::f64::consts::FRAC_PI_3).abs() < 1.0e-14);
        assert!(slope.low < slope.best && slope.best < slope.high);
        assert_eq!(safe.chute_slope(0.5 * safe.speed.low).best, 0.0);
    }
}
