//! `cargo xtask fuzz`: readers are handed bytes that a fuzzer makes up.
//!
//! LLVM's fuzzer watches which branches bytes lead to, and changes those that led to new ones. Stable Rust can build that;
//! only the sanitizers need more, and without `unsafe` there is little for them to find.

use crate::process;
use crate::report::Report;
use crate::workspace::{cargo, root, target};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The version of cargo-fuzz that the flags below are those of.
const CARGO_FUZZ: &str = "0.13.2";
/// Memory that a reader may take, in MiB: what the longest record of a recording takes, and as much again.
const MOST_MEBIBYTES: u32 = 2048;
/// Time that one input may take [s].
const LONGEST_SECONDS: u32 = 20;
/// Folders outside of the corpus with more to begin with, by fuzzer.
const MORE: [(&str, &str); 3] = [
    ("scene", "examples/scenes"),
    ("scene", "crates/scene/src/templates"),
    ("sheet", "examples/sheets"),
];

/// What is asked for.
#[derive(Debug, clap::Args)]
pub(crate) struct Options {
    /// Time for each fuzzer [s].
    #[arg(long, default_value_t = 600)]
    seconds: u32,
    /// Fuzzers to run, by the names of their files in `tests/fuzz/fuzz_targets`; all where none is named.
    targets: Vec<String>,
}

/// Runs fuzzers one after another; the first finding ends it.
pub(crate) fn run(report: &mut Report, options: &Options) -> Result<()> {
    let tool = cargo_fuzz()?;
    report.part("fuzzers", || {
        process::run(&mut fuzz(&tool, "build"))?;
        Ok("built".to_owned())
    })?;
    let targets = if options.targets.is_empty() {
        all()?
    } else {
        options.targets.clone()
    };
    report.part("fuzzing", || {
        for name in &targets {
            one(&tool, name, options.seconds)?;
        }
        let names = targets.join(", ");
        Ok(format!(
            "nothing found in {} s each: {names}",
            options.seconds
        ))
    })
}

/// Runs one fuzzer; what it learns stays under `target`.
fn one(tool: &Path, name: &str, seconds: u32) -> Result<()> {
    let learned = target().join("fuzz/corpus").join(name);
    let findings = target().join("fuzz/findings");
    for folder in [&learned, &findings] {
        fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    }
    let mut command = fuzz(tool, "run");
    command.arg(name).arg(&learned);
    command.arg(root().join("tests/fuzz/corpus").join(name));
    for (_, folder) in MORE.iter().filter(|(of, _)| *of == name) {
        command.arg(root().join(folder));
    }
    let words = root().join("tests/fuzz").join(format!("{name}.dict"));
    command.arg("--");
    if words.exists() {
        command.arg(format!("-dict={}", words.display()));
    }
    command
        .arg(format!("-max_total_time={seconds}"))
        .arg(format!("-rss_limit_mb={MOST_MEBIBYTES}"))
        .arg(format!("-timeout={LONGEST_SECONDS}"))
        .arg(format!("-artifact_prefix={}/{name}-", findings.display()))
        .args(["-print_final_stats=1", "-verbosity=1"]);
    // Files of an input live for a moment: in memory, where there is a place for that.
    let memory = Path::new("/dev/shm");
    if memory.is_dir() {
        command.env("TMPDIR", memory);
    }
    process::run(&mut command)
}

/// A command of cargo-fuzz, with what all of them need.
fn fuzz(tool: &Path, verb: &str) -> Command {
    let mut command = Command::new(tool);
    command
        .current_dir(root())
        .args(["fuzz", verb, "--fuzz-dir", "tests/fuzz"])
        // The profile of tests: overflows are told, and nothing is linked for long.
        .args(["--dev", "--sanitizer", "none", "--features", "fuzzer"])
        .arg("--target-dir")
        .arg(target().join("fuzz"));
    command
}

/// The tool cargo-fuzz, installed under `target` where it is not there.
fn cargo_fuzz() -> Result<PathBuf> {
    let folder = target().join("tools");
    let tool = folder.join("bin/cargo-fuzz");
    if !tool.exists() {
        process::run(
            cargo()
                .args(["install", "cargo-fuzz", "--locked", "--version", CARGO_FUZZ])
                .arg("--root")
                .arg(&folder),
        )?;
    }
    Ok(tool)
}

/// All fuzzers, by name.
fn all() -> Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(root().join("tests/fuzz/fuzz_targets"))? {
        let path = entry?.path();
        names.extend(
            path.file_stem()
                .map(|name| name.to_string_lossy().into_owned()),
        );
    }
    names.sort();
    Ok(names)
}
