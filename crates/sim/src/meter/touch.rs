//! A contact with a wall in one step, as meters see it.

use pelletflow_core::{Contact, ContactForce, Vec3};

/// A contact with a wall that a meter watches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WallTouch {
    /// Index of the wall.
    pub(crate) wall: usize,
    /// Whether the two did not touch a step before.
    pub(crate) is_first: bool,
    /// Contact point, in the world [m].
    pub(crate) point: Vec3,
    /// Velocity of the pellet's center relative to the wall's surface [m/s].
    pub(crate) velocity: Vec3,
    /// Coefficient of friction of the two [-].
    pub(crate) friction: f64,
    /// How the pellet touches.
    pub(crate) contact: Contact,
    /// What that does to the pellet.
    pub(crate) force: ContactForce,
}

impl WallTouch {
    /// Mass of the pellet: a wall has no inverse mass [kg].
    pub(crate) fn mass(&self) -> f64 {
        self.contact.effective_mass
    }

    /// Speed of approach along the normal [m/s].
    pub(crate) fn approach_speed(&self) -> f64 {
        -self.velocity.dot(&self.contact.normal)
    }

    /// Speed along the surface, without that of spin [m/s].
    pub(crate) fn tangential_speed(&self) -> f64 {
        self.along_surface(self.velocity).norm()
    }

    /// Rate at which friction works on the slip at the contact point [W].
    pub(crate) fn friction_power(&self) -> f64 {
        let slip = self.along_surface(self.contact.relative_velocity);
        -self.force.force.dot(&slip)
    }

    fn along_surface(&self, velocity: Vec3) -> Vec3 {
        let normal = self.contact.normal;
        velocity - velocity.dot(&normal) * normal
    }
}
