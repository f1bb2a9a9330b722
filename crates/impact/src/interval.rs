//! A value with the bounds between which it lies.

/// A least, a most and a best value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The least, in the unit of the value [its unit].
    pub low: f64,
    /// The best, in the unit of the value [its unit].
    pub best: f64,
    /// The most, in the unit of the value [its unit].
    pub high: f64,
}

impl Interval {
    /// A value that is known.
    pub fn exact(value: f64) -> Self {
        Self {
            low: value,
            best: value,
            high: value,
        }
    }

    /// The same of another quantity that grows or falls with this one.
    #[must_use]
    pub fn map(&self, quantity: impl Fn(f64) -> f64) -> Self {
        let [low, best, high] = [self.low, self.best, self.high].map(quantity);
        Self {
            low: low.min(high),
            best,
            high: low.max(high),
        }
    }

    /// Whether a value lies between the bounds.
    pub fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}
