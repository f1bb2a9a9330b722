//! A run that was interrupted and taken up again leaves what an unbroken one leaves.

mod common;

use common::{SCENE_TEXT, plan, setup};
use pelletflow_core::Vec3;
use pelletflow_log::{
    Earlier, Ended, FolderError, Progress, RunError, RunRequest, Summary, WORST_HITS, WorstHits,
    discard, earlier, read_hits, run,
};
use pelletflow_sim::{
    HitRequest, KeptFrames, MeterKind, Model, PlaneFlow, Residence, RunPlan, Setup, Simulation,
    WallImpacts,
};
use serde_json::Value;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;

/// End of a run that is looked at several times, however fast the machine is [s].
const END: f64 = 2.0;

/// The hopper with hits followed and more meters.
fn busy() -> Setup {
    let mut setup = setup(60);
    setup.hits = Some(HitRequest { threshold: 1.0 });
    let kinds = [
        MeterKind::PlaneFlow(PlaneFlow {
            point: -0.1 * Vec3::z(),
            normal: Vec3::z_axis(),
            radius: f64::INFINITY,
        }),
        MeterKind::WallImpacts(WallImpacts {
            wall: 0,
            cell: 0.05,
            least_speed: 0.1,
        }),
        MeterKind::Residence(Residence),
    ];
    for kind in kinds {
        setup.meters.push(pelletflow_sim::Meter {
            name: kind.name().into(),
            kind,
        });
    }
    setup
}

fn request<'a>(directory: &'a Path, plan: &'a RunPlan, scene_text: &'a str) -> RunRequest<'a> {
    RunRequest {
        directory,
        scene_name: "hopper",
        scene_title: "A small hopper",
        scene_text,
        scene_hash: scene_text,
        scene_files: &[],
        plan,
        // Fewer than there are at first: spheres come in the middle of the run.
        spheres_up_to: 50,
        contacts: true,
        live: None,
    }
}

fn model() -> Model {
    Model::new(busy()).expect("the hopper is a right setup")
}

fn run_anew(
    request: &RunRequest,
    threads: usize,
    observer: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Summary, RunError> {
    let mut simulation = Simulation::new(model(), threads).expect("the pellets fit");
    run(&mut simulation, request, observer)
}

fn go_on(_: &Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn break_off(_: &Progress) -> ControlFlow<()> {
    ControlFlow::Break(())
}

/// Takes a run up until it is over, interrupting it at every look.
fn resume_until_over(request: &RunRequest, threads: &[usize]) {
    for threads in threads.iter().cycle() {
        let Earlier::Unfinished(resumption) = earlier(request).expect("it can go on") else {
            panic!("there is a checkpoint");
        };
        let summary = resumption
            .run(model(), *threads, request, &mut break_off)
            .expect("the hopper is sound");
        if summary.ended != Ended::Interrupted {
            return;
        }
    }
}

/// Topic, time, sequence and bytes of every message, in the order of the file.
fn messages(directory: &Path) -> Vec<(String, u64, u32, Vec<u8>)> {
    let bytes = fs::read(directory.join("run.mcap")).expect("there is a recording");
    mcap::MessageStream::new(&bytes)
        .expect("it is a recording")
        .map(|message| {
            let message = message.expect("it is whole");
            let topic = message.channel.topic.clone();
            let data = message.data.into_owned();
            (topic, message.log_time, message.sequence, data)
        })
        .collect()
}

/// A summary without what the clock on the wall and the threads tell.
fn timeless(directory: &Path) -> Value {
    let text = fs::read_to_string(directory.join("summary.json")).expect("there is a summary");
    let mut summary: Value = serde_json::from_str(&text).expect("it is JSON");
    let table = summary.as_object_mut().expect("it is a table");
    table.remove("performance");
    table.remove("threads");
    table["time"]
        .as_object_mut()
        .expect("it is a table")
        .remove("wall_s");
    summary
}

fn files(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).expect("it can be read");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("it can be read").file_name())
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Every file of a directory with its bytes, but for the lock.
fn contents(directory: &Path) -> Vec<(String, Vec<u8>)> {
    files(directory)
        .into_iter()
        .filter(|name| name != "run.lock")
        .map(|name| (name.clone(), directory.join(name)))
        .filter(|(_, path)| path.is_file())
        .map(|(name, path)| (name, fs::read(path).expect("it can be read")))
        .collect()
}

#[test]
fn an_interrupted_run_leaves_the_messages_and_the_summary_of_an_unbroken_one() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let (whole, broken) = (
        directory.path().join("whole"),
        directory.path().join("broken"),
    );
    let plan = plan(END);
    run_anew(&request(&whole, &plan, SCENE_TEXT), 1, &mut go_on).expect("it runs to its end");

    let often = RunPlan {
        checkpoint_interval: 0.01,
        ..plan
    };
    let broken_off = request(&broken, &often, SCENE_TEXT);
    let first = run_anew(&broken_off, 2, &mut break_off).expect("it is sound");
    assert_eq!(first.ended, Ended::Interrupted);
    assert!(files(&broken).contains(&"checkpoint.pf".to_owned()));
    // A look is taken each 20 ms of the clock: how often that is depends on the machine.
    resume_until_over(&broken_off, &[1, 4, 2]);

    assert_eq!(timeless(&broken), timeless(&whole));
    let (found, expected) = (messages(&broken), messages(&whole));
    assert_eq!(found.len(), expected.len());
    for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert!(
            found == expected,
            "message {index}: {} at {} in place of {} at {}",
            found.0,
            found.1,
            expected.0,
            expected.1
        );
    }
    assert!(expected.iter().any(|message| message.0 == "/hits"));
    assert!(
        expected
            .iter()
            .any(|message| message.0 == "/pellets/spheres")
    );
    // A run that is over needs no checkpoint.
    assert_eq!(files(&broken), files(&whole));
}

