//! A snapshot as bytes, to be sent to another process or kept; of the same version, like a checkpoint.

use super::file::FORMAT;
use pelletflow_sim::Snapshot;

/// Version of pelletflow that writes and reads.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Bytes that are no snapshot to go on from.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SnapshotError {
    /// Another version wrote them.
    #[error(
        "the state is of pelletflow {0}, and this is {VERSION}, which may compute otherwise; take that version, or step \
         the scene anew"
    )]
    OtherVersion(String),
    /// They are no snapshot.
    #[error("the state is damaged; step the scene anew")]
    Damaged,
}

/// A snapshot as bytes that keep every bit of its numbers.
#[expect(
    clippy::missing_panics_doc,
    reason = "the format has bytes for all that a snapshot holds"
)]
pub fn snapshot_to_bytes(snapshot: &Snapshot) -> Vec<u8> {
    postcard::to_stdvec(&(FORMAT, VERSION, snapshot))
        .expect("a snapshot is of numbers and lists, for which the format has bytes")
}

/// The snapshot that bytes hold.
///
/// # Errors
/// Another version wrote them, or they are no snapshot.
pub fn snapshot_from_bytes(bytes: &[u8]) -> Result<Snapshot, SnapshotError> {
    let ((format, version), rest) =
        postcard::take_from_bytes::<(u32, String)>(bytes).map_err(|_| SnapshotError::Damaged)?;
    if format != FORMAT || version != VERSION {
        return Err(SnapshotError::OtherVersion(version));
    }
    match postcard::take_from_bytes(rest) {
        Ok((snapshot, [])) => Ok(snapshot),
        _ => Err(SnapshotError::Damaged),
    }
}
