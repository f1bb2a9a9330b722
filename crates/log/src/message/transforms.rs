//! `/tf`: where each wall's frame is in the world.

use super::{WORLD, timestamp, vector, wall_frame};
use foxglove::messages::{FrameTransform, FrameTransforms, Quaternion};
use pelletflow_core::Pose;

/// The frames of all walls, by name, at a time [s].
///
/// Each message holds every wall: a viewer that jumps in time reads only the last one.
pub(crate) fn message<'a>(
    time: f64,
    walls: impl Iterator<Item = (&'a str, Pose)>,
) -> FrameTransforms {
    FrameTransforms {
        transforms: walls
            .map(|(name, world_from_body)| FrameTransform {
                timestamp: Some(timestamp(time)),
                parent_frame_id: WORLD.into(),
                child_frame_id: wall_frame(name),
                translation: Some(vector(world_from_body.translation)),
                rotation: Some(Quaternion {
                    x: world_from_body.rotation.i,
                    y: world_from_body.rotation.j,
                    z: world_from_body.rotation.k,
                    w: world_from_body.rotation.w,
                }),
            })
            .collect(),
    }
}
