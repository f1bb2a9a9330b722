//! What `ARCHITECTURE.md` says of the code is so.

mod map;
mod registry;
mod sources;
mod units;

use sources::{read, root, source_files};

/// Longest code file that is still one concept [lines].
const LONGEST_FILE: usize = 400;

/// What a file says that a program has made.
const MADE: &str = "\nMade from the schema by";

#[test]
fn no_code_file_is_longer_than_400_lines() {
    let long: Vec<String> = source_files(&["crates", "tests", "benches", "examples", "python"])
        .iter()
        .map(|path| (path, read(path)))
        // What a program has written, nobody reads from end to end.
        .filter(|(_, text)| !text.contains(MADE))
        .map(|(path, text)| (path, text.lines().count()))
        .filter(|(_, lines)| *lines > LONGEST_FILE)
        .map(|(path, lines)| format!("{} has {lines} lines", path.display()))
        .collect();
    assert!(long.is_empty(), "split them:\n{}", long.join("\n"));
}

#[test]
fn unsafe_code_is_forbidden_in_every_crate() {
    let workspace = read(root().join("Cargo.toml"));
    assert!(
        workspace.contains("[workspace.lints.rust]\nunsafe_code = \"forbid\"\n"),
        "the workspace lints no longer forbid unsafe code"
    );
    for (name, manifest) in map::manifests() {
        assert!(
            manifest.contains("\n[lints]\nworkspace = true\n"),
            "{name} does not take the lints of the workspace"
        );
    }
}
