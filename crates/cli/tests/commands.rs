//! Commands do what their help says.

mod common;

use common::{call, program};
use std::fs;
use std::net::TcpListener;
use tempfile::TempDir;

#[test]
fn help_teaches_with_examples_units_and_exit_codes() {
    let directory = TempDir::new().expect("a directory");
    let help = call(directory.path(), &["--help"]);
    assert_eq!(help.code, 0);
    for part in [
        "Examples:",
        "Units:",
        "Exit codes:",
        "130",
        "run",
        "check",
        "schema",
        "new",
        "inspect",
    ] {
        assert!(help.output.contains(part), "{part}");
    }
    for command in [
        "run",
        "check",
        "schema",
        "new",
        "inspect",
        "impact",
        "safe-speed",
        "accuracy",
        "materials",
        "completions",
    ] {
        let help = call(directory.path(), &[command, "--help"]);
        assert_eq!(help.code, 0);
        assert!(help.output.contains("Example"), "{command}");
    }
}

#[test]
fn completions_know_the_commands() {
    let directory = TempDir::new().expect("a directory");
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let script = call(directory.path(), &["completions", shell]);
        assert_eq!(script.code, 0);
        assert!(script.output.contains("inspect"), "{shell}");
    }
}

#[test]
fn the_schema_is_json_of_draft_7() {
    let directory = TempDir::new().expect("a directory");
    let schema = call(directory.path(), &["schema"]).output;
    let schema: serde_json::Value = serde_json::from_str(&schema).expect("JSON");
    assert!(
        schema["$schema"]
            .as_str()
            .is_some_and(|id| id.contains("draft-07"))
    );
    assert!(schema["properties"]["walls"].is_object());
}

#[test]
fn a_new_scene_checks_runs_and_is_inspected() {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "drop"]).code, 0);

    let again = call(path, &["new", "drop"]);
    assert_eq!(again.code, 2);
    assert!(
        again
            .error
            .contains("drop.toml exists and is not overwritten"),
        "{}",
        again.error
    );

    let check = call(path, &["check", "drop.toml"]);
    assert_eq!(check.code, 0, "{}", check.error);
    assert!(check.output.contains("time step"), "{}", check.output);

    let run = call(path, &["run", "drop.toml"]);
    assert_eq!(run.code, 0, "{}{}", run.output, run.error);
    assert!(
        run.output.contains("contacts.max_force_n"),
        "{}",
        run.output
    );
    for file in ["run.mcap", "summary.json", "scene.toml"] {
        assert!(path.join("out/drop").join(file).is_file(), "{file}");
    }

    let inspect = call(path, &["inspect", "out/drop/run.mcap"]);
    assert_eq!(inspect.code, 0, "{}", inspect.error);
    assert!(inspect.output.contains("channel"), "{}", inspect.output);
    let inspect = call(path, &["inspect", "out/drop/run.mcap", "--json"]);
    let inspect: serde_json::Value = serde_json::from_str(&inspect.output).expect("JSON");
    assert_eq!(inspect["is_cut_off"], false);
}

#[test]
fn an_expectation_that_is_not_met_is_shown_and_fails_the_run() {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "drop"]).code, 0);
    let arguments = [
        "run",
        "drop.toml",
        "--set",
        "expect.\"bodies.inside\"=2",
        "--json",
        "--threads",
        "1",
    ];
    let run = call(path, &arguments);
    assert_eq!(run.code, 3, "{}", run.error);
    assert!(
        run.error
            .contains("expect.\"bodies.inside\": found 1, expected 2"),
        "{}",
        run.error
    );
    let summary: serde_json::Value = serde_json::from_str(&run.output).expect("JSON alone");
    assert_eq!(summary["threads"], 1);
    let outcomes = summary["expectations"].as_array().expect("a list");
    assert!(outcomes.iter().any(|outcome| outcome["is_met"] == false));
    let as_run = fs::read_to_string(path.join("out/drop/scene.toml")).expect("written");
    assert!(as_run.contains("\"bodies.inside\" = 2"), "{as_run}");
}

#[test]
fn a_quiet_run_says_nothing() {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "drop"]).code, 0);
    let run = call(path, &["run", "drop.toml", "--quiet"]);
    assert_eq!(
        (run.code, run.output.as_str(), run.error.as_str()),
        (0, "", "")
    );
}

#[test]
fn the_profile_shows_where_the_time_went_and_stays_out_of_json() {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "drop"]).code, 0);
    let run = call(path, &["run", "drop.toml", "--quiet", "--profile"]);
    assert_eq!(run.code, 0, "{}", run.error);
    let firsts: Vec<&str> = run
        .output
        .lines()
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    let summary = fs::read_to_string(path.join("out/drop/summary.json")).expect("written");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let phases = summary["performance"]["phases"]
        .as_object()
        .expect("a table");
    assert_eq!(firsts[0], "phase", "{}", run.output);
    for phase in phases.keys() {
        assert!(
            run.output
                .lines()
                .any(|line| line.trim_start().starts_with(phase)),
            "{phase} in {}",
            run.output
        );
    }
    assert_eq!(firsts.len(), phases.len() + 2, "{}", run.output);

    let run = call(path, &["run", "drop.toml", "--json", "--profile"]);
    let json: serde_json::Value = serde_json::from_str(&run.output).expect("JSON alone");
    assert!(json["performance"]["phases"]["waiting"].is_number());
}

