//! Walls as they were recorded: their triangles once, and where each is over time.

use crate::message::{color, wall_frame};
use foxglove::messages::{Color, FrameTransforms, Point3, SceneEntity, SceneUpdate};
use std::collections::BTreeMap;

/// The surface of a wall, in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WallSurface {
    pub(crate) name: String,
    pub(crate) material: String,
    /// Whether it moves, runs or opens.
    pub(crate) is_active: bool,
    /// Corners [m].
    pub(crate) corners: Vec<[f32; 3]>,
    /// Corners of each triangle, by index.
    pub(crate) triangles: Vec<u32>,
    /// Ends of each piece of a sharp edge [m].
    pub(crate) edges: Vec<[f32; 3]>,
}

/// Where a wall is at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WallPlace {
    /// Translation [m], and rotation as a quaternion x, y, z, w [-].
    pub(crate) pose: [f32; 7],
    pub(crate) is_present: bool,
}

impl WallPlace {
    /// Of a wall that has not been placed.
    pub(crate) const UNKNOWN: Self = Self {
        pose: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        is_present: false,
    };
}

/// All walls seen so far, and where each is now.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Walls {
    surfaces: Vec<WallSurface>,
    places: Vec<WallPlace>,
    /// Walls by the name of their frame.
    by_frame: BTreeMap<String, usize>,
    /// Poses told before their wall was, by the name of their frame.
    poses: BTreeMap<String, [f32; 7]>,
}

impl Walls {
    /// Takes a message of `/equipment`; the walls that it tells of.
    pub(crate) fn take_update(&mut self, update: SceneUpdate) -> Vec<usize> {
        let mut told = Vec::with_capacity(update.entities.len());
        for deletion in &update.deletions {
            if let Some(&index) = self.by_frame.get(&wall_frame(&deletion.id)) {
                self.places[index].is_present = false;
                told.push(index);
            }
        }
        for entity in update.entities {
            let frame = wall_frame(&entity.id);
            let pose = self.poses.get(&frame).copied();
            let index = *self.by_frame.entry(frame).or_insert_with(|| {
                self.surfaces.push(surface(entity));
                self.places.push(WallPlace::UNKNOWN);
                self.surfaces.len() - 1
            });
            let place = &mut self.places[index];
            place.is_present = true;
            place.pose = pose.unwrap_or(place.pose);
            told.push(index);
        }
        told
    }

    /// Takes a message of `/tf`; the walls that it tells of.
    pub(crate) fn take_transforms(&mut self, transforms: FrameTransforms) -> Vec<usize> {
        let mut told = Vec::with_capacity(transforms.transforms.len());
        for transform in transforms.transforms {
            let by = transform.translation.unwrap_or_default();
            let turn = transform.rotation.unwrap_or_default();
            let pose = [by.x, by.y, by.z, turn.x, turn.y, turn.z, turn.w].map(|value| value as f32);
            let frame = transform.child_frame_id;
            if let Some(&index) = self.by_frame.get(&frame) {
                self.places[index].pose = pose;
                told.push(index);
            }
            self.poses.insert(frame, pose);
        }
        told
    }

    /// Where each wall is now, in the order of the surfaces.
    pub(crate) fn places(&self) -> Vec<WallPlace> {
        self.places.clone()
    }

    /// Where one wall is now, by its place among the surfaces.
    pub(crate) fn place(&self, index: usize) -> WallPlace {
        self.places[index]
    }

    pub(crate) fn surfaces(&self) -> &[WallSurface] {
        &self.surfaces
    }
}

fn surface(entity: SceneEntity) -> WallSurface {
    let material = entity.metadata.iter().find(|pair| pair.key == "material");
    let material = material.map(|pair| pair.value.clone()).unwrap_or_default();
    let mut corners = Vec::new();
    let mut triangles = Vec::new();
    let mut color = None;
    for list in &entity.triangles {
        let first = corners.len() as u32;
        corners.extend(list.points.iter().map(place));
        let (whole, _) = list.indices.as_chunks::<3>();
        // A triangle without a corner would draw nonsense; the others stay what they are.
        let is_drawn = |triangle: &&[u32; 3]| {
            let is_there = |&index: &u32| (index as usize) < list.points.len();
            triangle.iter().all(is_there)
        };
        let drawn = whole.iter().filter(is_drawn);
        triangles.extend(drawn.flatten().map(|index| first + index));
        color = color.or(list.color);
    }
    let lines = entity.lines.iter().flat_map(|line| &line.points);
    WallSurface {
        name: entity.id,
        material,
        is_active: color.is_some_and(|color| is_close(color, color::ACTIVE_WALL)),
        corners,
        triangles,
        edges: lines.map(place).collect(),
    }
}

fn place(point: &Point3) -> [f32; 3] {
    [point.x as f32, point.y as f32, point.z as f32]
}

fn is_close(one: Color, other: Color) -> bool {
    // Eight bits of a channel.
    (one.r - other.r).abs() < 1.0 / 256.0 && (one.b - other.b).abs() < 1.0 / 256.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use foxglove::messages::TriangleListPrimitive;

    #[test]
    fn a_triangle_without_a_corner_is_left_out_and_the_others_stay_what_they_are() {
        let list = |indices: Vec<u32>| TriangleListPrimitive {
            points: vec![Point3::default(); 3],
            indices,
            ..TriangleListPrimitive::default()
        };
        let entity = SceneEntity {
            triangles: vec![
                list(vec![0, 1, 7, 2, 1, 0, 0, 1]),
                list(vec![u32::MAX, 1, 2, 0, 2, 1]),
            ],
            ..SceneEntity::default()
        };
        assert_eq!(surface(entity).triangles, [2, 1, 0, 3, 5, 4]);
    }
}
