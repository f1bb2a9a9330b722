//! Where commands write: results to standard output, everything else to standard error.

use crate::exit::{Exit, Failure};
use std::io::{self, IsTerminal, Write};

/// Writes a result and ends the line.
pub(crate) fn result(text: &str) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    writeln!(output, "{}", text.trim_end())
        .and_then(|()| output.flush())
        .map_err(|error| match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
            _ => Failure::new(
                Exit::InputOutput,
                format!("standard output cannot be written: {error}"),
            ),
        })
}

/// Writes a value as JSON.
pub(crate) fn json(value: &serde_json::Value) -> Result<(), Failure> {
    result(&format!("{value:#}"))
}

/// Writes a remark. Where standard error is closed there is nobody to tell.
pub(crate) fn remark(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Writes what went wrong.
pub(crate) fn error(message: &str) {
    remark(&format!("error: {message}"));
}

/// Whether somebody looks at standard error.
pub(crate) fn is_watched() -> bool {
    io::stderr().is_terminal()
}
