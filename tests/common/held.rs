//! Claims held against what is known, and told to whoever gathers them.

/// Asserts that an error is within a bound, and prints one line of the table in `docs/verification.md`.
///
/// `cargo xtask verify` gathers these lines by section; they name the claim, the error found, the bound, and the source of
/// what is right. A relative error is given as a share.
#[allow(
    clippy::print_stdout,
    reason = "what a test found is told on its standard output"
)]
pub(crate) fn held(section: &str, claim: &str, error: f64, bound: f64, source: &str) {
    println!("held\t{section}\t{claim}\t{error:e}\t{bound:e}\t{source}");
    assert!(
        error.abs() <= bound,
        "{claim}: off by {error:.3e}, held to {bound:.1e} by {source}"
    );
}
