//! Walls near the pellets of a chunk.
//!
//! Pellets stored together lie together: a wall out of reach of a ball about all of them is looked at no more, and else
//! the pellets are halved, so that a pellet in the bulk never evaluates a distance.

use crate::model::Model;
use crate::state::{Row, vector};
use crate::wall::WallNow;
use crate::workspace::{ChunkList, NearWall};
use pelletflow_core::{Bounds, Vec3};
use std::ops::Range;

/// Pellets that are looked at one by one [-].
const FEW: usize = 4;

/// All walls, where they are now.
pub(super) struct Walls<'a> {
    model: &'a Model,
    now: &'a [WallNow],
    /// Reach of the lists beyond the pellets [m].
    skin: f64,
    /// Boxes about them, in the world.
    bounds: Vec<Bounds>,
}

impl<'a> Walls<'a> {
    pub(super) fn new(model: &'a Model, now: &'a [WallNow], skin: f64) -> Self {
        let walls = model.setup().walls.iter().zip(now);
        Self {
            model,
            now,
            skin,
            bounds: walls.map(|(wall, now)| wall.bounds(&now.pose)).collect(),
        }
    }

    /// Lists the walls near each pellet of a chunk, rising for each.
    pub(super) fn list(&self, positions: &[Row], range: &Range<usize>, list: &mut ChunkList) {
        let all: Vec<u32> = (0..self.now.len() as u32).collect();
        self.list_among(&all, &positions[range.clone()], 0, list);
    }

    /// Lists those of some walls that are near pellets, of which the first has the place `first` in its chunk.
    fn list_among(&self, walls: &[u32], positions: &[Row], first: usize, list: &mut ChunkList) {
        let is_one_by_one = positions.len() <= FEW || !self.model.setup().skips.distant_walls;
        if is_one_by_one {
            for (place, position) in positions.iter().enumerate() {
                for &wall in walls {
                    self.list_if_near(wall, position, (first + place) as u32, list);
                }
            }
            return;
        }
        let (center, radius) = ball_about(positions);
        let reach = radius + self.skin;
        let may_be_near = |&wall: &u32| self.may_be_near(wall as usize, center, reach);
        let near: Vec<u32> = walls.iter().copied().filter(may_be_near).collect();
        if !near.is_empty() {
            let (before, after) = positions.split_at(positions.len() / 2);
            self.list_among(&near, before, first, list);
            self.list_among(&near, after, first + before.len(), list);
        }
    }

    /// False only where no point in a ball about `center` touches the wall; in [m].
    fn may_be_near(&self, wall: usize, center: Vec3, reach: f64) -> bool {
        let nearest = center
            .sup(&self.bounds[wall].min)
            .inf(&self.bounds[wall].max);
        let point = self.now[wall].pose.inverse_point(center);
        let shape = &self.model.setup().walls[wall].shape;
        (nearest - center).norm() < reach && shape.may_be_near(point, reach)
    }

    fn list_if_near(&self, wall: u32, position: &Row, pellet: u32, list: &mut ChunkList) {
        let (index, setup) = (wall as usize, self.model.setup());
        let point = self.now[index].pose.inverse_point(vector(position));
        let reach = position[3] + self.skin;
        let shape = &setup.walls[index].shape;
        let is_near = shape.is_near(point, reach, &mut list.near_triangles);
        if is_near || !setup.skips.distant_walls {
            let places = self.model.touches_at(index);
            list.near_walls
                .extend(std::iter::repeat_n(NearWall { pellet, wall }, places));
            if self.model.touchable(index).is_mesh() {
                list.near_triangle_ends
                    .push(list.near_triangles.len() as u32);
            }
        }
    }
}

/// Center and radius of a ball that holds pellets [m].
fn ball_about(positions: &[Row]) -> (Vec3, f64) {
    let (mut low, mut high) = (vector(&positions[0]), vector(&positions[0]));
    let mut largest: f64 = 0.0;
    for position in positions {
        low = low.inf(&vector(position));
        high = high.sup(&vector(position));
        largest = largest.max(position[3]);
    }
    ((low + high) / 2.0, (high - low).norm() / 2.0 + largest)
}
