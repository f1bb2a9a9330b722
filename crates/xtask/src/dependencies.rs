//! Licenses, sources and known weaknesses of the crates that this one stands on.
//!
//! `deny.toml` holds the rules in the form of cargo-deny. Its rules on licenses, sources and banned crates
//! are checked here, so that the gate needs no tool beyond cargo; where cargo-deny is installed it looks
//! for known weaknesses too.

use crate::process;
use crate::workspace::{cargo, root};
use anyhow::{Context, Result, bail};
use serde_json::Value;
use spdx::{Expression, ParseMode};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::time::Duration;

/// Time that the database of advisories may take to arrive.
const FETCH_LIMIT: Duration = Duration::from_mins(1);

/// The rules of `deny.toml`.
struct Rules {
    allowed: BTreeSet<String>,
    allowed_for: BTreeMap<String, BTreeSet<String>>,
    registries: BTreeSet<String>,
    banned: BTreeSet<String>,
}

/// Checks every package of the dependency graph, of all platforms, against `deny.toml`.
pub(crate) fn check() -> Result<String> {
    let rules = Rules::read()?;
    let packages = packages()?;
    let mistakes: Vec<String> = packages
        .iter()
        .filter_map(|package| rules.mistake(package))
        .collect();
    if mistakes.is_empty() {
        return Ok(format!(
            "{} packages: licenses, sources and bans passed",
            packages.len()
        ));
    }
    bail!("deny.toml refuses:\n  {}", mistakes.join("\n  "))
}

/// Looks for known weaknesses; says so where that cannot be done here.
pub(crate) fn check_advisories() -> Result<String> {
    if !process::succeeds_within(cargo().args(["deny", "--version"]), FETCH_LIMIT) {
        return Ok("not checked, cargo-deny is not installed".to_owned());
    }
    if !process::succeeds_within(cargo().args(["deny", "fetch", "db"]), FETCH_LIMIT) {
        return Ok("not checked, database unreachable".to_owned());
    }
    process::run(cargo().args(["deny", "check", "--disable-fetch", "advisories"]))?;
    Ok("passed".to_owned())
}

struct Package {
    name: String,
    license: Option<String>,
    source: Option<String>,
}

fn packages() -> Result<Vec<Package>> {
    let output = cargo()
        .args([
            "metadata",
            "--format-version=1",
            "--all-features",
            "--locked",
        ])
        .output()
        .context("cannot start cargo")?;
    if !output.status.success() {
        bail!("{}", String::from_utf8_lossy(&output.stderr));
    }
    let metadata: Value = serde_json::from_slice(&output.stdout)?;
    let text = |package: &Value, key: &str| package[key].as_str().map(str::to_owned);
    let packages = metadata["packages"]
        .as_array()
        .context("cargo metadata lists no packages")?;
    Ok(packages
        .iter()
        .map(|package| Package {
            name: text(package, "name").unwrap_or_default(),
            license: text(package, "license"),
            source: text(package, "source"),
        })
        .collect())
}

impl Rules {
    fn read() -> Result<Self> {
        let text = fs::read_to_string(root().join("deny.toml")).context("cannot read deny.toml")?;
        let table: toml::Table = text.parse().context("deny.toml is no TOML")?;
        Self::from_table(&table)
    }

    fn from_table(table: &toml::Table) -> Result<Self> {
        let list = |section: &str, key: &str| {
            table
                .get(section)
                .and_then(|section| section.get(key))
                .and_then(toml::Value::as_array)
                .with_context(|| format!("deny.toml has no list `{section}.{key}`"))
        };
        let mut allowed_for = BTreeMap::new();
        for exception in list("licenses", "exceptions")? {
            let name = exception.get("crate").and_then(toml::Value::as_str);
            let allowed = exception.get("allow").and_then(toml::Value::as_array);
            let (name, allowed) = name
                .zip(allowed)
                .context("a license exception needs `crate` and `allow`")?;
            allowed_for.insert(name.to_owned(), strings(allowed));
        }
        let banned = list("bans", "deny")?
            .iter()
            .filter_map(|ban| ban.get("crate")?.as_str().map(str::to_owned))
            .collect();
        Ok(Self {
            allowed: strings(list("licenses", "allow")?),
            allowed_for,
            registries: strings(list("sources", "allow-registry")?),
            banned,
        })
    }

    fn mistake(&self, package: &Package) -> Option<String> {
        let Package {
            name,
            license,
            source,
        } = package;
        if self.banned.contains(name) {
            return Some(format!("{name}: banned"));
        }
        if let Some(source) = source {
            let registry = source.strip_prefix("registry+").unwrap_or(source);
            if !self.registries.contains(registry) {
                return Some(format!("{name}: comes from {source}"));
            }
        }
        let Some(license) = license else {
            return Some(format!("{name}: states no license"));
        };
        let Ok(expression) = Expression::parse_mode(license, ParseMode::LAX) else {
            return Some(format!("{name}: license `{license}` is no SPDX expression"));
        };
        let exceptions = self.allowed_for.get(name);
        let is_allowed = expression.evaluate(|requirement| {
            let license = requirement.to_string();
            self.allowed.contains(&license)
                || exceptions.is_some_and(|allowed| allowed.contains(&license))
        });
        (!is_allowed).then(|| format!("{name}: license `{license}` is not allowed"))
    }
}

fn strings(array: &[toml::Value]) -> BTreeSet<String> {
    array
        .iter()
        .filter_map(|value| value.as_str().map(str::to_owned))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rules() -> Rules {
        let table = r#"
            [licenses]
            allow = ["MIT"]
            exceptions = [{ crate = "tables", allow = ["Unicode-3.0"] }]
            [bans]
            deny = [{ crate = "leftpad" }]
            [sources]
            allow-registry = ["https://registry"]
        "#;
        Rules::from_table(&table.parse().expect("the table is TOML")).expect("it is complete")
    }

    fn mistake(name: &str, license: &str, source: &str) -> Option<String> {
        rules().mistake(&Package {
            name: name.to_owned(),
            license: Some(license.to_owned()),
            source: Some(source.to_owned()),
        })
    }

    #[test]
    fn a_choice_of_licenses_passes_when_one_is_allowed() {
        let registry = "registry+https://registry";
        assert_eq!(mistake("a", "MIT OR GPL-3.0-only", registry), None);
        assert_eq!(mistake("a", "MIT/GPL-3.0-only", registry), None);
        assert!(mistake("a", "MIT AND GPL-3.0-only", registry).is_some());
    }

    #[test]
    fn an_exception_holds_for_its_crate_alone() {
        let registry = "registry+https://registry";
        assert_eq!(mistake("tables", "MIT AND Unicode-3.0", registry), None);
        assert!(mistake("other", "MIT AND Unicode-3.0", registry).is_some());
    }

    #[test]
    fn foreign_sources_and_banned_crates_are_refused() {
        assert!(mistake("a", "MIT", "git+https://elsewhere").is_some());
        assert!(mistake("leftpad", "MIT", "registry+https://registry").is_some());
    }
}
