//! `cargo xtask bench-peers`: speed and accuracy side by side with LAMMPS and LIGGGHTS, in one run.
//!
//! Same pellets at the same places, same law, step and skin; round by round one code after the other.

mod accuracy;
mod bench;
mod case;
mod code;
mod description;
mod figures;
mod inputs;
mod install;
mod lammps;
mod liggghts;
mod log;
mod machine;
mod ours;
mod race;
mod row;
mod table;

use crate::page;
use crate::workspace::root;
use anyhow::{Context, Result};
use bench::{Bench, Pace};
use clap::Args;
use row::Row;
use serde_json::Value;
use std::fs;

/// The page, from the root.
const PAGE: &str = "docs/performance.md";

/// What to compare, and how to tell it.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Prints an array of rows for programs in place of the table.
    #[arg(long)]
    json: bool,
    /// Takes fewer and shorter rounds, and of the cases only the small ones.
    #[arg(long)]
    quick: bool,
    /// Measures this case; may be given several times.
    #[arg(long = "case", value_name = "NAME", value_parser = clap::builder::PossibleValuesParser::new(case::names()))]
    cases: Vec<String>,
    /// Writes the rows into the table of docs/performance.md, too.
    #[arg(long, conflicts_with = "quick")]
    write: bool,
}

/// Installs the other codes, runs the cases and prints what came of them.
pub(crate) fn run(options: &Options) -> Result<()> {
    let ours = ours::Ours::build()?;
    let peers = install::all();
    let machine = machine::description(&peers, &line_of(options))?;
    eprintln!("{machine}");
    let pace = if options.quick {
        Pace::Quick
    } else {
        Pace::Full
    };
    let mut bench = Bench::new(ours, peers, pace);
    let mut rows = Vec::new();
    let mut failures = Vec::new();
    for case in case::chosen(&options.cases, options.quick) {
        eprintln!("\n== {}", case.name);
        match figures::row(&mut bench, case) {
            Ok(row) => rows.push(row),
            Err(error) => {
                eprintln!("{error:#}");
                failures.push(case.name);
            }
        }
    }
    if options.json {
        let rows: Vec<Value> = rows.iter().map(Row::json).collect();
        println!("{:#}", Value::from(rows));
    } else {
        print!("{machine}\n{}", table::of(&rows));
    }
    if options.write {
        write(&machine, &rows)?;
    }
    anyhow::ensure!(
        failures.is_empty(),
        "not measured: {}; see above why",
        failures.join(", ")
    );
    Ok(())
}

fn write(machine: &str, rows: &[Row]) -> Result<()> {
    let path = root().join(PAGE);
    let text = fs::read_to_string(&path).with_context(|| format!("cannot read {PAGE}"))?;
    let old = page::section(PAGE, &text, "measured: cases")?;
    let table = format!("\n{}\n", table::renewed(old, rows));
    let text = page::with_section(PAGE, &text, "measured: cases", &table)?;
    let machine = format!("\n{machine}\n");
    let text = page::with_section(PAGE, &text, "measured: machine", &machine)?;
    fs::write(&path, text).with_context(|| format!("cannot write {PAGE}"))
}

/// The command as one would type it again.
fn line_of(options: &Options) -> String {
    let mut line = "cargo xtask bench-peers".to_owned();
    for (is_given, flag) in [(options.quick, " --quick"), (options.write, " --write")] {
        if is_given {
            line.push_str(flag);
        }
    }
    for case in &options.cases {
        line.push_str(" --case ");
        line.push_str(case);
    }
    line
}
