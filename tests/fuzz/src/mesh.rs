//! Files of CAD, in the wall of a scene.

use crate::file::folder;
use pelletflow_scene::Scene;

/// An STL file.
pub(crate) fn stl(bytes: &[u8]) -> bool {
    is_a_wall("wall.stl", bytes)
}

/// An OBJ file.
pub(crate) fn obj(bytes: &[u8]) -> bool {
    is_a_wall("wall.obj", bytes)
}

fn is_a_wall(name: &str, bytes: &[u8]) -> bool {
    let scene = include_str!("mesh.toml").replace("wall.stl", name);
    let folder = folder(&[("scene.toml", scene.as_bytes()), (name, bytes)]);
    Scene::read(&folder.path().join("scene.toml"), &[]).is_ok()
}