#[test]
fn what_was_skipped_is_shown_with_why_and_what_it_saved() {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "drop"]).code, 0);
    let run = call(path, &["run", "drop.toml"]);
    let summary = fs::read_to_string(path.join("out/drop/summary.json")).expect("written");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let skipped = summary["skipped"].as_array().expect("a list");
    assert!(!skipped.is_empty());
    for row in skipped {
        let parts = ["what", "reason", "saved"].map(|key| row[key].as_str().expect("text"));
        let is_shown = |line: &str| parts.iter().all(|part| line.contains(part));
        assert!(run.output.lines().any(is_shown), "{parts:?}");
    }
}

/// The recording may grow to 40 blocks of half a kilobyte, in a program that is not killed for trying more.
#[cfg(target_os = "linux")]
#[test]
fn a_recording_that_cannot_grow_fails_the_run_with_code_4_and_the_summary_says_so() {
    use std::process::Command;

    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "hopper"]).code, 0);
    let script = "trap '' XFSZ; ulimit -f 40; exec \"$0\" run hopper.toml --quiet \
        --set 'time.end=500 s' --set 'stop.empty_after=500 s' --set 'output.frame_interval=1 ms'";
    let run = Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_pelletflow")])
        .current_dir(path)
        .output()
        .expect("the shell starts");
    let error = String::from_utf8(run.stderr).expect("text");
    assert_eq!(run.status.code(), Some(4), "{error}");
    assert!(
        error.contains("cannot write out/hopper/run.mcap"),
        "{error}"
    );
    let summary = fs::read_to_string(path.join("out/hopper/summary.json")).expect("written");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    assert_eq!(summary["ended"], "failed");
    let failure = summary["failure"].as_str().expect("text");
    assert!(error.contains(failure), "{failure}");
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_closes_its_recording_and_writes_its_summary() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};

    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "hopper"]).code, 0);
    let mut run = program(path)
        .args([
            "run",
            "hopper.toml",
            "--quiet",
            "--set",
            "time.end=5000 s",
            "--set",
            "stop.empty_after=5000 s",
        ])
        .args([
            "--set",
            "walls.gate.opens_at=5000 s",
            "--set",
            "output.frame_interval=1 s",
        ])
        .args(["--set", "output.meter_interval=1 s"])
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let recording = path.join("out/hopper/run.mcap");
    let began = Instant::now();
    // The handler is set before the recording is begun.
    while !recording.is_file() && began.elapsed() < Duration::from_mins(1) {
        std::thread::sleep(Duration::from_millis(20));
    }
    let kill = Command::new("kill")
        .args(["-INT", &run.id().to_string()])
        .status();
    assert!(kill.expect("kill is there").success());
    assert_eq!(run.wait().expect("the program ends").code(), Some(130));

    let summary = fs::read_to_string(path.join("out/hopper/summary.json")).expect("written");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    assert_eq!(summary["ended"], "interrupted");
    let inspect = call(path, &["inspect", "out/hopper/run.mcap", "--json"]).output;
    let inspect: serde_json::Value = serde_json::from_str(&inspect).expect("JSON");
    assert_eq!(inspect["is_cut_off"], false);
}

#[test]
fn a_run_says_where_it_is_watched_and_refuses_a_port_in_use_before_it_writes() {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "drop"]).code, 0);
    let taken = TcpListener::bind("127.0.0.1:0").expect("there is a free port");
    let address = taken.local_addr().expect("it is bound");
    let refused = call(path, &["run", "drop.toml", &format!("--live={address}")]);
    assert_eq!(refused.code, 4, "{}", refused.error);
    assert!(refused.error.contains(&address.to_string()));
    assert!(refused.error.contains("--live=HOST:PORT"));
    assert!(!path.join("out").exists());

    let nowhere = call(path, &["run", "drop.toml", "--live=here"]);
    assert_eq!(nowhere.code, 2, "{}", nowhere.error);
    assert!(nowhere.error.contains("`here` is no address"));

    let run = call(path, &["run", "drop.toml", "--live=127.0.0.1:0"]);
    assert_eq!(run.code, 0, "{}", run.error);
    assert!(run.output.starts_with("watch at ws://127.0.0.1:"));
    assert!(run.output.contains("layout out/drop/layout.json\n"));
    assert!(!run.error.contains("warning"), "{}", run.error);
}

#[test]
fn check_tells_the_frames_that_are_kept_and_what_they_take() {
    let directory = TempDir::new().expect("a directory");
    let path = directory.path();
    assert_eq!(call(path, &["new", "hopper"]).code, 0);
    let forecast = |settings: &[&str]| {
        let told = call(
            path,
            &[&["check", "hopper.toml", "--json"], settings].concat(),
        );
        let told: serde_json::Value = serde_json::from_str(&told.output).expect("JSON");
        ["frames", "frames_kept_at_most"].map(|key| told[key].as_f64().expect("a number"))
    };
    let [frames, kept] = forecast(&[]);
    assert_eq!(kept, frames);
    // The first, and those of the span with one at its beginning.
    let last = [
        "--set",
        "output.frame_interval=0.01",
        "--set",
        "output.frames_of_last=0.1",
    ];
    assert_eq!(forecast(&last)[1], 1.0 + 11.0);
    let page = call(path, &[&["check", "hopper.toml"][..], &last].concat()).output;
    assert!(page.contains("frames kept at the end"), "{page}");
    assert!(page.contains("at most 12, about "), "{page}");
}
