//! A value with the bounds between which it lies.

use statrs::distribution::{ContinuousCDF, StudentsT};

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
    /// The mean of what replicates gave, with the interval that holds the true one at a `confidence` [-]
    /// (Student 1908), if they scatter normally.
    ///
    /// One replicate tells no scatter, and none no mean: what is not known is not a number.
    ///
    /// ```
    /// use pelletflow_impact::Interval;
    ///
    /// // t(0.975, 2) = 4.3027 (Student's table), and the standard error is 1/√3.
    /// let mean = Interval::of_mean(&[1.0, 2.0, 3.0], 0.95);
    /// assert_eq!(mean.best, 2.0);
    /// assert!((mean.high - (2.0 + 4.3027 / 3.0_f64.sqrt())).abs() < 1.0e-4);
    /// ```
    pub fn of_mean(values: &[f64], confidence: f64) -> Self {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let error = (squares / (count - 1.0) / count).sqrt();
        let half = StudentsT::new(0.0, 1.0, count - 1.0).map_or(f64::NAN, |student| {
            error * student.inverse_cdf(0.5 + 0.5 * confidence)
        });
        Self {
            low: mean - half,
            best: mean,
            high: mean + half,
        }
    }

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
