//! The command line: arguments in, tables and files out.

mod args;
mod commands;
mod exit;
mod file;
mod progress;
mod screen;
mod table;

use args::{Arguments, Command};
use clap::Parser;
use exit::{Exit, Failure};
use std::ffi::OsString;

/// Runs the command line with arguments, the first of which is the program's name; returns the exit code [-].
///
/// 0: done; 2: bad input; 3: the physics failed or an expectation is not met; 4: reading or writing failed;
/// 130: interrupted.
pub fn main_from(args: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments = match Arguments::try_parse_from(args) {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version come this way too; a closed pipe is no reason to fail.
            let _ = error.print();
            return u8::try_from(error.exit_code()).unwrap_or(Exit::BadInput.code());
        }
    };
    let outcome = match &arguments.command {
        Command::Run(run) => commands::run::run(run),
        Command::Check(check) => commands::check::check(check),
        Command::Schema => commands::schema::schema(),
        Command::New(new) => commands::new::new(new),
        Command::Inspect(inspect) => commands::inspect::inspect(inspect),
        Command::Report(report) => commands::report::write_report(report),
        Command::Export(export) => commands::export::write_export(export),
        Command::Impact(impact) => commands::impact::impact(impact),
        Command::SafeSpeed(safe_speed) => commands::safe_speed::safe_speed(safe_speed),
        Command::Score(arguments) => commands::score::score_hits(arguments),
        Command::Card(card) => commands::card::card(card),
        Command::Accuracy(accuracy) => commands::accuracy::accuracy(accuracy),
        Command::Materials(materials) => commands::materials::materials(materials),
        Command::Completions(completions) => commands::completions::completions(completions),
    };
    match outcome {
        Ok(exit) => exit.code(),
        Err(Failure::ClosedPipe) => Exit::Done.code(),
        Err(Failure::Message { exit, message }) => {
            screen::error(&message);
            exit.code()
        }
    }
}
