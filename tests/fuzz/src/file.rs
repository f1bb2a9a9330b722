//! Files for readers that take a path.

use std::fs;
use tempfile::TempDir;

/// A folder of its own with files in it; gone when it is dropped.
pub(crate) fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let folder = TempDir::new().expect("a folder can be made where temporary files go");
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).expect("its files can be written");
    }
    folder
}
