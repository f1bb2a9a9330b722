//! `pelletflow completions`.

use crate::args::{Arguments, CompletionsArguments};
use crate::exit::{Exit, Failure};
use crate::screen;
use clap::CommandFactory;

/// Prints completions for a shell.
pub(crate) fn completions(arguments: &CompletionsArguments) -> Result<Exit, Failure> {
    // Written to memory first: the generator panics where a pipe is closed.
    let mut script = Vec::new();
    clap_complete::generate(
        arguments.shell,
        &mut Arguments::command(),
        "pelletflow",
        &mut script,
    );
    screen::result(&String::from_utf8_lossy(&script))?;
    Ok(Exit::Done)
}
