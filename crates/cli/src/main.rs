//! The `pelletflow` binary.
fn main() {}
