//! Sticky contact (Johnson, Kendall & Roberts 1971), with the damping of Hertz.
//!
//! `F = 4 E* a³ / (3 R*) − √(8 π w E* a³)` and `δ = a²/R* − √(2 π w a / E*)`, with w the work of adhesion and a the radius
//! of the contact circle. The bodies stick from first touch, at no overlap, until their surfaces are apart by the
//! pull-off gap, where the neck between them tears (Johnson 1985, section 5.5).

use super::{Normal, NormalForce, hertz};
use crate::MaterialPair;
use crate::contact::{Contact, ContactHistory};
use std::f64::consts::PI;

/// A contact whose surfaces stick.
#[derive(Debug, Clone, Copy)]
pub struct Jkr;

/// Steps of Newton's method for the contact radius: from above, it meets every bit but next to the pull-off gap [-].
const NEWTON_STEPS: u32 = 12;

/// One sticky contact, in terms of the radius a of its circle.
struct Neck {
    /// Effective radius [m].
    radius: f64,
    /// Effective modulus [Pa].
    modulus: f64,
    /// `√(2 π w / E*)`, which times `√a` is what adhesion takes off the overlap [m^½].
    pull: f64,
    /// Contact radius at first touch, where the overlap is 0 [m].
    at_touch: f64,
}

impl Neck {
    fn new(effective_radius: f64, pair: &MaterialPair) -> Self {
        let modulus = pair.effective_youngs_modulus;
        let pull = (2.0 * PI * pair.surface_energy / modulus).sqrt();
        Self {
            radius: effective_radius,
            modulus,
            pull,
            at_touch: (pull * effective_radius).powf(2.0 / 3.0),
        }
    }

    /// Gap at which the neck tears [m].
    fn gap(&self) -> f64 {
        // There dδ/da = 0: a = a₀ / 16^⅓.
        3.0 * self.at_touch * self.at_touch / (16.0_f64.powf(2.0 / 3.0) * self.radius)
    }

    /// Contact radius at an overlap [m], on the branch that is stable.
    fn contact_radius(&self, overlap: f64) -> f64 {
        let mut root = ((self.radius * overlap.max(0.0)).sqrt() + self.at_touch).sqrt();
        for _ in 0..NEWTON_STEPS {
            let cubed = root * root * root;
            let slope = 4.0 * cubed / self.radius - self.pull;
            let miss = root * cubed / self.radius - self.pull * root - overlap;
            root -= if slope > 0.0 { miss / slope } else { 0.0 };
        }
        root * root
    }

    /// Force at a contact radius [N].
    fn force(&self, a: f64) -> f64 {
        self.modulus * (4.0 * a * a / (3.0 * self.radius) - 2.0 * self.pull * a.sqrt()) * a
    }

    /// Work done on the spring since first touch, `∫ F dδ` [J].
    fn energy(&self, a: f64) -> f64 {
        let (radius, pull) = (self.radius, self.pull);
        let potential = |a: f64| {
            let steep = 8.0 * a.powi(5) / (15.0 * radius * radius);
            let mixed = 4.0 / 3.0 * pull * a.powf(3.5) / radius;
            self.modulus * (steep - mixed + 0.5 * (pull * a).powi(2))
        };
        potential(a) - potential(self.at_touch)
    }
}

/// Gap between the surfaces at which bodies that touched let go of each other [m]; 0 where they do not stick.
pub fn pull_off_gap(effective_radius: f64, pair: &MaterialPair) -> f64 {
    Neck::new(effective_radius, pair).gap()
}

