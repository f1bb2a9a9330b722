//! The part of a contact's memory that only some laws need, as a row of numbers.

use super::{ContactHistory, ContactLaws, NormalLaw, TangentialLaw, TurningLaw};

impl ContactLaws {
    /// Numbers that a contact remembers beside its tangential stretch and its normal force [-].
    pub fn extra_numbers(&self) -> usize {
        let mut count = 0;
        self.each_extra(&mut ContactHistory::default(), |_| count += 1);
        count
    }

    /// Writes these numbers of a memory.
    pub fn pack(&self, history: &ContactHistory, into: &mut [f64]) {
        let mut places = into.iter_mut();
        self.each_extra(&mut { *history }, |number| {
            if let Some(place) = places.next() {
                *place = *number;
            }
        });
    }

    /// Reads these numbers into a memory.
    pub fn unpack(&self, from: &[f64], history: &mut ContactHistory) {
        let mut places = from.iter();
        self.each_extra(history, |number| {
            if let Some(place) = places.next() {
                *number = *place;
            }
        });
    }

    /// Visits these numbers: the one place that says which they are and in which order.
    fn each_extra(self, history: &mut ContactHistory, mut visit: impl FnMut(&mut f64)) {
        if self.normal == NormalLaw::Plastic {
            visit(&mut history.deepest_overlap);
        }
        if self.rolling == TurningLaw::SpringDashpot {
            history.rolling_stretch.iter_mut().for_each(&mut visit);
        }
        if self.twisting == TurningLaw::SpringDashpot {
            visit(&mut history.twisting_stretch);
        }
        if self.tangential == TangentialLaw::PartialSlip {
            let sliders = &mut history.sliders;
            visit(&mut sliders.length);
            visit(&mut sliders.covered);
            sliders.ahead.iter_mut().for_each(&mut visit);
            let displacements = sliders.displacements.iter_mut();
            displacements.flat_map(|row| row.iter_mut()).for_each(visit);
        }
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
