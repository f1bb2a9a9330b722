//! What friction does in an oblique hit: a solid sphere on a flat wall.
//!
//! Friction does not act back on the normal motion, so the surfaces slide after it: with no normal force left over,
//! `ṡ = −F_t (1/m + R²/I) = −7/2 F_t/m` for the sliding speed `s` of a solid sphere's contact point.

use crate::error::{ImpactError, positive};
use crate::fit::LogisticFit;
use crate::head_on::{HeadOn, Moment};

/// `m (1/m + R²/I)` of a solid sphere: what a tangential force changes at its contact point [-].
const CONTACT_POINT_MOBILITY: f64 = 3.5;

/// Share of a change of the sliding speed that the spin of a solid sphere takes; the center takes the rest [-].
const SHARE_OF_SPIN: f64 = 2.5 / 3.5;

/// Foundation elements across half of the contact; with 400 the sliding speed after the hit is right to 1e-3 of
/// `μ v_n` (tested) [-].
const ELEMENTS: usize = 400;

/// How surfaces resist sliding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slip {
    /// Coulomb's friction at once: the paper's (10), with rest where the sliding ends.
    Coulomb,
    /// One spring of Mindlin's stiffness, capped by Coulomb's friction: what flows use.
    Mindlin,
    /// Partial slip of Mindlin and Deresiewicz, by the method of dimensionality reduction (Popov & Heß 2015).
    Partial,
}

/// How a sphere comes to a flat wall, beside its normal speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// Speed of the center along the surface [m/s].
    pub tangential_speed: f64,
    /// Spin; more than 0 where it adds to the tangential speed at the contact point [rad/s].
    pub spin: f64,
    /// Radius of the sphere [m].
    pub radius: f64,
    /// Coulomb's coefficient of friction [-].
    pub friction: f64,
    /// Tangential over normal stiffness of the pair, `4 G* / E*` [-].
    pub stiffness_ratio: f64,
    /// How the surfaces resist sliding.
    pub slip: Slip,
}

/// One moment of an oblique hit, at the same time as the sample of the normal motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ObliqueSample {
    /// Force on the sphere along the surface [N].
    pub tangential_force: f64,
    /// Speed of the center along the surface [m/s].
    pub tangential_speed: f64,
    /// Spin [rad/s].
    pub spin: f64,
}

/// What an oblique hit comes to.
#[derive(Debug, Clone, PartialEq)]
pub struct Rebound {
    /// Speed of the center along the surface [m/s].
    pub tangential_speed: f64,
    /// Spin [rad/s].
    pub spin: f64,
    /// Speed of the contact point along the surface [m/s].
    pub sliding_speed: f64,
    /// Tangential speed after over before; none where there was none [-].
    pub tangential_restitution: Option<f64>,
    /// Logistic curve fitted to the tangential speed; none where it does not change.
    pub speed_fit: Option<LogisticFit>,
    /// Logistic curve fitted to the spin; none where it does not change.
    pub spin_fit: Option<LogisticFit>,
    /// The hit over time.
    pub samples: Vec<ObliqueSample>,
}

impl Approach {
    pub(crate) fn validate(&self) -> Result<(), ImpactError> {
        positive("radius", "m", self.radius)?;
        positive("stiffness ratio", "", self.stiffness_ratio)?;
        if self.friction >= 0.0 && self.friction.is_finite() {
            return Ok(());
        }
        Err(ImpactError::OutOfBounds {
            quantity: "friction",
            value: self.friction,
            unit: "",
            expected: "0 or more",
        })
    }

    /// Follows the sliding through evenly spaced `moments` of a hit, and keeps every `stride`th.
    pub(crate) fn follow(
        &self,
        hit: &HeadOn,
        moments: &[Moment],
        stride: usize,
        units: &Units,
    ) -> Result<Rebound, ImpactError> {
        let first_slide = (self.tangential_speed + self.radius * self.spin) / units.speed;
        let slides = match self.slip {
            Slip::Coulomb => self.coulomb(hit, moments, first_slide),
            Slip::Mindlin => self.march(hit, moments, first_slide, SingleSpring::default()),
            Slip::Partial => self.march(hit, moments, first_slide, Foundation::new(hit)),
        };
        let samples: Vec<ObliqueSample> = slides
            .iter()
            .step_by(stride)
            .map(|slide| {
                let change = (slide.speed - first_slide) * units.speed;
                ObliqueSample {
                    tangential_force: slide.force * units.force,
                    tangential_speed: self.tangential_speed + (1.0 - SHARE_OF_SPIN) * change,
                    spin: self.spin + SHARE_OF_SPIN * change / self.radius,
                }
            })
            .collect();
        let curve = |value: fn(&ObliqueSample) -> f64| {
            let last = (samples.len() - 1) as f64;
            let points: Vec<[f64; 2]> = samples
                .iter()
                .enumerate()
                .map(|(index, sample)| [index as f64 / last, value(sample)])
                .collect();
            LogisticFit::new(&points)
        };
        let end = *samples.last().expect("a hit has a first and a last moment");
        Ok(Rebound {
            tangential_speed: end.tangential_speed,
            spin: end.spin,
            sliding_speed: end.tangential_speed + self.radius * end.spin,
            tangential_restitution: (self.tangential_speed != 0.0)
                .then(|| end.tangential_speed / self.tangential_speed),
            speed_fit: curve(|sample| sample.tangential_speed)?,
            spin_fit: curve(|sample| sample.spin)?,
            samples,
        })
    }

