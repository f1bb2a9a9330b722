//! A spring across a contact that sticks until it is let go: under sliding, rolling and twisting alike.
//!
//! Its stiffness k follows the contact radius. It remembers `q = √k ξ` in place of its displacement ξ: the energy stored
//! is then `q²/2` whatever k does, and a contact that grows or shrinks gives the spring no energy. A remembered
//! displacement would: up to 3.6 % of the tangential energy of an elastic hit.

use crate::Vec3;

/// A damped spring that gives way at a cap.
#[derive(Debug, Clone, Copy)]
pub(super) struct CappedSpring {
    /// Root of the stiffness [√(N/m)], or [√(N·m)] for a turn.
    pub(super) root_stiffness: f64,
    /// Damping coefficient [N·s/m], or [N·m·s].
    pub(super) damping: f64,
    /// Greatest force of spring and damper together [N], or torque [N·m].
    pub(super) cap: f64,
}

/// A velocity at a sample, and the times it stands for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sampled {
    /// The velocity [m/s], or [rad/s].
    pub(super) velocity: Vec3,
    /// Time before the sample for which it stands [s].
    pub(super) behind: f64,
    /// Time after the sample [s].
    pub(super) ahead: f64,
}

/// What a spring does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpringForce {
    /// Force [N], or torque [N·m].
    pub force: Vec3,
    /// Energy stored [J].
    pub elastic_energy: f64,
    /// Rate at which the motion works on spring, damper and slider together [W].
    pub power: f64,
}

impl SpringForce {
    /// Nothing at all.
    pub(super) const NONE: Self = Self {
        force: Vec3::new(0.0, 0.0, 0.0),
        elastic_energy: 0.0,
        power: 0.0,
    };
}

impl CappedSpring {
    /// Force of the spring after it was stretched to `stretch` [√J], which moves on with the velocity.
    ///
    /// The force takes the growth up to the sample and the memory that after it too: second order in the step.
    #[inline(always)]
    pub(super) fn pull(&self, sampled: &Sampled, stretch: &mut Vec3) -> SpringForce {
        let Sampled {
            velocity,
            behind,
            ahead,
        } = *sampled;
        let rate = self.root_stiffness * velocity;
        let tried = *stretch + behind * rate;
        let stuck = -self.root_stiffness * tried - self.damping * velocity;
        // Both answers are worked out and one is taken: contacts in a batch must not branch.
        let squared = stuck.norm_squared();
        let share = if squared > self.cap * self.cap {
            self.cap / squared.sqrt()
        } else {
            1.0
        };
        let force = share * stuck;
        // The damper may hold the cap alone; the spring then goes on until it holds it, and no farther.
        let pulled_squared = self.root_stiffness * self.root_stiffness * tried.norm_squared();
        let kept = if pulled_squared > self.cap * self.cap {
            self.cap / pulled_squared.sqrt()
        } else {
            1.0
        };
        let reached = kept * tried;
        *stretch = reached + ahead * rate;
        SpringForce {
            force,
            elastic_energy: 0.5 * reached.norm_squared(),
            power: -force.dot(&velocity),
        }
    }
}

/// A vector turned with the contact: laid into the plane across the normal, its length kept.
#[inline(always)]
pub(super) fn turned_into_plane(vector: Vec3, normal: Vec3) -> Vec3 {
    let flat = vector - vector.dot(&normal) * normal;
    let flat_squared = flat.norm_squared();
    let stretch = (vector.norm_squared() / flat_squared).sqrt();
    flat * if flat_squared > 0.0 { stretch } else { 0.0 }
}
