//! `/hits/worst`: the hardest hits so far, as marks in the scene.

use super::{WORLD, color, timestamp, vector};
use foxglove::messages::scene_entity_deletion::Type;
use foxglove::messages::{
    Color, Pose, Quaternion, SceneEntity, SceneEntityDeletion, SceneUpdate, SpherePrimitive,
    TextPrimitive,
};
use pelletflow_core::Vec3;
use pelletflow_sim::Hit;

/// Size of a mark and of its text, over the pellet's diameter [-].
const MARK_SIZE: f64 = 1.5;

/// The hardest hits up to a time [s], the hardest first.
///
/// Each message is whole: a viewer that jumps in time reads only the last one.
pub(crate) fn message(time: f64, worst: &[Hit]) -> SceneUpdate {
    SceneUpdate {
        deletions: vec![SceneEntityDeletion {
            timestamp: Some(timestamp(time)),
            r#type: Type::All as i32,
            id: String::new(),
        }],
        entities: worst
            .iter()
            .zip(1..)
            .map(|(hit, rank)| mark(time, hit, rank))
            .collect(),
    }
}

fn mark(time: f64, hit: &Hit, rank: usize) -> SceneEntity {
    let pose = Pose {
        position: Some(vector(hit.place)),
        orientation: Some(Quaternion {
            w: 1.0,
            ..Quaternion::default()
        }),
    };
    let size = MARK_SIZE * hit.diameter;
    SceneEntity {
        timestamp: Some(timestamp(time)),
        frame_id: WORLD.into(),
        id: format!("hit {rank}"),
        spheres: vec![SpherePrimitive {
            pose: Some(pose),
            size: Some(vector(Vec3::repeat(size))),
            color: Some(Color {
                a: 0.5,
                ..color::on_scale(1.0)
            }),
        }],
        texts: vec![TextPrimitive {
            pose: Some(pose),
            billboard: true,
            font_size: size,
            scale_invariant: false,
            color: Some(color::OUTLINE),
            text: format!("{rank}: {:.4} N", hit.peak_force),
        }],
        ..SceneEntity::default()
    }
}
