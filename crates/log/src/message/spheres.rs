//! `/pellets/spheres`: pellets at their true size, colored by speed, where there are not too many.

use super::{WORLD, color, timestamp, vector};
use crate::recording::DrawnPellet;
use foxglove::messages::scene_entity_deletion::Type;
use foxglove::messages::{
    Pose, Quaternion, SceneEntity, SceneEntityDeletion, SceneUpdate, SpherePrimitive,
};
use pelletflow_core::Vec3;
use prost::Message;

/// One entity holds all spheres: its number stays, so that each frame takes the place of the last.
const ENTITY: &str = "pellets";

/// All pellets at a time [s]; `full_speed` [m/s] has the last color of the scale.
pub(crate) fn message(time: f64, pellets: &[DrawnPellet], full_speed: f64) -> SceneUpdate {
    let spheres = pellets
        .iter()
        .map(|pellet| SpherePrimitive {
            pose: Some(Pose {
                position: Some(vector(pellet.position)),
                orientation: Some(Quaternion {
                    w: 1.0,
                    ..Quaternion::default()
                }),
            }),
            size: Some(vector(Vec3::repeat(2.0 * pellet.radius))),
            color: Some(color::on_scale(pellet.speed / full_speed)),
        })
        .collect();
    SceneUpdate {
        deletions: Vec::new(),
        entities: vec![SceneEntity {
            timestamp: Some(timestamp(time)),
            frame_id: WORLD.into(),
            id: ENTITY.into(),
            spheres,
            ..SceneEntity::default()
        }],
    }
}

/// Takes the spheres away at a time [s], when they have become too many.
pub(crate) fn removal(time: f64) -> SceneUpdate {
    SceneUpdate {
        deletions: vec![SceneEntityDeletion {
            timestamp: Some(timestamp(time)),
            r#type: Type::MatchingId as i32,
            id: ENTITY.into(),
        }],
        entities: Vec::new(),
    }
}

/// Whether the bytes of a message take the spheres away.
pub(crate) fn is_removal(message: &[u8]) -> bool {
    SceneUpdate::decode(message).is_ok_and(|update| update.entities.is_empty())
}
