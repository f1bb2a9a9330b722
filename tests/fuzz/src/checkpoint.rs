//! Checkpoints, read and gone on from.

use crate::file::folder;
use crate::plant::{SCENE, request, run_into};
use pelletflow_log::{Earlier, earlier};
use pelletflow_sim::RunPlan;
use std::fs;
use std::ops::ControlFlow;
use std::sync::LazyLock;
use xxhash_rust::xxh3::xxh3_128;

/// Bytes before the identity; the last four of them tell its length [B].
const HEAD: usize = 16;
/// Bytes of the checksum at the end [B].
const TAIL: usize = 16;
/// Time that a run goes on for after a checkpoint [s].
const GOES_ON: f64 = 1.0e-3;

/// Moment after which the run was interrupted [s]: late, so that the recording holds what every earlier checkpoint knows of.
const LATE: f64 = 2.0;

/// What a run left that was interrupted late.
static INTERRUPTED: LazyLock<Interrupted> = LazyLock::new(|| Interrupted::from(LATE));

struct Interrupted {
    recording: Vec<u8>,
    checkpoint: Vec<u8>,
}

impl Interrupted {
    /// What a run leaves that is interrupted from a moment on [s].
    fn from(moment: f64) -> Self {
        let folder = folder(&[]);
        let plan = RunPlan {
            // Longer than it takes until it is asked whether to go on.
            end_time: 1000.0,
            ..SCENE.plan.clone()
        };
        run_into(folder.path(), &plan, moment);
        let read = |name| fs::read(folder.path().join(name)).expect("the run was interrupted");
        Self {
            recording: read("run.mcap"),
            checkpoint: read("checkpoint.pf"),
        }
    }

    /// Where the identity of the checkpoint ends, and its contents begin [B].
    fn contents(&self) -> usize {
        let length = self.checkpoint[HEAD - 4..HEAD].try_into();
        let length = u32::from_le_bytes(length.expect("four bytes were taken"));
        HEAD + length as usize
    }
}

/// What an early checkpoint holds behind the identity of its run, and before its checksum.
pub(crate) fn early_contents() -> Vec<u8> {
    let early = Interrupted::from(0.0);
    let bytes = &early.checkpoint;
    let contents = bytes[early.contents()..bytes.len() - TAIL].to_vec();
    assert!(read(&contents), "it is of a moment after {LATE} s");
    contents
}

/// Takes bytes for a whole checkpoint, and for the contents of one whose run is known; goes on from either.
pub(crate) fn read(bytes: &[u8]) -> bool {
    assert!(!goes_on(bytes), "its checksum is right by chance alone");
    let mut forged = INTERRUPTED.checkpoint[..INTERRUPTED.contents()].to_vec();
    forged.extend_from_slice(bytes);
    forged.extend_from_slice(&xxh3_128(&forged).to_le_bytes());
    goes_on(&forged)
}

fn goes_on(checkpoint: &[u8]) -> bool {
    let files: [(&str, &[u8]); 2] = [
        ("run.mcap", &INTERRUPTED.recording),
        ("checkpoint.pf", checkpoint),
    ];
    let folder = folder(&files);
    let found = earlier(&request(folder.path(), &SCENE.plan));
    let Ok(Earlier::Unfinished(resumption)) = found else {
        return false;
    };
    let plan = RunPlan {
        end_time: resumption.time() + GOES_ON,
        ..SCENE.plan.clone()
    };
    let request = request(folder.path(), &plan);
    // It is asked after 20 ms; a state that would take longer has shown by then whether it does harm.
    let stop = &mut |_: &_| ControlFlow::Break(());
    resumption
        .run(SCENE.model.clone(), 1, &request, stop)
        .is_ok()
}
