//! A motion given by rows of a table: where a wall is at some moments, and how it goes from one to the next.

use super::Placement;
use nalgebra::UnitVector3;
use pelletflow_core::Vec3;
use serde::{Deserialize, Serialize};

/// Displacements and turns at moments; the wall waits at the first row before it and at the last after it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionTable {
    /// Moments, rising; two or more [s].
    pub moments: Vec<f64>,
    /// Displacement from the rest position at each moment [m].
    pub displacements: Vec<Vec3>,
    /// Turn at each moment, right-handed about the axis [rad].
    pub angles: Vec<f64>,
    /// A point of the axis, before the displacement [m].
    pub center: Vec3,
    /// Direction of the axis [-].
    pub axis: UnitVector3<f64>,
    /// How it goes from one row to the next.
    pub interpolation: Interpolation,
}

/// How a motion goes from one row of its table to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Interpolation {
    /// Evenly; the velocity jumps at each row.
    #[default]
    Linear,
    /// By cubics whose velocity is continuous, without overshoot, and zero at both ends.
    Smooth,
}

/// A cubic over one stretch: `start + τ (rate + s (second + s third))`, where s is the share τ of the stretch.
struct Cubic {
    start: f64,
    rate: f64,
    second: f64,
    third: f64,
    length: f64,
}

impl MotionTable {
    /// Where the wall is and how it goes on, at a time [s].
    pub(super) fn at(&self, time: f64) -> Placement {
        let along = |axis: usize| self.follow(|row| self.displacements[row][axis], time);
        let [x, y, z] = [0, 1, 2].map(along);
        let (angle, turn_rate) = self.follow(|row| self.angles[row], time);
        Placement {
            shift: Vec3::new(x.0, y.0, z.0),
            velocity: Vec3::new(x.1, y.1, z.1),
            center: self.center,
            axis: self.axis,
            angle,
            turn_rate,
        }
    }

    /// Greatest rate of each displacement [m/s].
    pub(super) fn greatest_velocity(&self) -> Vec3 {
        Vec3::from_fn(|axis, _| self.greatest_rate(|row| self.displacements[row][axis]))
    }

    /// Greatest rate of the turn [rad/s].
    pub(super) fn greatest_turn_rate(&self) -> f64 {
        self.greatest_rate(|row| self.angles[row])
    }

    /// Greatest size of each displacement; no row is overshot [m].
    pub(super) fn greatest_shift(&self) -> Vec3 {
        let sizes = self.displacements.iter().map(Vec3::abs);
        sizes.fold(Vec3::zeros(), |greatest, size| greatest.sup(&size))
    }

    /// A column and its rate at a time.
    fn follow(&self, column: impl Fn(usize) -> f64, time: f64) -> (f64, f64) {
        let passed = self.moments.partition_point(|&moment| moment <= time);
        if passed == 0 || passed == self.moments.len() {
            return (column(passed.saturating_sub(1)), 0.0);
        }
        let cubic = self.stretch(&column, passed - 1);
        cubic.at(time - self.moments[passed - 1])
    }

    fn greatest_rate(&self, column: impl Fn(usize) -> f64) -> f64 {
        (1..self.moments.len())
            .map(|row| self.stretch(&column, row - 1).greatest_rate())
            .fold(0.0, f64::max)
    }

    /// The way from a row to the next.
    fn stretch(&self, column: &impl Fn(usize) -> f64, row: usize) -> Cubic {
        let (length, mean) = self.secant(column, row);
        let [first, last] = match self.interpolation {
            Interpolation::Linear => [mean, mean],
            Interpolation::Smooth => [row, row + 1].map(|row| self.slope(column, row)),
        };
        Cubic {
            start: column(row),
            rate: first,
            second: 3.0 * mean - 2.0 * first - last,
            third: first + last - 2.0 * mean,
            length,
        }
    }

    /// Time from a row to the next [s], and the mean rate on the way.
    fn secant(&self, column: &impl Fn(usize) -> f64, row: usize) -> (f64, f64) {
        let length = self.moments[row + 1] - self.moments[row];
        (length, (column(row + 1) - column(row)) / length)
    }

    /// Rate at a row: the weighted harmonic mean of those beside it, zero at a turning point (Fritsch & Butland 1984,
    /// eq. 2), so that no row is overshot.
    fn slope(&self, column: &impl Fn(usize) -> f64, row: usize) -> f64 {
        if row == 0 || row + 1 == self.moments.len() {
            return 0.0;
        }
        let (before, after) = (self.secant(column, row - 1), self.secant(column, row));
        if before.1 * after.1 <= 0.0 {
            return 0.0;
        }
        let weights = [before.0 + 2.0 * after.0, 2.0 * before.0 + after.0];
        (weights[0] + weights[1]) / (weights[0] / before.1 + weights[1] / after.1)
    }
}

impl Cubic {
    /// Value and rate after a time.
    fn at(&self, elapsed: f64) -> (f64, f64) {
        let share = elapsed / self.length;
        let value = self.start + elapsed * (self.rate + share * (self.second + share * self.third));
        (value, self.rate_at(share))
    }

    fn rate_at(&self, share: f64) -> f64 {
        self.rate + share * (2.0 * self.second + 3.0 * share * self.third)
    }

    /// Greatest size of the rate: at an end or where it turns.
    fn greatest_rate(&self) -> f64 {
        let turning = -self.second / (3.0 * self.third);
        let turning = if (0.0..1.0).contains(&turning) {
            turning
        } else {
            0.0
        };
        [0.0, turning, 1.0]
            .map(|share| self.rate_at(share).abs())
            .into_iter()
            .fold(0.0, f64::max)
    }
}
