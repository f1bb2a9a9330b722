//! Developer commands, run as `cargo xtask <command>`.
#![expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a command line reports by printing"
)]

mod check;
mod dependencies;
mod distribution;
mod documentation;
mod fuzz;
mod page;
mod peers;
mod process;
mod report;
mod stress;
mod test;
mod venv;
mod verify;
mod viewers;
mod workspace;

use clap::Parser;
use process::Failed;
use report::Report;
use std::process::ExitCode;

/// Developer commands of pelletflow.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
enum Command {
    /// Sets up and runs every test: Rust, the Python wheel, and the example scenes with their recordings; needs only Rust and Python 3.
    Test,
    /// Runs the whole gate: format, spelling, dependencies, lints, documentation, every test, Python types.
    Check,
    /// Holds every claim against what is known, the slow ones too, and writes the tables and pictures of docs/verification.md.
    Verify {
        /// Test files to run, without their ending; all, and the pictures, where none is named.
        #[arg(value_parser = clap::builder::PossibleValuesParser::new(verify::TESTS))]
        tests: Vec<String>,
    },
    /// Runs hard cases over a range of steps and for a million steps, and writes where each breaks into docs/verification.md.
    Stress(stress::Options),
    /// Builds the wheel of this platform, with every instruction set inside, from the source distribution; both into target/dist.
    Wheel,
    /// Hands bytes that a fuzzer makes up to everything that reads what others wrote; needs a compiler of C++.
    Fuzz(fuzz::Options),
    /// Compares the speed with LAMMPS and LIGGGHTS, which it installs, and with itself; prints a table.
    BenchPeers(peers::Options),
}

fn main() -> ExitCode {
    let mut report = Report::new();
    let outcome = match Command::parse() {
        Command::Test => test::run(&mut report),
        Command::Check => check::run(&mut report),
        Command::Verify { tests } => verify::run(&mut report, &tests),
        Command::Stress(options) => stress::run(&mut report, &options),
        Command::Wheel => distribution::run(&mut report),
        Command::Fuzz(options) => fuzz::run(&mut report, &options),
        Command::BenchPeers(options) => peers::run(&options),
    };
    report.print();
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("\nfailed: {error:#}");
            let code = error
                .downcast_ref::<Failed>()
                .map_or(1, |failed| failed.code);
            ExitCode::from(code)
        }
    }
}
