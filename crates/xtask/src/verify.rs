//! `cargo xtask verify`: every claim held against what is known, gathered into `docs/verification.md`.

use crate::page;
use crate::process;
use crate::report::Report;
use crate::workspace::{cargo, root};
use anyhow::{Context, Result, ensure};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::ops::RangeInclusive;

/// Test files that tell what they hold.
pub(crate) const TESTS: [&str; 13] = [
    "impact",
    "chung_ooi",
    "oblique",
    "restitution",
    "rolling",
    "gas",
    "stacking",
    "discharge",
    "walls",
    "meshes",
    "baked_meshes",
    "meters",
    "incline",
];
/// Figures of the paper that are drawn anew.
const FIGURES: RangeInclusive<u32> = 2..=9;
/// The page, from the root.
const PAGE: &str = "docs/verification.md";

/// A claim, how far off it is, the bound it is held to, and by what.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Claim {
    section: String,
    what: String,
    error: f64,
    bound: f64,
    source: String,
}

/// Runs the verification, or that of some test files, and writes its tables and pictures.
pub(crate) fn run(report: &mut Report, tests: &[String]) -> Result<()> {
    if tests.is_empty() {
        report.part("pictures", draw)?;
    }
    let mut claims = Vec::new();
    report.part("claims", || {
        let asked = |test: &&str| tests.is_empty() || tests.iter().any(|asked| asked == test);
        for test in TESTS.into_iter().filter(asked) {
            claims.extend(claims_of(test)?);
        }
        Ok(format!("{} held", claims.len()))
    })?;
    report.part("page", || {
        let path = root().join(PAGE);
        let page = fs::read_to_string(&path).with_context(|| format!("cannot read {PAGE}"))?;
        fs::write(&path, with_tables(&page, &claims)?)
            .with_context(|| format!("cannot write {PAGE}"))?;
        Ok(format!("{PAGE} written"))
    })
}

fn draw() -> Result<String> {
    let images = root().join("docs/images");
    for figure in FIGURES {
        process::run(
            cargo()
                .args(["run", "--release", "--", "impact", "--figure"])
                .arg(figure.to_string())
                .arg("--plot")
                .arg(images.join(format!("impact-figure-{figure}.svg"))),
        )?;
    }
    process::run(
        cargo()
            .args(["run", "--release", "--example", "oblique_hits", "--"])
            .arg(images.join("oblique-hits.svg")),
    )?;
    Ok(format!("{} drawn", FIGURES.count() + 1))
}

/// What a test file holds, the slow tests too.
fn claims_of(test: &str) -> Result<Vec<Claim>> {
    let mut claims = Vec::new();
    process::run_watched(
        cargo()
            .args(["test", "--release", "--package", "pelletflow", "--test"])
            .args([test, "--", "--include-ignored", "--nocapture"])
            .args(["--test-threads", "1"]),
        |line| {
            println!("{line}");
            claims.extend(parsed(line));
        },
    )?;
    ensure!(!claims.is_empty(), "tests/{test}.rs tells no claim");
    Ok(claims)
}

/// A claim from the line that a test printed of it.
pub(crate) fn parsed(line: &str) -> Option<Claim> {
    // The harness puts the name of a test before its first line.
    let (_, told) = line.split_once("held\t")?;
    let mut fields = told.split('\t');
    Some(Claim {
        section: fields.next()?.to_owned(),
        what: fields.next()?.to_owned(),
        error: fields.next()?.parse().ok()?,
        bound: fields.next()?.parse().ok()?,
        source: fields.next()?.to_owned(),
    })
}

/// The page with the table of each section between its marks.
pub(crate) fn with_tables(page: &str, claims: &[Claim]) -> Result<String> {
    let mut sections: BTreeMap<&str, Vec<&Claim>> = BTreeMap::new();
    for claim in claims {
        sections.entry(&claim.section).or_default().push(claim);
    }
    let mut page = page.to_owned();
    for (section, mut claims) in sections {
        claims.sort_by(|a, b| a.what.cmp(&b.what));
        page = page::with_section(PAGE, &page, &format!("held: {section}"), &table(&claims))?;
    }
    Ok(page)
}

fn table(claims: &[&Claim]) -> String {
    let mut table =
        String::from("\n| claim | off by | held to | against |\n| --- | --- | --- | --- |\n");
    for claim in claims {
        let Claim {
            what,
            error,
            bound,
            source,
            ..
        } = claim;
        writeln!(table, "| {what} | {error:.1e} | {bound:.1e} | {source} |")
            .expect("a string takes any text");
    }
    table.push('\n');
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_is_read_wherever_it_stands_in_a_line() {
        let line = "test a_ball ... held\trolling\t5/7\t-8.97e-5\t1e-3\tmechanics";
        let claim = parsed(line).expect("a claim");
        assert_eq!(
            (claim.section.as_str(), claim.what.as_str()),
            ("rolling", "5/7")
        );
        assert_eq!((claim.error, claim.bound), (-8.97e-5, 1.0e-3));
        assert_eq!(parsed("test a_ball ... ok"), None);
    }

    #[test]
    fn a_table_replaces_what_stood_between_its_marks() {
        let claim = parsed("held\trolling\t5/7\t1e-4\t1e-3\tmechanics").expect("a claim");
        let page = "before\n<!-- held: rolling -->\nold\n<!-- end -->\nafter\n";
        let page = with_tables(page, std::slice::from_ref(&claim)).expect("the marks are there");
        assert!(
            page.contains("| 5/7 | 1.0e-4 | 1.0e-3 | mechanics |"),
            "{page}"
        );
        assert!(
            !page.contains("old") && page.ends_with("<!-- end -->\nafter\n"),
            "{page}"
        );
        assert!(with_tables("no marks", &[claim]).is_err());
    }
}
