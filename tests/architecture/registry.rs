//! Every variant of a registry has its file, and every file its variant.

use crate::sources::{entries, read, root};
use std::collections::BTreeSet;

/// A family: the folder of its files, and the table whose lines are its rows.
struct Family {
    folder: &'static str,
    /// The file of the table, from the folder.
    table: &'static str,
    /// The line that begins the table: of an enum, or of a macro that makes one.
    registry: &'static str,
    /// Variants that share a file or name it by its subject.
    filed_under: &'static [(&'static str, &'static str)],
    /// Files that are no rows: what all rows share.
    shared: &'static [&'static str],
}

const FAMILIES: [Family; 6] = [
    Family {
        folder: "crates/core/src/shape",
        table: "mod.rs",
        registry: "pub enum Shape {",
        filed_under: &[
            ("Union", "combination"),
            ("Intersection", "combination"),
            ("Difference", "combination"),
            ("Translated", "placement"),
            ("Rotated", "placement"),
            ("Mirrored", "placement"),
            ("Scaled", "placement"),
        ],
        shared: &["mod", "contract", "flatness", "validation"],
    },
    Family {
        folder: "crates/core/src/contact/normal",
        table: "../laws.rs",
        registry: "pub enum NormalLaw {",
        filed_under: &[],
        shared: &["mod"],
    },
    Family {
        folder: "crates/core/src/contact/tangential",
        table: "../laws.rs",
        registry: "pub enum TangentialLaw {",
        filed_under: &[],
        shared: &["mod"],
    },
    Family {
        folder: "crates/core/src/contact/turning",
        table: "../laws.rs",
        registry: "pub enum TurningLaw {",
        filed_under: &[],
        shared: &["mod"],
    },
    Family {
        folder: "crates/impact/src/scatter",
        table: "mod.rs",
        registry: "pub enum Scatter {",
        filed_under: &[],
        shared: &["mod"],
    },
    Family {
        folder: "crates/sim/src/meter",
        table: "mod.rs",
        registry: "registry! {",
        filed_under: &[],
        shared: &["mod", "contract", "patch", "registry", "sample", "touch"],
    },
];

#[test]
fn every_registry_row_has_its_file_and_every_file_its_row() {
    for family in &FAMILIES {
        let folder = root().join(family.folder);
        let text = read(folder.join(family.table));
        let expected: BTreeSet<String> = variants(&text, family.registry)
            .into_iter()
            .map(|variant| family.file_of(&variant))
            .collect();
        let found: BTreeSet<String> = entries(&folder)
            .iter()
            .filter_map(|path| Some(path.file_stem()?.to_string_lossy().into_owned()))
            .filter(|file| !family.shared.contains(&file.as_str()))
            .collect();
        assert_eq!(found, expected, "files and rows of {}", family.folder);
    }
}

impl Family {
    fn file_of(&self, variant: &str) -> String {
        self.filed_under
            .iter()
            .find(|(name, _)| *name == variant)
            .map_or_else(|| snake_case(variant), |(_, file)| (*file).to_owned())
    }
}

/// Names of the variants in a table.
fn variants(text: &str, registry: &str) -> Vec<String> {
    let names: Vec<String> = text
        .lines()
        .skip_while(|line| *line != registry)
        .skip(1)
        .take_while(|line| *line != "}")
        .filter_map(|line| line.strip_prefix("    "))
        .filter(|line| line.starts_with(|first: char| first.is_ascii_uppercase()))
        .filter_map(|line| line.split([' ', '{', ',', '(']).next())
        .map(str::to_owned)
        .collect();
    assert!(!names.is_empty(), "{registry} has no variants");
    names
}

fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_ascii_uppercase() && !snake.is_empty() {
            snake.push('_');
        }
        snake.push(letter.to_ascii_lowercase());
    }
    snake
}