    /// Sliding that Coulomb's friction alone slows, in closed form: what is lost follows the normal impulse.
    fn coulomb(&self, hit: &HeadOn, moments: &[Moment], first_slide: f64) -> Vec<Slide> {
        let slowing = CONTACT_POINT_MOBILITY * self.friction;
        moments
            .iter()
            .map(|moment| {
                let impulse = 1.0 - moment.rate;
                let left = (first_slide.abs() - slowing * impulse).max(0.0);
                let is_sliding = left > 0.0;
                Slide {
                    speed: left.copysign(first_slide),
                    force: if is_sliding {
                        -(self.friction * hit.force(moment)).copysign(first_slide)
                    } else {
                        0.0
                    },
                }
            })
            .collect()
    }

    /// Sliding against springs, by velocity Verlet over the moments.
    fn march(
        &self,
        hit: &HeadOn,
        moments: &[Moment],
        first_slide: f64,
        mut springs: impl Springs,
    ) -> Vec<Slide> {
        let mut slide = Slide {
            speed: first_slide,
            force: 0.0,
        };
        let mut slides = vec![slide];
        for pair in moments.windows(2) {
            let step = pair[1].time - pair[0].time;
            let half = 0.5 * CONTACT_POINT_MOBILITY * step;
            let middle = slide.speed + half * slide.force;
            let cap = Cap {
                overlap: pair[1].overlap.max(0.0),
                friction: self.friction,
                normal_force: hit.force(&pair[1]).max(0.0),
            };
            slide.force =
                -self.stiffness_ratio * springs.stretch(middle * step, &cap, self.stiffness_ratio);
            slide.speed = middle + half * slide.force;
            slides.push(slide);
        }
        slides
    }
}

/// The units of a hit, which turn its own numbers into those of the world.
pub(crate) struct Units {
    /// Normal speed of approach [m/s].
    pub(crate) speed: f64,
    /// `m v² / L` [N].
    pub(crate) force: f64,
}

/// Speed of the contact point and tangential force, in the units of the hit.
#[derive(Debug, Clone, Copy)]
struct Slide {
    speed: f64,
    force: f64,
}

/// What bounds the tangential force at a moment.
struct Cap {
    overlap: f64,
    friction: f64,
    normal_force: f64,
}

/// Elastic surfaces that stick until friction lets them go.
trait Springs {
    /// Force per stiffness ratio after the surfaces have moved by `growth`.
    fn stretch(&mut self, growth: f64, cap: &Cap, stiffness_ratio: f64) -> f64;
}

/// Mindlin's one spring, `8 G* a ξ`.
#[derive(Debug, Default)]
struct SingleSpring {
    displacement: f64,
}

impl Springs for SingleSpring {
    fn stretch(&mut self, growth: f64, cap: &Cap, stiffness_ratio: f64) -> f64 {
        // In these units 2 E* a is 3/2 √x.
        let stiffness = 1.5 * cap.overlap.sqrt();
        let limit = cap.friction * cap.normal_force / stiffness_ratio;
        let moved = self.displacement + growth;
        let force = (stiffness * moved).clamp(-limit, limit);
        self.displacement = if stiffness > 0.0 {
            force / stiffness
        } else {
            moved
        };
        force
    }
}

/// A row of independent springs whose sum is the partial slip of a sphere (Popov & Heß 2015, chapter 5).
#[derive(Debug)]
struct Foundation {
    /// Distance between two elements.
    spacing: f64,
    displacements: Vec<f64>,
}

impl Foundation {
    fn new(hit: &HeadOn) -> Self {
        Self {
            spacing: hit.deepest.overlap.sqrt() / ELEMENTS as f64,
            displacements: vec![0.0; ELEMENTS],
        }
    }
}

impl Springs for Foundation {
    fn stretch(&mut self, growth: f64, cap: &Cap, stiffness_ratio: f64) -> f64 {
        // Damping presses on every element in proportion.
        let elastic = cap.overlap * cap.overlap.sqrt();
        let pressing = if elastic > 0.0 {
            cap.friction * cap.normal_force / elastic / stiffness_ratio
        } else {
            0.0
        };
        let mut sum = 0.0;
        for (index, displacement) in self.displacements.iter_mut().enumerate() {
            let place = (index as f64 + 0.5) * self.spacing;
            let depth = cap.overlap - place * place;
            if depth <= 0.0 {
                *displacement = 0.0;
                continue;
            }
            let limit = pressing * depth;
            *displacement = (*displacement + growth).clamp(-limit, limit);
            sum += *displacement;
        }
        1.5 * self.spacing * sum
    }
}
