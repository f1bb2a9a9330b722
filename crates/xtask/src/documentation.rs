//! The documentation builds, and its links lead somewhere.
//!
//! A unit in brackets, as in `[m]`, looks like a link to rustdoc. The workspace therefore silences broken
//! links; here they are heard again, and units are told from the rest.

use crate::process;
use crate::workspace::cargo;
use anyhow::{Result, ensure};
use serde_json::Value;

/// Units that could be the name of an item; all others hold a sign that no name has.
const UNITS: [&str; 11] = ["m", "s", "N", "kg", "J", "Pa", "W", "B", "Hz", "rad", "px"];

/// Builds the documentation of every crate without a warning.
pub(crate) fn check() -> Result<String> {
    let mut warnings = Vec::new();
    process::run_watched(
        cargo()
            .args(["doc", "--workspace", "--no-deps", "--message-format=json"])
            .env(
                "RUSTDOCFLAGS",
                "-D warnings --force-warn rustdoc::broken_intra_doc_links",
            ),
        |line| warnings.extend(warning(line)),
    )?;
    for warning in &warnings {
        print!("{warning}");
    }
    ensure!(warnings.is_empty(), "{} links are broken", warnings.len());
    Ok("passed".to_owned())
}

/// The warning that one line of cargo's messages holds, as it is to be printed; none for a unit.
fn warning(line: &str) -> Option<String> {
    let line: Value = serde_json::from_str(line).ok()?;
    let message = line.get("message")?;
    let text = message.get("message")?.as_str()?;
    let is_unit = UNITS
        .iter()
        .any(|unit| text == format!("unresolved link to `{unit}`"));
    if is_unit || text.ends_with("warnings emitted") || text.ends_with("warning emitted") {
        return None;
    }
    message.get("rendered")?.as_str().map(str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_no_broken_link() {
        let line = |text: &str| {
            serde_json::json!({ "message": { "message": text, "rendered": "shown" } }).to_string()
        };
        assert_eq!(warning(&line("unresolved link to `kg`")), None);
        assert_eq!(
            warning(&line("unresolved link to `Shapes`")),
            Some("shown".to_owned())
        );
        assert_eq!(warning(r#"{ "reason": "build-finished" }"#), None);
    }
}
