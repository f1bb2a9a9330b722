//! A hit in full: its force over time, and every number of the method.

use crate::damping::Damping;
use crate::elastic::ElasticImpact;
use crate::error::ImpactError;
use crate::fit::{BellFit, SineFit};
use crate::head_on::HeadOn;
use crate::oblique::{Approach, Rebound, Units};
use crate::outline::Outline;

/// Intervals between the samples of a hit [-].
const INTERVALS: usize = 400;

/// Steps of the tangential motion per sample [-].
const STRIDE: usize = 10;

/// One moment of a hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time since first touch [s].
    pub time: f64,
    /// Normal force [N].
    pub force: f64,
    /// Depth of the overlap [m].
    pub overlap: f64,
    /// Rate at which the overlap grows [m/s].
    pub approach_speed: f64,
}

/// One hit from first touch to release.
///
/// ```
/// use pelletflow_impact::{Damping, ElasticImpact, Impact};
///
/// let hit = ElasticImpact {
///     effective_youngs_modulus: 153.74e6,
///     effective_radius: 7.5e-3,
///     effective_mass: 6.5e-3,
///     speed: 5.0,
/// };
/// let impact = Impact::new(&hit, Damping::Restitution(0.5), None)?;
/// assert!(impact.outline.peak_force < hit.peak_force());
/// assert!((impact.outline.restitution - 0.5).abs() < 1.0e-6);
/// # Ok::<(), pelletflow_impact::ImpactError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Impact {
    /// Normal speed of approach [m/s].
    pub speed: f64,
    /// Its numbers.
    pub outline: Outline,
    /// The paper's bell curve, fitted to the force.
    pub bell: BellFit,
    /// A power of the sine, fitted to the force.
    pub sine: SineFit,
    /// The force over time, evenly spaced from first touch to release.
    pub samples: Vec<Sample>,
    /// What becomes of sliding and spin, in an oblique hit.
    pub rebound: Option<Rebound>,
}

impl Impact {
    /// Follows a hit whose bodies, normal speed and elasticity are those of `hit`.
    ///
    /// # Errors
    ///
    /// When a quantity is outside its bounds, or the solver finds no release.
    pub fn new(
        hit: &ElasticImpact,
        damping: Damping,
        approach: Option<&Approach>,
    ) -> Result<Self, ImpactError> {
        hit.validate()?;
        damping.validate()?;
        approach.map_or(Ok(()), Approach::validate)?;

        let head_on = HeadOn::new(damping.law(hit))?;
        let length = hit.length();
        let time = length / hit.speed;
        let units = Units {
            speed: hit.speed,
            force: hit.effective_mass * hit.speed.powi(2) / length,
        };
        let moments = head_on.moments(INTERVALS * STRIDE)?;
        let samples: Vec<Sample> = moments
            .iter()
            .step_by(STRIDE)
            .map(|moment| Sample {
                time: moment.time * time,
                force: head_on.force(moment) * units.force,
                overlap: moment.overlap * length,
                approach_speed: moment.rate * hit.speed,
            })
            .collect();

        let outline = Outline::new(hit, &head_on);
        let shape: Vec<[f64; 2]> = samples
            .iter()
            .map(|sample| {
                [
                    sample.time / outline.contact_time,
                    sample.force / outline.peak_force,
                ]
            })
            .collect();
        Ok(Self {
            speed: hit.speed,
            bell: BellFit::new(&shape, outline.asymmetry)?,
            sine: SineFit::new(&shape)?,
            samples,
            rebound: approach
                .map(|approach| approach.follow(&head_on, &moments, STRIDE, &units))
                .transpose()?,
            outline,
        })
    }
}
