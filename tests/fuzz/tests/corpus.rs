//! Every file of the corpus, read again: what once did harm does none, and what was good is.

use pelletflow_fuzz::TARGETS;
use std::fs;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

/// How the names of files begin that readers take for good.
const GOOD: &str = "good";

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus")
}

fn names(folder: &Path) -> Vec<String> {
    let entries =
        fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut names: Vec<String> = entries
        .map(|entry| {
            entry
                .expect("a folder that opens can be listed")
                .file_name()
        })
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn no_file_of_the_corpus_does_harm_and_the_good_ones_are_good() {
    for target in &TARGETS {
        let folder = corpus().join(target.name);
        let names = names(&folder);
        assert!(
            names.iter().any(|name| name.starts_with(GOOD)),
            "{}",
            target.name
        );
        for name in names {
            let bytes = fs::read(folder.join(&name)).expect("what is listed can be read");
            let is_good = catch_unwind(|| (target.read)(&bytes));
            assert!(is_good.is_ok(), "{}/{name} does harm", target.name);
            if name.starts_with(GOOD) {
                assert!(is_good.is_ok_and(|is| is), "{}/{name}", target.name);
            }
        }
    }
}

#[test]
fn every_folder_of_the_corpus_and_every_fuzzer_is_of_a_reader() {
    let mut targets: Vec<&str> = TARGETS.iter().map(|target| target.name).collect();
    targets.sort_unstable();
    assert_eq!(names(&corpus()), targets);
    let fuzzers = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz_targets");
    let fuzzers = names(&fuzzers);
    let fuzzers: Vec<&str> = fuzzers
        .iter()
        .filter_map(|name| name.strip_suffix(".rs"))
        .collect();
    assert_eq!(fuzzers, targets);
}