#[test]
fn frames_are_kept_as_asked_for_whether_or_not_the_run_was_interrupted() {
    const LAST: f64 = 0.053;
    const REACH: f64 = 0.011;
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let [all, thinned, broken] =
        ["all", "thinned", "broken"].map(|name| directory.path().join(name));
    let plan = plan(END);
    run_anew(&request(&all, &plan, SCENE_TEXT), 1, &mut go_on).expect("it runs to its end");
    let selective = RunPlan {
        kept_frames: KeptFrames {
            of_last: Some(LAST),
            around_worst_hits: Some(REACH),
        },
        ..plan
    };
    run_anew(&request(&thinned, &selective, SCENE_TEXT), 1, &mut go_on)
        .expect("it runs to its end");
    let broken_off = request(&broken, &selective, SCENE_TEXT);
    run_anew(&broken_off, 1, &mut break_off).expect("it is sound");
    resume_until_over(&broken_off, &[2]);

    let whole = messages(&all);
    let times = |topic: &str| -> Vec<u64> {
        let of_topic = whole.iter().filter(|message| message.0 == topic);
        of_topic.map(|message| message.1).collect()
    };
    let frames = times("/pellets");
    let nanoseconds = |seconds: f64| (seconds * 1.0e9) as u64;
    let mut worst = WorstHits::new(WORST_HITS);
    for hit in &read_hits(all.join("run.mcap"))
        .expect("hits are recorded")
        .hits
    {
        worst.enter(hit);
    }
    let worst = worst.as_slice().iter();
    let worst: Vec<u64> = worst.map(|hit| nanoseconds(hit.peak_time)).collect();
    let is_kept = |time: u64| {
        let end = *frames.last().expect("there are frames");
        let is_near = |&moment: &u64| moment.abs_diff(time) <= nanoseconds(REACH);
        time == frames[0] || end - time <= nanoseconds(LAST) || worst.iter().any(is_near)
    };
    let expected: Vec<_> = whole
        .iter()
        .filter(|message| match message.0.as_str() {
            "/pellets" | "/pellets/spheres" | "/contacts" | "/tf" => is_kept(message.1),
            _ => true,
        })
        .map(|(topic, time, _, bytes)| (topic, time, bytes))
        .collect();
    // The hardest hits are those of the fall, well before the end.
    assert!(expected.len() < whole.len() - 20, "{}", expected.len());
    assert!(worst.len() == 20 && frames.iter().any(|&time| time > 0 && is_kept(time)));
    for path in [&thinned, &broken] {
        let found = messages(path);
        let found: Vec<_> = found
            .iter()
            .map(|(topic, time, _, bytes)| (topic, time, bytes))
            .collect();
        assert!(found == expected, "{}", path.display());
        assert_eq!(files(path), files(&all));
    }
}

