//! No bytes in place of a checkpoint make a program panic, and none that are damaged are taken for whole.

mod common;

use common::{SCENE_TEXT, plan, setup, simulation};
use pelletflow_log::{Earlier, FolderError, RunError, RunRequest, earlier, run};
use pelletflow_sim::{HitRequest, Model, RunPlan};
use proptest::prelude::*;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use xxhash_rust::xxh3::xxh3_128;

/// Bytes of the checksum at the end [B].
const TAIL: usize = 16;

fn request<'a>(directory: &'a Path, plan: &'a RunPlan) -> RunRequest<'a> {
    RunRequest {
        directory,
        scene_name: "hopper",
        scene_title: "A small hopper",
        scene_text: SCENE_TEXT,
        scene_hash: "0123",
        scene_files: &[],
        plan,
        spheres_up_to: 1000,
        contacts: false,
        live: None,
    }
}

/// What a folder with these bytes for a checkpoint comes to.
fn found(directory: &Path, bytes: &[u8]) -> Result<Earlier, RunError> {
    fs::write(directory.join("checkpoint.pf"), bytes).expect("it can be written");
    earlier(&request(directory, &plan(0.2)))
}

fn is_damage(found: &Result<Earlier, RunError>) -> bool {
    let Err(RunError::Folder(error)) = found else {
        return false;
    };
    matches!(**error, FolderError::Damaged { .. })
}

/// Goes on from a checkpoint beside its recording, in a folder of their own, for a few steps; whether that was possible.
fn goes_on(checkpoint: &[u8], recording: &[u8], model: &Model) -> bool {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    fs::write(directory.path().join("run.mcap"), recording).expect("it can be written");
    let Ok(Earlier::Unfinished(resumption)) = found(directory.path(), checkpoint) else {
        return false;
    };
    let plan = plan(resumption.time() + 1.0e-4);
    let request = request(directory.path(), &plan);
    let stop = &mut |_: &_| ControlFlow::Break(());
    resumption.run(model.clone(), 1, &request, stop).is_ok()
}

#[test]
fn damaged_bytes_are_refused_and_forged_ones_do_no_harm() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let mut setup = setup(12);
    setup.hits = Some(HitRequest { threshold: 1.0 });
    let mut simulation = simulation(setup);
    let model = simulation.model().clone();
    run(
        &mut simulation,
        // Longer than the 20 ms after which the observer is asked.
        &request(directory.path(), &plan(60.0)),
        &mut |_| ControlFlow::Break(()),
    )
    .expect("it is sound");
    let whole = fs::read(directory.path().join("checkpoint.pf")).expect("there is one");
    let recording = fs::read(directory.path().join("run.mcap")).expect("there is one");
    assert!(goes_on(&whole, &recording, &model));
    let found = |bytes: &[u8]| found(directory.path(), bytes);
    let body = whole.len() - TAIL;

    proptest!(|(
        place in any::<prop::sample::Index>(),
        mask in 1_u8..,
        cut in any::<prop::sample::Index>(),
        noise in prop::collection::vec(any::<u8>(), 0..200),
    )| {
        prop_assert!(matches!(found(&whole), Ok(Earlier::Unfinished(_))));

        let mut flipped = whole.clone();
        flipped[place.index(whole.len())] ^= mask;
        prop_assert!(is_damage(&found(&flipped)));
        prop_assert!(is_damage(&found(&whole[..cut.index(whole.len())])));
        prop_assert!(is_damage(&found(&noise)));

        // With a checksum that is right again it may pass; what is read, and gone on from, must still keep to its bounds.
        let mut forged = whole.clone();
        let start = place.index(body - noise.len());
        forged[start..start + noise.len()].copy_from_slice(&noise);
        for mut forged in [flipped, forged] {
            let sum = xxh3_128(&forged[..body]);
            forged[body..].copy_from_slice(&sum.to_le_bytes());
            goes_on(&forged, &recording, &model);
        }
    });
}