impl Normal for Jkr {
    const ELASTIC_POWER: f64 = 0.0;
    const DAMPING_POWER: f64 = 0.25;
    const ENDS_AT_ZERO: bool = false;

    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        _: &ContactHistory,
        approach_speed: f64,
    ) -> NormalForce {
        let neck = Neck::new(contact.effective_radius, pair);
        let gap = neck.gap();
        if contact.overlap < -gap {
            let torn = neck.energy(neck.contact_radius(-gap));
            return NormalForce {
                spring_heat: torn,
                is_touching: false,
                ..NormalForce::of_spring(contact, 0.0, 0.0, 0.0, 0.0)
            };
        }
        let contact_radius = neck.contact_radius(contact.overlap);
        let stiffness = 2.0 * pair.effective_youngs_modulus * contact_radius;
        let elastic = neck.force(contact_radius);
        let energy = neck.energy(contact_radius);
        NormalForce {
            damping: hertz::damping(contact, pair, stiffness),
            least: elastic.min(0.0),
            // Twice the pull-off force (Thornton 1991).
            adhesion: 3.0 * PI * pair.surface_energy * contact.effective_radius,
            ..NormalForce::of_spring(contact, contact_radius, elastic, stiffness, energy)
        }
        .at_speed(approach_speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Material, PairProperties, Vec3};

    fn pair(surface_energy: f64) -> MaterialPair {
        let material = Material {
            density: 2650.0,
            youngs_modulus: 70.0e9,
            poisson_ratio: 0.3,
        };
        let properties = PairProperties {
            surface_energy: Some(surface_energy),
            ..PairProperties::ELASTIC
        };
        MaterialPair::new(&material, &material, &properties)
    }

    fn at(overlap: f64) -> Contact {
        Contact {
            normal: Vec3::z(),
            overlap,
            relative_velocity: Vec3::zeros(),
            relative_spin: Vec3::zeros(),
            effective_radius: 0.5e-3,
            effective_mass: 1.0e-6,
            inverse_mass: 1.0 / 1.0e-6,
        }
    }

    fn force(overlap: f64, surface_energy: f64) -> NormalForce {
        Jkr::force(
            &at(overlap),
            &pair(surface_energy),
            &ContactHistory::default(),
            0.0,
        )
    }

    #[test]
    fn the_pull_is_eight_ninths_of_that_to_part_at_first_touch_and_five_ninths_where_the_neck_tears()
     {
        // Pull-off under load is 3/2 π w R* (Johnson, Kendall & Roberts 1971).
        let pull_off = 1.5 * PI * 0.4 * 0.5e-3;
        let at_touch = force(0.0, 0.4).force;
        assert!((at_touch / -pull_off - 8.0 / 9.0).abs() < 1.0e-9);
        let gap = pull_off_gap(0.5e-3, &pair(0.4));
        let at_tear = force(-gap * (1.0 - 1.0e-12), 0.4).force;
        assert!(
            // Newton's method only halves its miss from step to step there.
            (at_tear / -pull_off - 5.0 / 9.0).abs() < 1.0e-3,
            "{at_tear}"
        );
        assert!(!force(-gap * 1.001, 0.4).is_touching);
        let greatest = (0..2000)
            .map(|place| -force(gap * (f64::from(place) / 1000.0 - 1.0), 0.4).force)
            .fold(0.0, f64::max);
        assert!((greatest / pull_off - 1.0).abs() < 1.0e-5, "{greatest}");
    }

    #[test]
    fn tearing_costs_the_work_of_the_published_closed_form() {
        // 7.09 (Γ⁵ R*⁴ / E*²)^⅓ with Γ = w (Thornton & Ning 1998, eq. 64, whose Γ is the interface energy).
        let torn = force(-1.0e-3, 0.4).spring_heat;
        let modulus = pair(0.4).effective_youngs_modulus;
        let published = 7.09 * (0.4_f64.powi(5) * 0.5e-3_f64.powi(4) / modulus.powi(2)).cbrt();
        assert!(
            (torn / published - 1.0).abs() < 2.0e-3,
            "{torn} {published}"
        );
    }

    #[test]
    fn without_adhesion_it_is_hertz() {
        let sticky = force(2.0e-6, 0.0);
        let hertz =
            super::super::Hertz::force(&at(2.0e-6), &pair(0.0), &ContactHistory::default(), 0.0);
        assert!((sticky.force / hertz.force - 1.0).abs() < 1.0e-12);
        assert!((sticky.elastic_energy / hertz.elastic_energy - 1.0).abs() < 1.0e-12);
    }
}
