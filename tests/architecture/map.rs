//! The crates and the arrows between them.

use crate::sources::{entries, read, root};
use std::collections::{BTreeMap, BTreeSet};

type Names = BTreeSet<String>;

#[test]
fn the_map_lists_exactly_the_crates_there_are() {
    let listed: Names = uses().into_keys().collect();
    let there: Names = manifests().into_keys().collect();
    assert_eq!(listed, there);
}

#[test]
fn every_manifest_follows_the_arrows_of_the_map() {
    let uses = uses();
    for (name, manifest) in manifests() {
        let own: Names = dependencies(&manifest, "[dependencies]")
            .iter()
            .filter_map(|dependency| dependency.strip_prefix("pelletflow-").map(str::to_owned))
            .collect();
        assert_eq!(own, uses[&name], "dependencies of {name}");
    }
}

#[test]
fn the_arrows_of_the_map_point_down_only() {
    let uses = uses();
    let mut placed = Names::new();
    while placed.len() < uses.len() {
        let next: Vec<&String> = uses
            .iter()
            .filter(|(name, below)| !placed.contains(*name) && below.is_subset(&placed))
            .map(|(name, _)| name)
            .collect();
        assert!(!next.is_empty(), "a circle among those not in {placed:?}");
        placed.extend(next.into_iter().cloned());
    }
}

#[test]
fn the_drawing_shows_every_crate_of_the_house() {
    let page = architecture();
    let drawing = page.split("```").nth(1).expect("the map is drawn");
    let drawn: Names = drawing
        .lines()
        .flat_map(|line| line.split("  ").map(str::trim))
        .filter(|word| uses().contains_key(*word))
        .map(str::to_owned)
        .collect();
    let mut house: Names = uses().into_keys().collect();
    house.remove("pelletflow");
    house.remove("xtask");
    house.remove("fuzz");
    assert_eq!(drawn, house);
}

#[test]
fn dependencies_that_belong_to_one_place_are_named_there_alone() {
    let places = table("| dependency | only in |");
    assert!(places.contains_key("rayon"), "the table is gone");
    let manifests = manifests();
    for (dependency, allowed) in places {
        let named: Names = manifests
            .iter()
            .filter(|(_, manifest)| {
                ["[dependencies]", "[dev-dependencies]"]
                    .iter()
                    .any(|section| dependencies(manifest, section).contains(&dependency))
            })
            .map(|(name, _)| name.clone())
            .collect();
        assert_eq!(named, allowed, "crates that name {dependency}");
    }
}

/// The manifest of every crate by its name on the map, those of the root and the fuzzers among them.
pub(crate) fn manifests() -> BTreeMap<String, String> {
    let mut manifests: BTreeMap<String, String> = entries(&root().join("crates"))
        .iter()
        .filter_map(|folder| {
            let manifest = folder.join("Cargo.toml");
            let name = folder.file_name()?.to_string_lossy().into_owned();
            manifest.exists().then(|| (name, read(manifest)))
        })
        .collect();
    manifests.insert("pelletflow".into(), read(root().join("Cargo.toml")));
    manifests.insert("fuzz".into(), read(root().join("tests/fuzz/Cargo.toml")));
    manifests
}

fn architecture() -> String {
    read(root().join("ARCHITECTURE.md"))
}

/// For each crate those that it uses.
fn uses() -> BTreeMap<String, Names> {
    table("| crate | uses | promises |")
}

/// First and second column of the table under a heading: a name, and the names beside it.
fn table(heading: &str) -> BTreeMap<String, Names> {
    architecture()
        .lines()
        .skip_while(|line| *line != heading)
        .skip(2)
        .take_while(|line| line.starts_with('|'))
        .map(|row| {
            let mut cells = row.split('|').skip(1).map(names);
            let first = cells.next().and_then(|cell| cell.into_iter().next());
            let second = cells.next().expect("a row has two cells");
            (first.expect("the first cell holds a name"), second)
        })
        .collect()
}

/// The words between backticks.
fn names(cell: &str) -> Names {
    cell.split('`')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect()
}

/// Names of the packages in one section of a manifest.
fn dependencies(manifest: &str, section: &str) -> Names {
    manifest
        .lines()
        .skip_while(|line| *line != section)
        .skip(1)
        .take_while(|line| !line.starts_with('['))
        .filter(|line| !line.starts_with('#'))
        .filter_map(|line| line.split(['.', ' ', '=']).next())
        .filter(|name| !name.is_empty())
        .map(str::to_owned)
        .collect()
}
