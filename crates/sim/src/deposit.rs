//! Deposits: pellets put down one after another, each in a low place on those before, so that a bed starts nearly settled.

use crate::random::Draw;
use pelletflow_core::{Bounds, Shape, Vec3};

/// Places over the ground that are tried for a pellet [-].
const TRIES: u32 = 24;
/// Steps in which a pellet rolls down from the best of them [-].
const ROLLS: u32 = 24;
/// Share of the last step's length that a step keeps where it finds nothing lower [-].
const SHORTER: f64 = 0.7;
/// Clearance of two pellets, and of a pellet and the border of the region, over their radii [-].
const CLEARANCE: f64 = 1.0e-3;
/// Columns along a side beyond which they are made wider [-].
const MOST_COLUMNS: f64 = 2048.0;

/// A region that is being filled.
pub(crate) struct Deposit<'a> {
    region: &'a Shape,
    bounds: Bounds,
    axes: Axes,
    largest_radius: f64,
    column_width: f64,
    counts: [usize; 2],
    /// Pellets in columns side by side, those of each with rising center.
    columns: Vec<Vec<Grain>>,
}

/// Two axes over the ground, and the one that points most nearly against gravity.
#[derive(Debug, Clone, Copy)]
struct Axes {
    along: [usize; 2],
    up: usize,
    sign: f64,
}

/// A pellet that lies: its center over the ground, its height, its radius [m].
#[derive(Debug, Clone, Copy)]
struct Grain {
    at: [f64; 2],
    height: f64,
    radius: f64,
}

impl<'a> Deposit<'a> {
    /// An empty region, to be filled against gravity [m/s²] with pellets up to a radius [m].
    pub(crate) fn new(region: &'a Shape, gravity: Vec3, largest_radius: f64) -> Self {
        let axes = Axes::against(gravity);
        let bounds = region.bounds();
        let size = bounds.max - bounds.min;
        let widest = size[axes.along[0]].max(size[axes.along[1]]);
        let column_width = (2.0 * largest_radius).max(widest / MOST_COLUMNS);
        let counts = axes
            .along
            .map(|axis| (size[axis] / column_width).floor() as usize + 1);
        Self {
            region,
            bounds,
            axes,
            largest_radius,
            column_width,
            counts,
            columns: vec![Vec::new(); counts[0] * counts[1]],
        }
    }

    /// Puts a pellet of a radius [m] down and gives its center [m]; none where the region has no room for it.
    pub(crate) fn put(&mut self, radius: f64, draw: &mut Draw) -> Option<Vec3> {
        let mut lowest: Option<Grain> = None;
        for _ in 0..TRIES {
            let at = self.axes.along.map(|axis| {
                let (low, high) = (
                    self.bounds.min[axis] + radius,
                    self.bounds.max[axis] - radius,
                );
                low + draw.unit() * (high - low).max(0.0)
            });
            lowest = self.lower(lowest, at, radius);
        }
        let mut step = radius;
        for _ in 0..ROLLS {
            let Some(grain) = lowest else { break };
            let at = grain
                .at
                .map(|value| value + step * (2.0 * draw.unit() - 1.0));
            lowest = self.lower(lowest, at, radius);
            if lowest.is_some_and(|found| found.at == grain.at) {
                step *= SHORTER;
            }
        }
        let grain = lowest?;
        let column = self.column(grain.at);
        let column = &mut self.columns[column];
        let place = column.partition_point(|other| other.height < grain.height);
        column.insert(place, grain);
        Some(self.axes.center(&grain))
    }

    /// The lower of a pellet's place so far and where it comes to lie over another point of the ground.
    fn lower(&self, lowest: Option<Grain>, at: [f64; 2], radius: f64) -> Option<Grain> {
        let limit = lowest.map_or(f64::INFINITY, |grain| grain.height);
        self.rest_height(at, radius, limit)
            .map(|height| Grain { at, height, radius })
            .or(lowest)
    }

    /// Height at which a pellet comes to lie over a point of the ground, if that is below a limit [m].
    fn rest_height(&self, at: [f64; 2], radius: f64, limit: f64) -> Option<f64> {
        let wide = radius * (1.0 + CLEARANCE);
        let [bottom, top] = self.axes.ends(&self.bounds);
        let mut height = bottom + wide;
        for column in self.columns_about(at) {
            for other in self.columns[column].iter().rev() {
                if other.height + wide + self.largest_radius * (1.0 + CLEARANCE) <= height {
                    break;
                }
                let reach = wide + other.radius * (1.0 + CLEARANCE);
                let away = (at[0] - other.at[0]).powi(2) + (at[1] - other.at[1]).powi(2);
                if away < reach * reach {
                    height = height.max(other.height + (reach * reach - away).sqrt());
                }
            }
            if height >= limit {
                return None;
            }
        }
        // A distance is never greater than the way: no place inside is passed over.
        while height < limit && height + radius <= top {
            let grain = Grain { at, height, radius };
            let outside = self.region.distance(self.axes.center(&grain)) + wide;
            if outside <= 0.0 {
                return Some(height);
            }
            height += outside.max(CLEARANCE * radius);
        }
        None
    }

    fn column(&self, at: [f64; 2]) -> usize {
        let [x, y] = self.coordinates(at);
        y * self.counts[0] + x
    }

    fn coordinates(&self, at: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|side| {
            let low = self.bounds.min[self.axes.along[side]];
            let column = ((at[side] - low) / self.column_width) as usize;
            column.min(self.counts[side] - 1)
        })
    }

    /// Columns whose pellets may touch one over a point.
    fn columns_about(&self, at: [f64; 2]) -> impl Iterator<Item = usize> {
        let [x, y] = self.coordinates(at);
        let [width, depth] = self.counts;
        let beside = |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
        beside(y, depth).flat_map(move |y| beside(x, width).map(move |x| y * width + x))
    }
}

impl Axes {
    /// Axes whose third points most nearly against gravity, up along z where there is none.
    fn against(gravity: Vec3) -> Self {
        let up = if gravity.norm() > 0.0 {
            gravity.iamax()
        } else {
            2
        };
        Self {
            along: [(up + 1) % 3, (up + 2) % 3],
            up,
            sign: if gravity[up] > 0.0 { -1.0 } else { 1.0 },
        }
    }

    fn center(&self, grain: &Grain) -> Vec3 {
        let mut center = Vec3::zeros();
        center[self.along[0]] = grain.at[0];
        center[self.along[1]] = grain.at[1];
        center[self.up] = self.sign * grain.height;
        center
    }

    /// Lowest and highest height in a box [m].
    fn ends(&self, bounds: &Bounds) -> [f64; 2] {
        if self.sign > 0.0 {
            [bounds.min[self.up], bounds.max[self.up]]
        } else {
            [-bounds.max[self.up], -bounds.min[self.up]]
        }
    }
}
