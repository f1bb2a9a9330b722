//! A quantity over time in bounded memory, with its peaks.

/// Buckets at most [-]; each holds its least and its greatest value.
const MOST_BUCKETS: usize = 320;

/// A quantity over time; where there are many values, the extremes of equal shares of them.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Curve {
    /// Least and greatest point of each bucket, each a time [s] and a value in the unit of the curve [-].
    buckets: Vec<[[f64; 2]; 2]>,
    /// Values in a full bucket [-].
    share: usize,
    /// Values in the last one [-].
    in_last: usize,
}

impl Curve {
    /// Takes a value at a time [s]; one that is not finite has no place in a chart.
    pub(super) fn push(&mut self, time: f64, value: f64) {
        if !value.is_finite() {
            return;
        }
        let point = [time, value];
        match self.buckets.last_mut() {
            Some(bucket) if self.in_last < self.share => {
                *bucket = joined(*bucket, [point, point]);
                self.in_last += 1;
            }
            _ => {
                if self.buckets.len() == MOST_BUCKETS {
                    self.halve();
                }
                self.buckets.push([point, point]);
                self.share = self.share.max(1);
                self.in_last = 1;
            }
        }
    }

    /// The points in order of time.
    pub(super) fn points(&self) -> Vec<[f64; 2]> {
        let mut points = Vec::with_capacity(2 * self.buckets.len());
        for &[low, high] in &self.buckets {
            let (first, second) = if low[0] <= high[0] {
                (low, high)
            } else {
                (high, low)
            };
            points.push(first);
            if second != first {
                points.push(second);
            }
        }
        points
    }

    fn halve(&mut self) {
        self.buckets = self
            .buckets
            .chunks(2)
            .map(|pair| {
                pair[1..]
                    .iter()
                    .fold(pair[0], |one, &other| joined(one, other))
            })
            .collect();
        self.share *= 2;
    }
}

fn joined(one: [[f64; 2]; 2], other: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let low = if other[0][1] < one[0][1] {
        other[0]
    } else {
        one[0]
    };
    let high = if other[1][1] > one[1][1] {
        other[1]
    } else {
        one[1]
    };
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_curve_is_kept_point_by_point() {
        let mut curve = Curve::default();
        for index in 0..100 {
            curve.push(f64::from(index), f64::from(index * index));
        }
        assert_eq!(curve.points().len(), 100);
        assert_eq!(curve.points()[7], [7.0, 49.0]);
    }

    #[test]
    fn a_long_curve_keeps_its_peaks_in_order_of_time() {
        let mut curve = Curve::default();
        for index in 0..100_000 {
            let value = if index == 77_777 {
                1.0e3
            } else {
                (f64::from(index) * 0.01).sin()
            };
            curve.push(f64::from(index), value);
        }
        let points = curve.points();
        assert!(points.len() <= 2 * MOST_BUCKETS);
        assert!(points.contains(&[77_777.0, 1.0e3]));
        assert!(points.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    }

    #[test]
    fn what_is_not_finite_is_left_out() {
        let mut curve = Curve::default();
        curve.push(0.0, f64::NAN);
        curve.push(1.0, f64::INFINITY);
        assert!(curve.points().is_empty());
    }
}
