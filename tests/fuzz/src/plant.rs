//! A small run, for recordings and checkpoints that are whole.

use pelletflow_log::{RunRequest, run};
use pelletflow_scene::Scene;
use pelletflow_sim::{RunPlan, Simulation};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::LazyLock;

/// The scene.
pub(crate) static SCENE: LazyLock<Scene> = LazyLock::new(|| {
    let text = include_str!("../corpus/scene/good-plant.toml");
    Scene::parse(text, "plant", &[]).unwrap_or_else(|error| panic!("{error}"))
});

/// What to run: the scene by a plan, into a folder.
pub(crate) fn request<'a>(directory: &'a Path, plan: &'a RunPlan) -> RunRequest<'a> {
    RunRequest {
        directory,
        scene_name: &SCENE.name,
        scene_title: &SCENE.title,
        scene_text: &SCENE.text,
        scene_hash: &SCENE.hash,
        scene_files: &[],
        plan,
        spheres_up_to: SCENE.output.spheres_up_to,
        contacts: SCENE.output.contacts,
        live: None,
    }
}

/// Runs the scene into a folder, to its end or to a checkpoint at the first look from a moment on [s]; there is a look after
/// every 20 ms or so of computing.
pub(crate) fn run_into(directory: &Path, plan: &RunPlan, moment: f64) {
    let simulation = Simulation::new(SCENE.model.clone(), 1);
    let mut simulation = simulation.expect("the pellets of the scene find their places");
    run(
        &mut simulation,
        &request(directory, plan),
        &mut |progress| {
            if progress.time >= moment {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        },
    )
    .expect("the scene is sound, and its folder can be written to");
}
