//! `cargo xtask stress`: hard cases over a range of steps, runs of a million steps, and the bits of a release build.

use crate::page;
use crate::process;
use crate::report::Report;
use crate::verify;
use crate::workspace::{cargo, root};
use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;

/// The page and the picture, from the root.
const PAGE: &str = "docs/verification.md";
const PICTURE: &str = "docs/images/where-the-step-breaks.svg";
/// The part of the page that the sweep writes.
const SECTION: &str = "stress: breaks";

/// What is asked for.
#[derive(Debug, clap::Args)]
pub(crate) struct Options {
    /// Prints the table as JSON, too.
    #[arg(long)]
    json: bool,
}

/// What the tests told.
#[derive(Debug, Default)]
struct Told {
    cases: Vec<Value>,
    pictures: Vec<String>,
    bits: Vec<String>,
    claims: Vec<verify::Claim>,
}

/// Where a case of the sweep broke.
#[derive(Debug, Deserialize)]
struct Row {
    case: String,
    rayleigh_time_s: f64,
    contact_time_s: f64,
    default_step_s: f64,
    broken_step_s: Option<f64>,
    what: Option<String>,
}

/// Runs the suite, and writes its tables and its picture.
pub(crate) fn run(report: &mut Report, options: &Options) -> Result<()> {
    let mut told = Told::default();
    report.part("cases", || {
        told = tests(&["--release"], &["--include-ignored"])?;
        Ok(format!("{} in release", told.cases.len()))
    })?;
    report.part("bits", || {
        let debug = tests(&[], &["same_bits_of_every_case"])?.bits;
        ensure!(!debug.is_empty(), "no test of tests/stability tells its bits");
        ensure!(
            debug == told.bits,
            "development and release builds differ: {debug:?} and {:?}; look for arithmetic that a compiler may reorder",
            told.bits
        );
        Ok(format!("{} alike in both builds", debug.len()))
    })?;
    report.part("page", || {
        let path = root().join(PAGE);
        let text = fs::read_to_string(&path).with_context(|| format!("cannot read {PAGE}"))?;
        let text = page::with_section(PAGE, &text, SECTION, &table(&told.cases)?)?;
        let text = verify::with_tables(&text, &told.claims)?;
        fs::write(&path, text).with_context(|| format!("cannot write {PAGE}"))?;
        for picture in &told.pictures {
            fs::copy(picture, root().join(PICTURE))
                .with_context(|| format!("cannot copy {picture} to {PICTURE}"))?;
        }
        Ok(format!("{PAGE} written"))
    })?;
    if options.json {
        println!("{}", serde_json::to_string_pretty(&told.cases)?);
    }
    Ok(())
}

/// Runs tests of the suite, and gives what they told.
fn tests(profile: &[&str], asked: &[&str]) -> Result<Told> {
    let mut told = Told::default();
    process::run_watched(
        cargo()
            .arg("test")
            .args(profile)
            .args(["--package", "pelletflow", "--test", "stability", "--"])
            .args(asked)
            .args(["--nocapture", "--test-threads", "1"]),
        |line| {
            println!("{line}");
            told.enter(line);
        },
    )?;
    Ok(told)
}

impl Told {
    fn enter(&mut self, line: &str) {
        // The harness puts the name of a test before its first line.
        let after = |mark: &str| line.split_once(mark).map(|(_, told)| told);
        if let Some(case) = after("broke\t").and_then(|told| serde_json::from_str(told).ok()) {
            self.cases.push(case);
        }
        self.pictures.extend(after("picture\t").map(str::to_owned));
        self.bits.extend(after("bits\t").map(str::to_owned));
        self.claims.extend(verify::parsed(line));
    }
}

fn table(cases: &[Value]) -> Result<String> {
    let mut table = String::from(
        "\n| case | default step [µs] | of the Rayleigh time | of Hertz' contact time | breaks at | of the Rayleigh time | of Hertz' contact time | by |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for case in cases {
        let Row {
            case,
            rayleigh_time_s: rayleigh,
            contact_time_s: contact,
            default_step_s: step,
            broken_step_s: broken,
            what,
        } = serde_json::from_value(case.clone()).context("a case of the sweep cannot be read")?;
        let beyond = match (broken, what) {
            (Some(broken), Some(what)) => format!(
                "{:.1} × | {:.2} | {:.2} | {what}",
                broken / step,
                broken / rayleigh,
                broken / contact
            ),
            _ => "nowhere up to 32 × | | |".into(),
        };
        writeln!(
            table,
            "| {case} | {:.2} | {:.2} | {:.3} | {beyond} |",
            1.0e6 * step,
            step / rayleigh,
            step / contact
        )
        .expect("a string takes any text");
    }
    table.push('\n');
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_test_tells_is_read_wherever_it_stands_in_a_line() {
        let mut told = Told::default();
        told.enter(r#"test sweep ... broke	{"case": "gas", "rayleigh_time_s": 2e-4, "contact_time_s": 5e-4, "default_step_s": 4e-5, "broken_step_s": 8e-5, "what": "energy"}"#);
        told.enter("bits\tgas\t01ab");
        told.enter("test another ... ok");
        assert_eq!(told.bits, ["gas\t01ab"]);
        let table = table(&told.cases).expect("it has all it needs");
        assert!(
            table.contains("| gas | 40.00 | 0.20 | 0.080 | 2.0 × | 0.40 | 0.16 | energy |"),
            "{table}"
        );
    }
}
