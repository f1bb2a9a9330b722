//! The real program, run and read.

use std::path::Path;
use std::process::{Command, Output};

/// What a call of the program came to.
pub(crate) struct Call {
    /// Exit code [-].
    pub(crate) code: i32,
    /// Standard output.
    pub(crate) output: String,
    /// Standard error.
    pub(crate) error: String,
}

/// The program, to be run in a directory.
pub(crate) fn program(directory: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_pelletflow"));
    command.current_dir(directory);
    command
}

/// Runs the program in a directory.
pub(crate) fn call(directory: &Path, arguments: &[&str]) -> Call {
    let Output {
        status,
        stdout,
        stderr,
    } = program(directory)
        .args(arguments)
        .output()
        .expect("the program starts");
    Call {
        code: status.code().expect("the program ends by itself"),
        output: String::from_utf8(stdout).expect("text"),
        error: String::from_utf8(stderr).expect("text"),
    }
}