#[test]
fn threads_recording_rate_and_checkpoints_change_no_row_of_the_hits() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let base = plan(END);
    let rare = RunPlan {
        frame_interval: 0.05,
        meter_interval: 0.1,
        ..base.clone()
    };
    let often = RunPlan {
        frame_interval: 0.003,
        checkpoint_interval: 0.005,
        ..base.clone()
    };
    let hits = |name: &str, plan: &RunPlan, threads: usize| {
        let path = directory.path().join(name);
        let request = request(&path, plan, SCENE_TEXT);
        run_anew(&request, threads, &mut go_on).expect("it runs to its end");
        read_hits(path.join("run.mcap")).expect("hits are recorded")
    };
    let expected = hits("base", &base, 1);
    assert!(expected.hits.len() > 50, "{}", expected.hits.len());
    for (name, plan, threads) in [("rare", &rare, 2), ("often", &often, 4)] {
        let found = hits(name, plan, threads);
        assert_eq!(found.hits, expected.hits, "{name}");
        assert_eq!(found.classes, expected.classes, "{name}");
    }
}

#[test]
fn a_damaged_checkpoint_gives_way_to_the_one_before() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let plan = RunPlan {
        checkpoint_interval: 0.002,
        ..plan(END)
    };
    let whole = directory.path().join("whole");
    run_anew(&request(&whole, &plan, SCENE_TEXT), 1, &mut go_on).expect("it runs to its end");
    let broken = directory.path().join("broken");
    let request = request(&broken, &plan, SCENE_TEXT);
    // Interrupted at its first look and again at its second, so that there are two, however fast the machine is.
    run_anew(&request, 1, &mut break_off).expect("it is sound");
    let Earlier::Unfinished(resumption) = earlier(&request).expect("it can go on") else {
        panic!("there is a checkpoint");
    };
    let interrupted = resumption.run(model(), 1, &request, &mut break_off);
    assert_eq!(interrupted.expect("it is sound").ended, Ended::Interrupted);

    let newest = broken.join("checkpoint.pf");
    let bytes = fs::read(&newest).expect("there is a checkpoint");
    fs::write(&newest, &bytes[..bytes.len() / 2]).expect("it can be cut");
    let Earlier::Unfinished(resumption) = earlier(&request).expect("there is another") else {
        panic!("there is another checkpoint");
    };
    assert_eq!(resumption.damaged(), Some(newest.as_path()));
    resumption
        .run(model(), 1, &request, &mut go_on)
        .expect("it runs to its end");
    assert_eq!(timeless(&broken), timeless(&whole));
    assert!(messages(&broken) == messages(&whole));
}

#[test]
fn what_cannot_go_on_is_refused_with_a_reason_and_left_as_it_is() {
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let plan = plan(END);
    let path = directory.path().join("run");
    let request = |text| request(&path, &plan, text);
    run_anew(&request(SCENE_TEXT), 1, &mut break_off).expect("it is sound");
    let recording = fs::read(path.join("run.mcap")).expect("there is a recording");

    let folder = |error: RunError| match error {
        RunError::Folder(error) => *error,
        other => panic!("{other}"),
    };
    let anew = run_anew(&request(SCENE_TEXT), 1, &mut go_on).expect_err("one can go on");
    assert!(matches!(
        folder(anew),
        FolderError::Unfinished { time: Some(_), .. }
    ));

    let other = earlier(&request("another = 1\n")).expect_err("it is another scene");
    let FolderError::OtherScene { scene_text, .. } = folder(other) else {
        panic!("the scene differs");
    };
    assert_eq!(scene_text, SCENE_TEXT);

    let Earlier::Unfinished(held) = earlier(&request(SCENE_TEXT)).expect("it can go on") else {
        panic!("there is a checkpoint");
    };
    let second = earlier(&request(SCENE_TEXT)).expect_err("it is held");
    assert!(matches!(folder(second), FolderError::Locked { .. }));
    drop(held);

    fs::write(path.join("run.mcap"), &recording[..recording.len() / 2]).expect("it can be cut");
    // What a user may have put there stays too.
    fs::write(path.join("layout.json"), "mine").expect("it can be written");
    let left = contents(&path);
    let Earlier::Unfinished(resumption) = earlier(&request(SCENE_TEXT)).expect("it is there")
    else {
        panic!("there is a checkpoint");
    };
    let short = resumption
        .run(model(), 1, &request(SCENE_TEXT), &mut go_on)
        .expect_err("messages are missing");
    assert!(matches!(folder(short), FolderError::ShortRecording { .. }));
    assert_eq!(contents(&path), left);

    discard(&path).expect("it can be dropped");
    run_anew(&request(SCENE_TEXT), 1, &mut go_on).expect("it runs to its end");
    let Earlier::Finished(summary) = earlier(&request(SCENE_TEXT)).expect("it is over") else {
        panic!("the run is over");
    };
    assert_eq!(summary.ended, Ended::EndTime);
}
