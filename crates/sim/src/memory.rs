//! What a contact remembers between steps.

use crate::state::Row;
use pelletflow_core::{ContactHistory, Vec3};

/// What one listed contact remembers, in half a cache line.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ContactMemory {
    /// Elastic tangential displacement of the pellet relative to its partner [m].
    pub tangential_displacement: [f64; 3],
    /// Normal force of the last step [N]; rounded, for it only completes a predicted speed.
    pub normal_force: f32,
    /// Steps since first touch [-]; 0 where the two do not touch.
    pub steps: u32,
}

const _: () = assert!(size_of::<ContactMemory>() == size_of::<Row>());

impl ContactMemory {
    /// As the contact laws need it.
    #[inline]
    pub(crate) fn history(&self) -> ContactHistory {
        ContactHistory {
            tangential_displacement: Vec3::from(self.tangential_displacement),
            normal_force: f64::from(self.normal_force),
        }
    }

    /// One step later.
    #[inline]
    pub(crate) fn stepped(&self, history: &ContactHistory) -> Self {
        Self {
            tangential_displacement: history.tangential_displacement.into(),
            // More than 0 while the bodies touch, however little they push.
            normal_force: (history.normal_force as f32).max(f32::MIN_POSITIVE),
            steps: self.steps.saturating_add(1),
        }
    }

    /// The same contact as its partner remembers it.
    pub(crate) fn mirrored(&self) -> Self {
        Self {
            tangential_displacement: self.tangential_displacement.map(|component| -component),
            ..*self
        }
    }
}
