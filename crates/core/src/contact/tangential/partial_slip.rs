//! Partial slip: the contact sticks in the middle while its rim slides (Mindlin & Deresiewicz 1953).
//!
//! By the method of dimensionality reduction (Popov & Heß 2015, chapter 5) the contact circle of radius a is a row of
//! independent springs from −a to a, each pressed in by `δ − x²/R*` and each let go at friction times that. Here the row
//! is cut into a few sliders of one width; the rim, moving through the outermost, covers a part of it. What the rim
//! covers anew starts unstretched and what it uncovers is let go, so that the row never gains energy by itself.

use super::{Slide, Tangential, damping};
use crate::contact::normal::NormalForce;
use crate::contact::spring::{SpringForce, turned_into_plane};
use crate::contact::{Contact, ContactHistory};
use crate::{MaterialPair, Vec3};
use serde::{Deserialize, Serialize};

/// Sliders across half of the contact [-]: with 10 an elastic hit is within 1 % of the exact solution at any angle.
pub const SLIDERS: usize = 10;

/// Length of a new row over the contact radius of the elastic hit [-]: samples of the overlap miss the truth by a little.
const REACH: f64 = 1.02;

/// A row of springs across a contact, each let go by friction.
#[derive(Debug, Clone, Copy)]
pub struct PartialSlip;

/// What the row remembers.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Sliders {
    /// Radius that the row is long enough for [m]; 0 before first touch.
    pub length: f64,
    /// Contact radius at the last sample [m].
    pub covered: f64,
    /// What the last sample's velocity adds to the displacement after it [m].
    pub ahead: Vec3,
    /// Elastic displacement of each slider, from the middle out [m].
    pub displacements: [Vec3; SLIDERS],
}

impl Sliders {
    /// A row for a contact that has just begun, as long as an elastic hit will reach, and at least `rim` [m].
    fn begun(contact: &Contact, pair: &MaterialPair, rim: f64) -> Self {
        let approach_speed = contact.relative_velocity.dot(&contact.normal);
        let stiffness = 4.0 / 3.0 * pair.effective_youngs_modulus * contact.effective_radius.sqrt();
        let energy = contact.effective_mass * approach_speed * approach_speed;
        let deepest = (1.25 * energy / stiffness).powf(0.4);
        Self {
            length: (REACH * (contact.effective_radius * deepest).sqrt()).max(rim),
            ..Self::default()
        }
    }

    /// The row, twice as long: every two sliders become one, of the same force.
    fn lengthened(&self) -> Self {
        let width = self.width();
        let mut displacements = [Vec3::zeros(); SLIDERS];
        for (index, displacement) in self.displacements.iter().enumerate() {
            let covered = (self.covered - index as f64 * width).clamp(0.0, width);
            let first = (index / 2 * 2) as f64 * width;
            let both = (self.covered - first).clamp(0.0, 2.0 * width);
            if both > 0.0 {
                displacements[index / 2] += covered / both * displacement;
            }
        }
        Self {
            length: 2.0 * self.length,
            displacements,
            ..*self
        }
    }

    fn width(&self) -> f64 {
        self.length / SLIDERS as f64
    }

    fn turned(&self, normal: Vec3) -> Self {
        Self {
            ahead: turned_into_plane(self.ahead, normal),
            displacements: self
                .displacements
                .map(|displacement| turned_into_plane(displacement, normal)),
            ..*self
        }
    }
}

/// The part of one slider that the contact covers, from `inner` to `outer` [m].
struct Covered {
    inner: f64,
    outer: f64,
    /// How much of it was covered at the last sample [m].
    before: f64,
}

impl Covered {
    fn width(&self) -> f64 {
        self.outer - self.inner
    }

    /// Mean of `a² − x²` over the part [m²].
    fn mean_depth(&self, radius_squared: f64) -> f64 {
        let (inner, outer) = (self.inner, self.outer);
        radius_squared - (outer * outer + outer * inner + inner * inner) / 3.0
    }

    /// Share of the time since the last sample for which the part has been covered: the rim moves as `a² ∝ t` [-].
    fn share_of_time(&self, rim_before: f64, rim: f64) -> f64 {
        let grown = rim * rim - rim_before * rim_before;
        let fresh = Self {
            inner: self.inner + self.before,
            ..*self
        };
        if grown <= 0.0 || fresh.width() <= 0.0 {
            return 1.0;
        }
        let of_fresh = fresh.mean_depth(rim * rim) / grown;
        (self.before + fresh.width() * of_fresh) / self.width()
    }
}

impl Tangential for PartialSlip {
    const HAS_SLIDERS: bool = true;

    fn force(
        contact: &Contact,
        pair: &MaterialPair,
        normal: &NormalForce,
        slide: &Slide,
        history: &mut ContactHistory,
    ) -> SpringForce {
        let rim = normal.contact_radius;
        let mut row = history.sliders.turned(contact.normal);
        if row.length <= 0.0 {
            row = Sliders::begun(contact, pair, rim);
        }
        while rim > row.length {
            row = row.lengthened();
        }
        let is_first = row.covered <= 0.0;
        let growth = if is_first {
            slide.elapsed * slide.velocity
        } else {
            row.ahead + 0.5 * slide.time_step * slide.velocity
        };
        let stiffness = 8.0 * pair.effective_shear_modulus;
        // Friction over all the row is μ times the pressing force: ∫ (a² − x²) dx = ⅔ a³ over half of it.
        let limit_per_depth =
            1.5 * pair.friction * normal.pressing() / (stiffness * rim * rim * rim);
        let mut spring = Vec3::zeros();
        let mut elastic_energy = 0.0;
        let width = row.width();
        for (index, displacement) in row.displacements.iter_mut().enumerate() {
            let inner = index as f64 * width;
            let part = Covered {
                inner,
                outer: (inner + width).min(rim),
                before: (row.covered.min(rim) - inner).clamp(0.0, width),
            };
            if part.width() <= 0.0 {
                *displacement = Vec3::zeros();
                continue;
            }
            let kept = part.before / part.width();
            *displacement =
                kept * *displacement + part.share_of_time(row.covered.min(rim), rim) * growth;
            let limit = limit_per_depth * part.mean_depth(rim * rim);
            let length = displacement.norm();
            if length > limit {
                *displacement *= limit / length;
            }
            spring += part.width() * *displacement;
            elastic_energy += 0.5 * stiffness * part.width() * displacement.norm_squared();
        }
        row.covered = rim;
        row.ahead = 0.5 * slide.time_step * slide.velocity;
        history.sliders = row;
        let stuck = -stiffness * spring
            - damping(contact, pair, normal, slide, stiffness * rim) * slide.velocity;
        let cap = pair.friction * normal.pressing();
        let size = stuck.norm();
        let force = if size > cap {
            cap / size * stuck
        } else {
            stuck
        };
        SpringForce {
            force,
            elastic_energy,
            power: -force.dot(&slide.velocity),
        }
    }
}
