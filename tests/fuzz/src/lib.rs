//! Everything that reads what others wrote, as functions of bytes.
//!
//! A fuzzer calls them with bytes that it makes up; the corpus keeps those that led somewhere, and those that once did
//! harm. No bytes may make a reader panic, hang or take memory without bound.

mod checkpoint;
mod file;
mod mesh;
mod plant;
mod recording;
mod seeds;
mod text;

pub use seeds::seeds;

/// A reader, as a fuzzer knows it.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// Its name; that of its folder in the corpus, too.
    pub name: &'static str,
    /// Reads bytes; whether they were taken for good.
    pub read: fn(&[u8]) -> bool,
}

/// All readers.
pub static TARGETS: [Target; 9] = [
    Target {
        name: "scene",
        read: text::scene,
    },
    Target {
        name: "quantity",
        read: text::quantity,
    },
    Target {
        name: "override",
        read: text::overrides,
    },
    Target {
        name: "card",
        read: text::card,
    },
    Target {
        name: "sheet",
        read: text::sheet,
    },
    Target {
        name: "stl",
        read: mesh::stl,
    },
    Target {
        name: "obj",
        read: mesh::obj,
    },
    Target {
        name: "recording",
        read: recording::read,
    },
    Target {
        name: "checkpoint",
        read: checkpoint::read,
    },
];

/// Hands bytes to a reader; whether they were taken for good.
///
/// # Panics
/// There is no reader of that name, or it does not keep to what it promises.
pub fn read(target: &str, bytes: &[u8]) -> bool {
    let target = TARGETS.iter().find(|known| known.name == target);
    let target = target.expect("every file of `fuzz_targets` is named as its reader");
    (target.read)(bytes)
}
