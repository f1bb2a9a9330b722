//! What a machine may do to a run: each time a message that helps, the right exit code, and nothing lost that was saved.

#![cfg(unix)]

mod common;

use common::{Call, call, program};
use serde_json::Value;
use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::io::Read;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};
use tempfile::TempDir;

fn hopper() -> TempDir {
    let directory = TempDir::new().expect("a directory");
    assert_eq!(call(directory.path(), &["new", "hopper"]).code, 0);
    directory
}

/// Runs the program in a shell that has done something first.
fn in_shell(directory: &Path, before: &str, arguments: &str) -> Call {
    let script = format!(
        "{before} exec {} {arguments}",
        env!("CARGO_BIN_EXE_pelletflow")
    );
    let Output {
        status,
        stdout,
        stderr,
    } = Command::new("sh")
        .args(["-c", &script])
        .current_dir(directory)
        .output()
        .expect("a shell is there");
    Call {
        code: status.code().unwrap_or(-1),
        output: String::from_utf8_lossy(&stdout).into_owned(),
        error: String::from_utf8_lossy(&stderr).into_owned(),
    }
}

fn summary(directory: &Path, output: &str) -> Value {
    let path = directory.join(output).join("summary.json");
    let text = fs::read_to_string(path).expect("a run that is over has a summary");
    serde_json::from_str(&text).expect("it is JSON")
}

fn state_hash(directory: &Path, output: &str) -> Value {
    summary(directory, output)["state_hash"].clone()
}

#[test]
fn a_full_disk_ends_the_run_with_a_reason_and_it_goes_on_when_there_is_room() {
    let directory = hopper();
    let run =
        "run hopper.toml --quiet --set fill.bed.count=200 --set output.checkpoint_interval=0.02";
    let whole = in_shell(directory.path(), "", &format!("{run} -o whole"));
    assert_eq!(whole.code, 0, "{}", whole.error);
    let size = fs::metadata(directory.path().join("whole/run.mcap"))
        .expect("there is a recording")
        .len();
    // A limit of the size of files, in blocks of 512 bytes: to the program it is a disk that takes no more.
    let limit = format!("trap '' XFSZ; ulimit -f {};", size / 2 / 512);
    let full = in_shell(directory.path(), &limit, &format!("{run} -o out"));
    assert_eq!(full.code, 4, "{}", full.error);
    assert!(full.error.contains("cannot write out/"), "{}", full.error);
    assert!(full.error.contains("free some space"), "{}", full.error);
    assert!(directory.path().join("out/checkpoint.pf").exists());

    let again = in_shell(directory.path(), "", &format!("{run} -o out --resume"));
    assert_eq!(again.code, 0, "{}", again.error);
    assert_eq!(
        state_hash(directory.path(), "out"),
        state_hash(directory.path(), "whole")
    );
}

#[test]
fn a_device_that_is_full_from_the_start_is_named() {
    if !Path::new("/dev/full").exists() {
        return;
    }
    let directory = hopper();
    fs::create_dir(directory.path().join("out")).expect("it can be made");
    std::os::unix::fs::symlink("/dev/full", directory.path().join("out/run.mcap"))
        .expect("links can be made");
    let run = "run hopper.toml --quiet --set fill.bed.count=5 -o out";
    let Call {
        code,
        output,
        error,
    } = in_shell(directory.path(), "", run);
    assert_eq!(code, 4, "{error}");
    assert_eq!(output, "", "what is no result goes to standard error");
    assert!(error.contains("cannot write out/run.mcap"), "{error}");
}

#[test]
fn a_folder_that_is_read_only_is_named_before_anything_is_computed() {
    let directory = hopper();
    let out = directory.path().join("out");
    fs::create_dir(&out).expect("it can be made");
    fs::set_permissions(&out, fs::Permissions::from_mode(0o555)).expect("it is ours");
    if fs::write(out.join("probe"), "").is_ok() {
        // Permissions do not bind root; a file in place of the folder binds everyone.
        fs::remove_dir_all(&out).expect("it is ours");
        fs::write(&out, "").expect("it can be made");
    }
    let Call { code, error, .. } = call(directory.path(), &["run", "hopper.toml", "-o", "out"]);
    assert_eq!(code, 4, "{error}");
    assert!(error.contains("cannot write out"), "{error}");
    assert!(error.contains("choose another directory"), "{error}");
}

