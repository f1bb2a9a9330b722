//! `/equipment`: walls as translucent triangles with the lines of their sharp edges, each in its own frame.

use super::{color, in_place, point, timestamp, wall_frame};
use crate::surface::Mesh;
use foxglove::messages::scene_entity_deletion::Type;
use foxglove::messages::{
    KeyValuePair, LinePrimitive, SceneEntity, SceneEntityDeletion, SceneUpdate,
    TriangleListPrimitive, line_primitive,
};
use pelletflow_core::Vec3;
use pelletflow_sim::{Setup, Wall};

/// Width of an outline [px].
const OUTLINE_WIDTH: f64 = 1.0;

/// The walls of a setup, tessellated once.
pub(crate) struct Equipment {
    walls: Vec<SceneEntity>,
}

impl Equipment {
    pub(crate) fn of(setup: &Setup) -> Self {
        let walls = setup
            .walls
            .iter()
            .map(|wall| {
                let mesh = Mesh::of_wall(&wall.shape, &setup.domain.bounds);
                entity(wall, &setup.materials[wall.material].name, &mesh)
            })
            .collect();
        Self { walls }
    }

    /// The walls that are there at a time [s]; every other one is taken away.
    ///
    /// Each message is whole: a viewer that jumps in time reads only the last one.
    pub(crate) fn message(&self, time: f64, is_present: &[bool]) -> SceneUpdate {
        let (present, absent): (Vec<_>, Vec<_>) = self
            .walls
            .iter()
            .zip(is_present)
            .partition(|(_, is_present)| **is_present);
        SceneUpdate {
            deletions: absent
                .into_iter()
                .map(|(wall, _)| SceneEntityDeletion {
                    timestamp: Some(timestamp(time)),
                    r#type: Type::MatchingId as i32,
                    id: wall.id.clone(),
                })
                .collect(),
            entities: present
                .into_iter()
                .map(|(wall, _)| SceneEntity {
                    timestamp: Some(timestamp(time)),
                    ..wall.clone()
                })
                .collect(),
        }
    }
}

fn entity(wall: &Wall, material: &str, mesh: &Mesh) -> SceneEntity {
    let is_active = wall.motion.is_moving()
        || wall.surface_velocity != Vec3::zeros()
        || !wall.schedule.changes().is_empty();
    let color = if is_active {
        color::ACTIVE_WALL
    } else {
        color::FIXED_WALL
    };
    let (corners, indices) = mesh.indexed();
    SceneEntity {
        frame_id: wall_frame(&wall.name),
        id: wall.name.clone(),
        // The triangles stay in the wall's frame, and the frame moves.
        frame_locked: true,
        metadata: [("name", wall.name.as_str()), ("material", material)]
            .map(|(key, value)| KeyValuePair {
                key: key.into(),
                value: value.into(),
            })
            .into(),
        lines: vec![LinePrimitive {
            r#type: line_primitive::Type::LineList as i32,
            pose: Some(in_place()),
            thickness: OUTLINE_WIDTH,
            scale_invariant: true,
            points: mesh.edges.iter().flatten().copied().map(point).collect(),
            color: Some(color::OUTLINE),
            ..LinePrimitive::default()
        }],
        triangles: vec![TriangleListPrimitive {
            pose: Some(in_place()),
            points: corners.into_iter().map(point).collect(),
            color: Some(color),
            indices,
            ..TriangleListPrimitive::default()
        }],
        ..SceneEntity::default()
    }
}
