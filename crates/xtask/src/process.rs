//! Commands that are printed before they run and whose failure ends the work.

use anyhow::{Context, Result};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Line breaks between the last lines of a text that are shown.
const TAIL: usize = 7;

/// A command that ended with another exit code than zero.
#[derive(Debug, thiserror::Error)]
#[error("`{command}` ended with code {code}")]
pub(crate) struct Failed {
    command: String,
    /// Its exit code; 1 where a signal ended it.
    pub(crate) code: u8,
}

/// Runs a command to its end.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    announce(command);
    let status = command
        .status()
        .with_context(|| format!("cannot start `{}`", line_of(command)))?;
    judge(command, status)
}

/// Runs a command to its end and hands each line of its standard output to `look`.
pub(crate) fn run_watched(command: &mut Command, mut look: impl FnMut(&str)) -> Result<()> {
    announce(command);
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("cannot start `{}`", line_of(command)))?;
    let output = child.stdout.take().expect("standard output was piped");
    for line in BufReader::new(output).split(b'\n') {
        let line = line.context("cannot read the output of a command")?;
        look(&String::from_utf8_lossy(&line));
    }
    let status = child.wait().context("cannot wait for a command")?;
    judge(command, status)
}

/// Runs a command to its end without a word and gives its standard output; what it complained of is in the error.
pub(crate) fn answer(command: &mut Command) -> Result<String> {
    let output = command
        .stdin(Stdio::null())
        .output()
        .with_context(|| format!("cannot start `{}`", line_of(command)))?;
    judge(command, output.status)
        .with_context(|| tail(&String::from_utf8_lossy(&output.stderr)).to_owned())?;
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The last lines of a text.
pub(crate) fn tail(text: &str) -> &str {
    let text = text.trim_end();
    let start = text.rmatch_indices('\n').nth(TAIL).map_or(0, |(at, _)| at);
    text[start..].trim_start()
}

/// Whether a command succeeds within a time; what it prints is dropped.
pub(crate) fn succeeds_within(command: &mut Command, limit: Duration) -> bool {
    announce(command);
    let started = Instant::now();
    let Ok(mut child) = command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
    else {
        return false;
    };
    while started.elapsed() < limit {
        match child.try_wait() {
            Ok(None) => std::thread::sleep(Duration::from_millis(50)),
            Ok(Some(status)) => return status.success(),
            Err(_) => return false,
        }
    }
    // It may have ended in between; either way it took too long.
    let _ = child.kill();
    let _ = child.wait();
    false
}

fn announce(command: &Command) {
    // What a command answers is on standard output; that it was started is news of the way.
    eprintln!("\n$ {}", line_of(command));
}

fn judge(command: &Command, status: ExitStatus) -> Result<()> {
    if status.success() {
        return Ok(());
    }
    let code = status
        .code()
        .and_then(|code| u8::try_from(code).ok())
        .unwrap_or(1);
    Err(Failed {
        command: line_of(command),
        code,
    }
    .into())
}

/// A command as one would type it, its program without the folder.
fn line_of(command: &Command) -> String {
    let variables = command.get_envs().filter_map(|(name, value)| {
        let value = value?.to_string_lossy();
        Some(format!("{}={}", name.to_string_lossy(), quoted(&value)))
    });
    let program = Path::new(command.get_program())
        .file_name()
        .unwrap_or(command.get_program());
    let words = std::iter::once(program)
        .chain(command.get_args())
        .map(|word| quoted(&word.to_string_lossy()));
    variables.chain(words).collect::<Vec<_>>().join(" ")
}

fn quoted(word: &str) -> String {
    if word.is_empty() || word.contains([' ', '"', '$', '*']) {
        format!("'{word}'")
    } else {
        word.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_printed_as_one_would_type_it() {
        let mut command = Command::new("/usr/bin/cargo");
        command
            .args(["doc", "--no deps"])
            .env("RUSTDOCFLAGS", "-D warnings");
        assert_eq!(
            line_of(&command),
            "RUSTDOCFLAGS='-D warnings' cargo doc '--no deps'"
        );
    }

    #[test]
    fn a_failure_keeps_the_exit_code_of_the_command() {
        let mut cargo = crate::workspace::cargo();
        let error = run(cargo.arg("no-such-command")).expect_err("there is no such command");
        let failed = error.downcast_ref::<Failed>().expect("the command started");
        assert_eq!(failed.code, 101);
    }

    #[test]
    fn a_command_that_takes_too_long_is_ended() {
        let mut sleep = Command::new("python3");
        sleep.args(["-c", "import time; time.sleep(60)"]);
        let started = Instant::now();
        assert!(!succeeds_within(&mut sleep, Duration::from_millis(200)));
        assert!(started.elapsed() < Duration::from_secs(30));
    }
}
