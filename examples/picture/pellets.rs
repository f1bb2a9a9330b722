//! Pellets in a grid of cells, so that a ray meets few of them.

use crate::camera::Ray;
use pelletflow::core::Vec3;
use pelletflow::log::PelletRecord;

/// A ball with its speed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ball {
    pub(crate) center: Vec3,
    pub(crate) radius: f64,
    /// Speed [m/s].
    pub(crate) speed: f64,
}

pub(crate) fn center(pellet: &PelletRecord) -> Vec3 {
    Vec3::from(pellet.position.map(f64::from))
}

/// Balls listed by the cells that they reach into.
pub(crate) struct Pellets {
    balls: Vec<Ball>,
    low: Vec3,
    cell: f64,
    counts: [usize; 3],
    /// Where the list of each cell begins; one more for the end of the last.
    begins: Vec<u32>,
    members: Vec<u32>,
}

impl Pellets {
    pub(crate) fn new(balls: Vec<Ball>) -> Self {
        let radius = balls.iter().map(|ball| ball.radius).fold(1.0e-6, f64::max);
        let cell = 2.0 * radius;
        let margin = Vec3::repeat(radius * 1.01);
        let (mut low, mut high) = (Vec3::zeros(), Vec3::zeros());
        for (index, ball) in balls.iter().enumerate() {
            let (least, most) = (ball.center - margin, ball.center + margin);
            low = if index == 0 { least } else { low.inf(&least) };
            high = if index == 0 { most } else { high.sup(&most) };
        }
        let counts = [0, 1, 2].map(|axis| ((high[axis] - low[axis]) / cell) as usize + 1);
        let mut lists = vec![Vec::new(); counts.iter().product()];
        for (index, ball) in balls.iter().enumerate() {
            let span = |axis: usize| {
                let place = |at: f64| ((at - low[axis]) / cell).max(0.0) as usize;
                let first = place(ball.center[axis] - ball.radius);
                first..=place(ball.center[axis] + ball.radius).min(counts[axis] - 1)
            };
            for z in span(2) {
                for y in span(1) {
                    for x in span(0) {
                        lists[(z * counts[1] + y) * counts[0] + x].push(index as u32);
                    }
                }
            }
        }
        let mut begins = vec![0];
        let mut members = Vec::new();
        for list in lists {
            members.extend(list);
            begins.push(members.len() as u32);
        }
        Self {
            balls,
            low,
            cell,
            counts,
            begins,
            members,
        }
    }

    /// The first ball on a ray within a distance [m], and how far it is [m].
    pub(crate) fn first_hit(&self, ray: &Ray, reach: f64) -> Option<(f64, &Ball)> {
        let high = self.low + self.cell * Vec3::from(self.counts.map(|count| count as f64));
        let (mut enter, mut leave) = (0.0_f64, reach);
        for axis in 0..3 {
            let inverse = 1.0 / ray.direction[axis];
            let a = (self.low[axis] - ray.origin[axis]) * inverse;
            let b = (high[axis] - ray.origin[axis]) * inverse;
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        if self.balls.is_empty() || enter >= leave {
            return None;
        }
        let start = ray.at(enter);
        let mut cell = [0, 1, 2].map(|axis| {
            let place = (start[axis] - self.low[axis]) / self.cell;
            (place.max(0.0) as usize).min(self.counts[axis] - 1)
        });
        let mut next = [0, 1, 2].map(|axis| {
            let ahead = if ray.direction[axis] > 0.0 { 1.0 } else { 0.0 };
            let side = self.low[axis] + self.cell * (cell[axis] as f64 + ahead);
            let distance = (side - ray.origin[axis]) / ray.direction[axis];
            if distance.is_nan() {
                f64::INFINITY
            } else {
                distance
            }
        });
        let mut best: Option<(f64, &Ball)> = None;
        loop {
            let place = (cell[2] * self.counts[1] + cell[1]) * self.counts[0] + cell[0];
            let members = self.begins[place] as usize..self.begins[place + 1] as usize;
            for &member in &self.members[members] {
                let ball = &self.balls[member as usize];
                let limit = best.map_or(leave, |(distance, _)| distance);
                if let Some(distance) = meets(ray, ball)
                    && distance < limit
                {
                    best = Some((distance, ball));
                }
            }
            let axis = (0..3).fold(
                0,
                |near, axis| if next[axis] < next[near] { axis } else { near },
            );
            let limit = best.map_or(leave, |(distance, _)| distance);
            if next[axis] >= limit {
                return best;
            }
            if ray.direction[axis] > 0.0 {
                cell[axis] += 1;
            } else {
                cell[axis] = cell[axis].wrapping_sub(1);
            }
            if cell[axis] >= self.counts[axis] {
                return best;
            }
            next[axis] += self.cell / ray.direction[axis].abs();
        }
    }
}

fn meets(ray: &Ray, ball: &Ball) -> Option<f64> {
    let to_center = ball.center - ray.origin;
    let along = to_center.dot(&ray.direction);
    let squared = ball.radius * ball.radius - (to_center - along * ray.direction).norm_squared();
    if squared <= 0.0 {
        return None;
    }
    let distance = along - squared.sqrt();
    (distance > 0.0).then_some(distance)
}