#[test]
fn a_run_whose_output_nobody_reads_goes_to_its_end() {
    let directory = hopper();
    let mut child = program(directory.path())
        .args(["run", "hopper.toml", "--set", "fill.bed.count=40", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // As after `| head -1`: both ends are closed before anything is written.
    drop(child.stdout.take());
    let mut first = [0; 1];
    let mut error = child.stderr.take().expect("it is piped");
    let _ = error.read(&mut first);
    drop(error);
    let status = child.wait().expect("it is ours");
    assert_eq!(status.code(), Some(0));
    assert!(directory.path().join("out/hopper/summary.json").exists());
}

#[test]
fn a_run_that_gets_no_more_memory_goes_on_where_there_is_some() {
    let directory = hopper();
    let run = "run hopper.toml --quiet --threads 1 --set output.checkpoint_interval=0.02 --set fill.bed.count=100";
    let whole = in_shell(directory.path(), "", &format!("{run} -o whole"));
    assert_eq!(whole.code, 0, "{}", whole.error);
    // Limits [KiB] from what does not even load the program to what is enough: whatever happens, the folder is left in order.
    let mut codes = BTreeSet::new();
    for limit in (12_000..32_000).step_by(2_000) {
        let before = format!("ulimit -v {limit};");
        let out = format!("out{limit}");
        let arguments = format!("{run} -o {out} --resume");
        let Call { code, error, .. } = in_shell(directory.path(), &before, &arguments);
        codes.insert(code);
        let has_begun = directory.path().join(&out).exists();
        if code != 0 && has_begun {
            assert!(!error.trim().is_empty(), "{limit} KiB: not a word");
        }
        let again = in_shell(directory.path(), "", &format!("{run} -o {out} --resume"));
        assert_eq!(again.code, 0, "{limit} KiB: {}", again.error);
        assert_eq!(
            state_hash(directory.path(), &out),
            state_hash(directory.path(), "whole")
        );
    }
    assert!(codes.len() > 1, "the limits did nothing: {codes:?}");
}

/// Moments that a clock is set to while a run goes on: years back and ahead, and standing still.
const SET_TO: [&str; 4] = ["-10y", "+10y", "1970-01-02 00:00:00", "-1d"];

#[test]
#[ignore = "needs libfaketime, whose path LIBFAKETIME tells; `cargo xtask check` runs it where there is one"]
fn a_clock_that_is_set_while_a_run_goes_on_changes_nothing() {
    let library = env::var_os("LIBFAKETIME").expect("the path of libfaketimeMT.so.1");
    let directory = hopper();
    let clock = directory.path().join("clock");
    let set = |moment: &str| {
        let new = directory.path().join("clock.new");
        fs::write(&new, moment).expect("writable");
        fs::rename(&new, &clock).expect("writable");
    };
    // As on a machine: the clock that never goes back is not set with the other one.
    let under_that_clock = |command: &mut Command| {
        command
            .env("LD_PRELOAD", &library)
            .env("FAKETIME_TIMESTAMP_FILE", &clock)
            .env("FAKETIME_NO_CACHE", "1")
            .env("FAKETIME_DONT_FAKE_MONOTONIC", "1");
    };
    set("1970-01-02 00:00:00");
    let mut date = Command::new("date");
    under_that_clock(date.args(["-u", "+%Y"]));
    let year = date.output().expect("there is a clock").stdout;
    assert_eq!(String::from_utf8_lossy(&year).trim(), "1970");

    let settings = ["fill.bed.count=200", "output.checkpoint_interval=0.02"];
    let arguments = |output| {
        let sets = settings.iter().flat_map(|setting| ["--set", setting]);
        let run = ["run", "hopper.toml", "--quiet", "-o", output];
        run.into_iter().chain(sets).collect::<Vec<_>>()
    };
    let whole = call(directory.path(), &arguments("whole"));
    assert_eq!(whole.code, 0, "{}", whole.error);
    let mut command = program(directory.path());
    under_that_clock(command.args(arguments("out")));
    let began = Instant::now();
    let mut run = command.spawn().expect("the program starts");
    let mut moments = 0;
    let status = loop {
        set(SET_TO[moments % SET_TO.len()]);
        moments += 1;
        thread::sleep(Duration::from_millis(10));
        if let Some(status) = run.try_wait().expect("it is ours") {
            break status;
        }
    };
    let took = began.elapsed();
    assert_eq!(status.code(), Some(0));
    assert!(moments > 5, "it ended before the clock was set");
    let [found, expected] = ["out", "whole"].map(|output| summary(directory.path(), output));
    for key in ["state_hash", "hits", "meters", "energy"] {
        assert_eq!(found[key], expected[key], "{key}");
    }
    let told = found["time"]["wall_s"].as_f64();
    let told = told.expect("it tells how long it took");
    assert!(told > 0.0 && told < took.as_secs_f64(), "{told} {took:?}");
}
