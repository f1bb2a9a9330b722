//! The numbers of a hit without its curve, for many hits at once.
//!
//! In its own lengths and times a damped hit depends on one number of the material, so that hits of the same
//! restitution are solved once whatever their speeds and sizes are.

use crate::damping::Damping;
use crate::elastic::ElasticImpact;
use crate::error::{ImpactError, positive};
use crate::head_on::HeadOn;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// The numbers of a hit along the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outline {
    /// Greatest normal force [N].
    pub peak_force: f64,
    /// Time from first touch to release [s].
    pub contact_time: f64,
    /// Greatest approach of the two bodies [m].
    pub max_approach: f64,
    /// Radius of the contact circle at the greatest approach, `√(R* δ)` [m].
    pub contact_radius: f64,
    /// Greatest pressure, in the middle of the contact under the greatest force [Pa].
    pub peak_pressure: f64,
    /// Rebound speed over approach speed, along the normal [-].
    pub restitution: f64,
    /// Impulse along the normal, `m* v (1 + e)` [N·s].
    pub impulse: f64,
    /// `k_P`, the impulse over greatest force times contact time [-].
    pub specific_impulse: f64,
    /// `χ_P`, the greatest force over the contact time [N/s].
    pub peak_parameter: f64,
    /// `τ_max`, the moment of the greatest force over the contact time [-].
    pub asymmetry: f64,
}

impl Outline {
    /// Of a hit whose motion along the normal is known.
    pub(crate) fn new(hit: &ElasticImpact, head_on: &HeadOn) -> Self {
        let length = hit.length();
        let time = length / hit.speed;
        let force = hit.effective_mass * hit.speed.powi(2) / length;
        let peak_force = head_on.force(&head_on.hardest) * force;
        // As each sample of the curve is put into seconds: the last one is then at the release to the bit.
        let contact_time = head_on.release.time * time;
        let max_approach = head_on.deepest.overlap * length;
        let restitution = -head_on.release.rate;
        let impulse = hit.effective_mass * hit.speed * (1.0 + restitution);
        Self {
            peak_force,
            contact_time,
            max_approach,
            contact_radius: (hit.effective_radius * max_approach).sqrt(),
            peak_pressure: hit.pressure(peak_force),
            restitution,
            impulse,
            specific_impulse: impulse / (peak_force * contact_time),
            peak_parameter: peak_force / contact_time,
            asymmetry: head_on.hardest.time / head_on.release.time,
        }
    }
}

/// Works out many hits, each law of motion once.
///
/// ```
/// use pelletflow_impact::{Damping, ElasticImpact, Outlines};
///
/// let mut outlines = Outlines::default();
/// let hit = ElasticImpact {
///     effective_youngs_modulus: 153.74e6,
///     effective_radius: 7.5e-3,
///     effective_mass: 6.5e-3,
///     speed: 5.0,
/// };
/// let outline = outlines.of(&hit, Damping::Restitution(0.5))?;
/// assert!(outline.peak_force < hit.peak_force());
/// # Ok::<(), pelletflow_impact::ImpactError>(())
/// ```
#[derive(Debug, Default)]
pub struct Outlines {
    /// Motions by the bits of what damps them.
    solved: BTreeMap<[u64; 2], HeadOn>,
}

impl Outlines {
    /// The numbers of a hit whose bodies, normal speed and elasticity are those of `hit`.
    ///
    /// # Errors
    ///
    /// When a quantity is outside its bounds, or the solver finds no release.
    pub fn of(&mut self, hit: &ElasticImpact, damping: Damping) -> Result<Outline, ImpactError> {
        hit.validate()?;
        damping.validate()?;
        let head_on = match self.solved.entry(damping.bits(hit)) {
            Entry::Occupied(solved) => solved.into_mut(),
            Entry::Vacant(place) => place.insert(HeadOn::new(damping.law(hit))?),
        };
        Ok(Outline::new(hit, head_on))
    }
}

impl ElasticImpact {
    /// Refuses what is no hit.
    pub(crate) fn validate(&self) -> Result<(), ImpactError> {
        let Self {
            effective_youngs_modulus,
            effective_radius,
            effective_mass,
            speed,
        } = *self;
        positive("effective Young's modulus", "Pa", effective_youngs_modulus)?;
        positive("effective radius", "m", effective_radius)?;
        positive("effective mass", "kg", effective_mass)?;
        positive("speed", "m/s", speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impact::Impact;

    const HIT: ElasticImpact = ElasticImpact {
        effective_youngs_modulus: 153.74e6,
        effective_radius: 7.5e-3,
        effective_mass: 6.5e-3,
        speed: 5.0,
    };

    #[test]
    fn an_elastic_outline_is_hertz_in_closed_form() {
        let mut outlines = Outlines::default();
        for speed in [0.1, 1.0, 9.0] {
            let hit = ElasticImpact { speed, ..HIT };
            let outline = outlines.of(&hit, Damping::None).expect("a hit that ends");
            // The solver promises 1e-7.
            assert!((outline.peak_force / hit.peak_force() - 1.0).abs() < 1.0e-7);
            assert!((outline.contact_time / hit.contact_time() - 1.0).abs() < 1.0e-7);
            assert!((outline.max_approach / hit.greatest_approach() - 1.0).abs() < 1.0e-7);
        }
        assert_eq!(outlines.solved.len(), 1, "one law of motion");
    }

    #[test]
    fn an_outline_that_was_solved_for_another_hit_has_the_numbers_of_its_own_curve() {
        let mut outlines = Outlines::default();
        for damping in [Damping::Restitution(0.5), Damping::Viscoelastic(5.0e-6)] {
            for speed in [1.0, 4.0] {
                let hit = ElasticImpact { speed, ..HIT };
                let outline = outlines.of(&hit, damping).expect("a hit that ends");
                let impact = Impact::new(&hit, damping, None).expect("a hit that ends");
                assert_eq!(outline.peak_force, impact.outline.peak_force);
                assert_eq!(outline.restitution, impact.outline.restitution);
                assert_eq!(outline.asymmetry, impact.outline.asymmetry);
            }
        }
        // The relaxation time counts in the times of the hit, which change with its speed.
        assert_eq!(outlines.solved.len(), 3);
    }
}
