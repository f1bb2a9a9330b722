//! The part of a contact's memory that only some laws need, as a row of numbers.

use super::{ContactHistory, ContactLaws, NormalLaw, TangentialLaw, TurningLaw};

/// Which numbers a contact remembers beside its tangential stretch and its normal force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each part of a law needs its numbers or not, whatever the others do"
)]
pub(super) struct Extra {
    pub(super) depth: bool,
    pub(super) rolling: bool,
    pub(super) twisting: bool,
    pub(super) sliders: bool,
}

impl Extra {
    fn of(laws: ContactLaws) -> Self {
        Self {
            depth: laws.normal == NormalLaw::Plastic,
            rolling: laws.rolling == TurningLaw::SpringDashpot,
            twisting: laws.twisting == TurningLaw::SpringDashpot,
            sliders: laws.tangential == TangentialLaw::PartialSlip,
        }
    }

    /// Visits these numbers: the one place that says which they are and in which order.
    #[inline(always)]
    pub(super) fn each(self, history: &mut ContactHistory, mut visit: impl FnMut(&mut f64)) {
        if self.depth {
            visit(&mut history.deepest_overlap);
        }
        if self.rolling {
            for axis in 0..3 {
                visit(&mut history.rolling_stretch[axis]);
            }
        }
        if self.twisting {
            visit(&mut history.twisting_stretch);
        }
        if self.sliders {
            let sliders = &mut history.sliders;
            visit(&mut sliders.length);
            visit(&mut sliders.covered);
            for displacement in
                std::iter::once(&mut sliders.ahead).chain(&mut sliders.displacements)
            {
                for axis in 0..3 {
                    visit(&mut displacement[axis]);
                }
            }
        }
    }
}

impl ContactLaws {
    /// Numbers that a contact remembers beside its tangential stretch and its normal force [-].
    pub fn extra_numbers(&self) -> usize {
        let mut count = 0;
        Extra::of(*self).each(&mut ContactHistory::default(), |_| count += 1);
        count
    }

    /// Writes these numbers of a memory.
    pub fn pack(&self, history: &ContactHistory, into: &mut [f64]) {
        let mut places = into.iter_mut();
        Extra::of(*self).each(&mut { *history }, |number| {
            if let Some(place) = places.next() {
                *place = *number;
            }
        });
    }

    /// Reads these numbers into a memory.
    pub fn unpack(&self, from: &[f64], history: &mut ContactHistory) {
        let mut places = from.iter();
        Extra::of(*self).each(history, |number| {
            if let Some(place) = places.next() {
                *number = *place;
            }
        });
    }
}

impl ContactHistory {
    /// The same contact as its other body remembers it.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut sliders = self.sliders;
        sliders.ahead = -sliders.ahead;
        sliders.displacements = sliders.displacements.map(|displacement| -displacement);
        Self {
            tangential_stretch: -self.tangential_stretch,
            rolling_stretch: -self.rolling_stretch,
            sliders,
            ..*self
        }
    }
}
