//! A run that is killed or interrupted goes on with `--resume`, to the same bits.

mod common;

use common::{Call, call, program};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};
use std::thread;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// A small hopper with checkpoints every few milliseconds, in a folder of its own.
const RUN: &[&str] = &[
    "run",
    "hopper.toml",
    "--quiet",
    "--set",
    "fill.bed.count=80",
    "--set",
    "output.checkpoint_interval=0.02",
];

fn hopper() -> TempDir {
    let directory = TempDir::new().expect("a directory");
    assert_eq!(call(directory.path(), &["new", "hopper"]).code, 0);
    directory
}

fn arguments<'a>(output: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [RUN, &["-o", output], more].concat()
}

fn start(directory: &Path, arguments: &[&str]) -> Child {
    program(directory)
        .args(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

fn summary(directory: &Path, output: &str) -> Value {
    let path = directory.join(output).join("summary.json");
    let text = fs::read_to_string(path).expect("a run that is over has a summary");
    serde_json::from_str(&text).expect("it is JSON")
}

/// Runs the hopper unbroken; its summary and how long that took.
fn unbroken(directory: &Path) -> (Value, Duration) {
    let began = Instant::now();
    let whole = call(directory, &arguments("whole", &[]));
    assert_eq!(whole.code, 0, "{}", whole.error);
    (summary(directory, "whole"), began.elapsed())
}

/// Waits until a file is there.
fn wait_for(path: &Path) {
    let began = Instant::now();
    while !path.exists() {
        assert!(
            began.elapsed() < Duration::from_mins(1),
            "{}",
            path.display()
        );
        thread::sleep(Duration::from_millis(1));
    }
}

#[cfg(unix)]
fn signal(child: &Child, name: &str) {
    let sent = std::process::Command::new("kill")
        .args(["-s", name, &child.id().to_string()])
        .status()
        .expect("kill is there");
    assert!(sent.success(), "{name}");
}

/// Shares between 0 and 1 that look random, the same in every run of the tests.
fn shares() -> impl Iterator<Item = f64> {
    // Weyl's sequence: multiples of the golden ratio fill the interval evenly.
    (1..).map(|index| (f64::from(index) * 0.618_033_988_749_894_9).fract())
}

#[test]
fn fifty_of_fifty_killed_runs_open_and_go_on_to_the_same_bits() {
    let directory = hopper();
    let (expected, mut took) = unbroken(directory.path());
    let mut killed = 0;
    let mut taken_up = 0;
    let mut shares = shares();
    for index in 0.. {
        if killed >= 50 {
            break;
        }
        assert!(index < 150, "runs end before they are killed");
        let output = format!("out{index}");
        let folder = directory.path().join(&output);
        // Killed up to three times, each time at another moment of what may be left.
        for attempt in 0..3 {
            let began = Instant::now();
            let mut child = start(directory.path(), &arguments(&output, &["--resume"]));
            let share = shares.next().expect("there is no end of them");
            thread::sleep(took.mul_f64(share));
            if child.try_wait().expect("it is ours").is_some() {
                if attempt == 0 {
                    // The machine was slower when the unbroken one ran.
                    took = took.min(began.elapsed());
                }
                break;
            }
            child.kill().expect("it runs");
            child.wait().expect("it is ours");
            killed += 1;
            taken_up += usize::from(folder.join("checkpoint.pf").exists());
            // What is killed before its first bytes leaves nothing to open.
            let recording = folder.join("run.mcap");
            if recording.metadata().is_ok_and(|file| file.len() > 8) {
                let path = recording.display().to_string();
                let inspected = call(directory.path(), &["inspect", &path]);
                assert_eq!(inspected.code, 0, "{}", inspected.error);
            }
        }
        let last = call(directory.path(), &arguments(&output, &["--resume"]));
        assert_eq!(last.code, 0, "{}", last.error);
        let found = summary(directory.path(), &output);
        assert_eq!(found["state_hash"], expected["state_hash"]);
        assert_eq!(found["hits"], expected["hits"]);
        assert_eq!(found["meters"], expected["meters"]);
        let recording = folder.join("run.mcap").display().to_string();
        let inspected = call(directory.path(), &["inspect", &recording, "--json"]);
        let inspected: Value = serde_json::from_str(&inspected.output).expect("it is JSON");
        assert_eq!(inspected["is_cut_off"], false);
        fs::remove_dir_all(folder).expect("it is ours");
    }
    assert!(taken_up > 20, "{taken_up} of {killed} had a checkpoint");
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_says_how_to_go_on_and_does() {
    let directory = hopper();
    let (expected, _) = unbroken(directory.path());
    for name in ["INT", "TERM"] {
        let mut arguments = arguments(name, &[]);
        arguments.retain(|argument| *argument != "--quiet");
        let child = program(directory.path())
            .args(&arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        wait_for(&directory.path().join(name).join("checkpoint.pf"));
        signal(&child, name);
        let ended = child.wait_with_output().expect("it is ours");
        let error = String::from_utf8(ended.stderr).expect("text");
        assert_eq!(ended.status.code(), Some(130), "{error}");
        assert!(error.contains("--resume"), "{error}");
        assert_eq!(summary(directory.path(), name)["ended"], "interrupted");

        let command = error
            .lines()
            .find_map(|line| line.split_once("go on with: pelletflow "))
            .map(|(_, command)| command)
            .expect("it names the command");
        let shell = format!("{} {command}", env!("CARGO_BIN_EXE_pelletflow"));
        let again = std::process::Command::new("sh")
            .args(["-c", &shell])
            .current_dir(directory.path())
            .output()
            .expect("a shell is there");
        let error = String::from_utf8(again.stderr).expect("text");
        assert_eq!(again.status.code(), Some(0), "{error}");
        assert!(error.contains("goes on at t = "), "{error}");
        let found = summary(directory.path(), name);
        assert_eq!(found["state_hash"], expected["state_hash"]);

        let done = call(directory.path(), &[&arguments[..], &["--resume"]].concat());
        assert_eq!(done.code, 0);
        assert!(done.error.contains("finished run"), "{}", done.error);
    }
}

#[test]
fn an_unfinished_run_is_never_overwritten_by_mistake() {
    let directory = hopper();
    let mut child = start(directory.path(), &arguments("out", &[]));
    wait_for(&directory.path().join("out/checkpoint.pf"));

    let Call { code, error, .. } = call(directory.path(), &arguments("out", &["--resume"]));
    assert_eq!(code, 2);
    assert!(error.contains("another run writes there"), "{error}");
    assert!(error.contains(&child.id().to_string()), "{error}");

    child.kill().expect("it runs");
    child.wait().expect("it is ours");
    let Call { code, error, .. } = call(directory.path(), &arguments("out", &[]));
    assert_eq!(code, 2);
    assert!(
        error.contains("holds an unfinished run, at t = "),
        "{error}"
    );
    assert!(error.contains("`--resume`"), "{error}");

    let other = ["--resume", "--set", "materials.steel.poisson_ratio=0.3"];
    let Call { code, error, .. } = call(directory.path(), &arguments("out", &other));
    assert_eq!(code, 2);
    let named = "materials.steel.poisson_ratio: 0.28, now 0.3";
    assert!(error.contains(named), "{error}");

    let anew = call(directory.path(), &arguments("out", &["--restart"]));
    assert_eq!(anew.code, 0, "{}", anew.error);
}

#[test]
fn resuming_where_there_is_nothing_begins_at_the_start_and_says_so() {
    let directory = hopper();
    let mut arguments = arguments("out", &["--resume"]);
    arguments.retain(|argument| *argument != "--quiet");
    let Call { code, error, .. } = call(directory.path(), &arguments);
    assert_eq!(code, 0, "{error}");
    assert!(error.contains("out holds no checkpoint: the run begins at the start"));
}
