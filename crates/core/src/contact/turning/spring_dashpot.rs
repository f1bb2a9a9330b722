//! A damped spring that gives way at the greatest torque (Ai et al. 2011, type C): a body at rest stays at rest.

use super::{Resistance, Turning};
use crate::Vec3;
use crate::contact::spring::{CappedSpring, Sampled, SpringForce};

/// Greatest stiffness over `inertia / Δt²` that keeps a step stable with a dozen contacts [-].
const STIFFEST: f64 = 0.25;
/// Share of a body's spin that the damper of one contact may stop in one step [-].
const STOPPED_PER_STEP: f64 = 0.25;

/// A spring and a dashpot that give way together.
#[derive(Debug, Clone, Copy)]
pub struct SpringDashpot;

impl Turning for SpringDashpot {
    const HAS_SPRING: bool = true;

    #[inline(always)]
    fn torque(resistance: &Resistance, spin: Vec3, stretch: &mut Vec3) -> SpringForce {
        let Resistance {
            inertia, time_step, ..
        } = *resistance;
        let stiffness = resistance
            .stiffness
            .min(STIFFEST * inertia / (time_step * time_step));
        let critical = 2.0 * (stiffness * inertia).sqrt();
        let spring = CappedSpring {
            root_stiffness: stiffness.sqrt(),
            damping: (resistance.damping_ratio * critical)
                .min(STOPPED_PER_STEP * inertia / time_step),
            cap: resistance.most,
        };
        let sampled = Sampled {
            velocity: spin,
            behind: 0.5 * time_step,
            ahead: 0.5 * time_step,
        };
        spring.pull(&sampled, stretch)
    }
}
