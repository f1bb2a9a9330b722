//! Files of the corpus with a few changes, as many as there is time for, do no harm: in seconds, and without knowing where
//! they lead, what `cargo xtask fuzz` does for hours.

use pelletflow_fuzz::{TARGETS, Target};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::TestRunner;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::time::{Duration, Instant};

/// Time for each reader.
const SPAN: Duration = Duration::from_secs(4);
/// Files that are read between two looks at the clock [-].
const CASES: u32 = 16;
/// Changes of a file at most [-].
const CHANGES: usize = 6;
/// Bytes of a change at most [B].
const LONGEST: usize = 64;
/// Numbers that readers trip over: lengths, counts and exponents at their ends.
const NUMBERS: [u64; 8] = [
    0,
    1,
    0x7f,
    0x7fff_ffff,
    0xffff_ffff,
    0x7ff8_0000_0000_0000,
    0x7fff_ffff_ffff_ffff,
    u64::MAX,
];

/// Letters that mean something in files of text.
const WORDS: &[u8] = b"0123456789-+.eE \n\"[]{}=,/#";

/// A change of some bytes.
#[derive(Debug, Clone)]
enum Change {
    /// One bit is another.
    Flip { at: Index, bit: u8 },
    /// Other bytes stand in their place.
    Write { at: Index, bytes: Vec<u8> },
    /// Some are gone.
    Cut { at: Index, length: usize },
    /// Some stand elsewhere again.
    Repeat {
        from: Index,
        to: Index,
        length: usize,
    },
    /// All that follows is gone.
    End { at: Index },
}

fn change() -> impl Strategy<Value = Change> {
    let number = (select(&NUMBERS[..]), select(&[1, 2, 4, 8][..]))
        .prop_map(|(number, length)| number.to_le_bytes()[..length].to_vec());
    let bytes = prop_oneof![number, vec(any::<u8>(), 1..8), vec(select(WORDS), 1..8)];
    let index = any::<Index>;
    prop_oneof![
        (index(), 0..8_u8).prop_map(|(at, bit)| Change::Flip { at, bit }),
        (index(), bytes).prop_map(|(at, bytes)| Change::Write { at, bytes }),
        (index(), 1..LONGEST).prop_map(|(at, length)| Change::Cut { at, length }),
        (index(), index(), 1..LONGEST).prop_map(|(from, to, length)| Change::Repeat {
            from,
            to,
            length
        }),
        index().prop_map(|at| Change::End { at }),
    ]
}

impl Change {
    fn apply(&self, file: &mut Vec<u8>) {
        if file.is_empty() {
            return;
        }
        let size = file.len();
        let range = |at: &Index, length: usize| -> Range<usize> {
            let from = at.index(size);
            from..(from + length).min(size)
        };
        match self {
            Self::Flip { at, bit } => file[at.index(size)] ^= 1 << bit,
            Self::Write { at, bytes } => {
                drop(file.splice(range(at, bytes.len()), bytes.iter().copied()));
            }
            Self::Cut { at, length } => drop(file.drain(range(at, *length))),
            Self::Repeat { from, to, length } => {
                let again = file[range(from, *length)].to_vec();
                let to = to.index(size);
                drop(file.splice(to..to, again));
            }
            Self::End { at } => file.truncate(at.index(size)),
        }
    }
}

fn corpus(target: &Target) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("corpus")
        .join(target.name);
    let entries = fs::read_dir(folder).expect("every reader has a folder");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("a folder that opens can be listed").path())
        .collect();
    paths.sort();
    let read = |path| fs::read(path).expect("what is listed can be read");
    paths.into_iter().map(read).collect()
}

#[test]
fn changed_files_of_the_corpus_do_no_harm() {
    for target in &TARGETS {
        let files = corpus(target);
        let changed = (any::<Index>(), vec(change(), 1..CHANGES));
        let config = ProptestConfig {
            cases: CASES,
            failure_persistence: None,
            ..ProptestConfig::default()
        };
        let mut runner = TestRunner::new(config);
        let began = Instant::now();
        while began.elapsed() < SPAN {
            let told = runner.run(&changed, |(index, changes)| {
                let mut file = index.get(&files).clone();
                for change in &changes {
                    change.apply(&mut file);
                }
                // Whether it is taken for good is up to the change: it must end, and without a panic.
                let _ = (target.read)(&file);
                Ok(())
            });
            if let Err(harm) = told {
                panic!("{}: {harm}", target.name);
            }
        }
    }
}
