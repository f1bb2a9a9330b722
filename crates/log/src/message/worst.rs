//! `/hits/worst`: the hardest hits as marks in the scene, each at its moment.

use super::{WORLD, color, timestamp, vector};
use foxglove::messages::{
    Color, Duration, Pose, Quaternion, SceneEntity, SceneUpdate, SpherePrimitive, TextPrimitive,
};
use pelletflow_core::Vec3;
use pelletflow_sim::Hit;

/// How long a mark stays [s].
const SHOWN_FOR: i32 = 1;
/// Size of a mark and of its text, over the pellet's diameter [-].
const MARK_SIZE: f64 = 1.5;

/// One hit, by its place among the hardest from 1 on, with its words.
pub(crate) fn message(hit: &Hit, rank: usize, text: &str) -> SceneUpdate {
    let pose = Pose {
        position: Some(vector(hit.place)),
        orientation: Some(Quaternion {
            w: 1.0,
            ..Quaternion::default()
        }),
    };
    let size = MARK_SIZE * hit.diameter;
    SceneUpdate {
        deletions: Vec::new(),
        entities: vec![SceneEntity {
            timestamp: Some(timestamp(hit.peak_time)),
            frame_id: WORLD.into(),
            id: format!("hit {rank}"),
            lifetime: Some(Duration::new(SHOWN_FOR, 0)),
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
                text: text.into(),
            }],
            ..SceneEntity::default()
        }],
    }
}
