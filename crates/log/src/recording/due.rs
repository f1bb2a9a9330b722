//! When something that recurs is due.

use serde::{Deserialize, Serialize};

/// Evenly spaced moments, each met at the step nearest to it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Due {
    interval: f64,
    step: f64,
    /// Number of the next moment, counted from time zero [-].
    next: f64,
}

impl Due {
    /// Every `interval` [s] of a time that advances by `step` [s], after the moment `start` [s].
    pub(crate) fn every(interval: f64, step: f64, start: f64) -> Self {
        let mut due = Self {
            interval,
            step,
            next: 0.0,
        };
        due.is_now(start);
        due
    }

    /// Whether a moment has come since the last call; several that fall on one step count once.
    pub(crate) fn is_now(&mut self, time: f64) -> bool {
        // Counted and not summed: sums drift, and the thousandth frame must be on time too.
        let reached = ((time + self.step / 2.0) / self.interval).floor();
        let is_now = reached >= self.next;
        if is_now {
            self.next = reached + 1.0;
        }
        is_now
    }

    /// The next moment [s].
    pub(crate) fn next(&self) -> f64 {
        self.next * self.interval
    }
}

#[cfg(test)]
mod tests {
    use super::Due;

    fn times(interval: f64, step: f64, steps: u32) -> Vec<f64> {
        let mut due = Due::every(interval, step, 0.0);
        (1..=steps)
            .map(|index| f64::from(index) * step)
            .filter(|&time| due.is_now(time))
            .collect()
    }

    #[test]
    fn each_moment_is_met_at_the_nearest_step() {
        for step in [1.0e-5, 2.9e-5, 7.3e-4, 0.004] {
            let steps = (1.0 / step) as u32;
            let found = times(0.01, step, steps);
            assert!(found.len() >= 98, "{} for {step}", found.len());
            for (time, index) in found.iter().zip(1..) {
                let moment = f64::from(index) * 0.01;
                // Half a step, and the rounding of a sum of a hundred thousand.
                assert!(
                    (time - moment).abs() <= step / 2.0 + 1.0e-12,
                    "{time} for {moment} with {step}"
                );
            }
        }
    }

    #[test]
    fn moments_closer_than_a_step_come_once_a_step() {
        assert_eq!(times(0.001, 0.01, 5).len(), 5);
    }

    #[test]
    fn a_run_that_starts_late_waits_for_the_next_moment() {
        let mut due = Due::every(1.0, 0.01, 2.5);
        assert!(!due.is_now(2.9));
        assert!(due.is_now(3.0));
        assert!(!due.is_now(3.01));
    }

    #[test]
    fn an_endless_interval_never_comes() {
        let mut due = Due::every(f64::INFINITY, 0.01, 0.0);
        assert!(!due.is_now(1.0e9));
    }
}
