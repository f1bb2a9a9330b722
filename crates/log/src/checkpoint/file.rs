//! The file of a checkpoint.
//!
//! | bytes | |
//! | --- | --- |
//! | 8 | `PELLETCP` |
//! | 4 | version of the format, little-endian |
//! | 4 | length of the identity |
//! | … | identity: JSON, which any version can read |
//! | … | contents: postcard, which keeps every bit of a number |
//! | 16 | XXH3 of all that comes before, little-endian |

use super::{Checkpoint, Contents, Identity};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use xxhash_rust::xxh3::{Xxh3, xxh3_128};

/// First bytes of every checkpoint.
const MAGIC: &[u8; 8] = b"PELLETCP";
/// Version of the format; raised with every change of what a checkpoint holds [-].
pub(super) const FORMAT: u32 = 2;
/// Bytes before the identity [B].
const HEAD: usize = 16;
/// Bytes written at once [B].
const BLOCK: usize = 64 * 1024;
/// Bytes of the checksum [B].
const TAIL: usize = 16;

/// Why bytes are no checkpoint to go on from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Flaw {
    /// What is wrong with them.
    Damaged(&'static str),
    /// Another version of pelletflow wrote them.
    OtherVersion(String),
}

/// Writes a checkpoint and waits until the disk has it.
pub(super) fn write(path: &Path, identity: &Identity, contents: &Contents) -> io::Result<()> {
    let identity = serde_json::to_vec(identity)?;
    let summed = Summed {
        inner: File::create(path)?,
        sum: Box::default(),
        error: None,
    };
    let mut blocks = BufWriter::with_capacity(BLOCK, summed);
    blocks.write_all(MAGIC)?;
    blocks.write_all(&FORMAT.to_le_bytes())?;
    blocks.write_all(&(identity.len() as u32).to_le_bytes())?;
    blocks.write_all(&identity)?;
    if let Err(error) = postcard::to_io(contents, &mut blocks) {
        // Of a disk that is full it only tells that there is no more room.
        let (summed, _) = blocks.into_parts();
        return Err(summed.error.unwrap_or_else(|| io::Error::other(error)));
    }
    let summed = blocks
        .into_inner()
        .map_err(io::IntoInnerError::into_error)?;
    let Summed { mut inner, sum, .. } = summed;
    inner.write_all(&sum.digest128().to_le_bytes())?;
    inner.sync_all()
}

/// What bytes hold; never more memory than a few times theirs.
pub(super) fn decode(bytes: &[u8]) -> Result<Checkpoint, Flaw> {
    let (identity, contents) = parts(bytes)?;
    let identity: Identity = serde_json::from_slice(identity)
        .map_err(|_| Flaw::Damaged("it does not say of which run it is"))?;
    let format = u32::from_le_bytes(fixed(&bytes[8..12])?);
    if format != FORMAT || identity.version != env!("CARGO_PKG_VERSION") {
        return Err(Flaw::OtherVersion(identity.version));
    }
    match postcard::take_from_bytes::<Contents>(contents) {
        Ok((contents, [])) => Ok(Checkpoint { identity, contents }),
        Ok(_) => Err(Flaw::Damaged("it goes on after its end")),
        Err(_) => Err(Flaw::Damaged("its contents cannot be read")),
    }
}

/// Identity and contents of a file whose checksum is right.
fn parts(bytes: &[u8]) -> Result<(&[u8], &[u8]), Flaw> {
    if bytes.len() < HEAD + TAIL {
        return Err(Flaw::Damaged("it is too short"));
    }
    if !bytes.starts_with(MAGIC) {
        return Err(Flaw::Damaged("it does not begin as a checkpoint"));
    }
    let (body, sum) = bytes.split_at(bytes.len() - TAIL);
    if xxh3_128(body) != u128::from_le_bytes(fixed(sum)?) {
        return Err(Flaw::Damaged("its checksum is wrong"));
    }
    let length = u32::from_le_bytes(fixed(&bytes[12..HEAD])?) as usize;
    body[HEAD..]
        .split_at_checked(length)
        .ok_or(Flaw::Damaged("it is shorter than it says"))
}

fn fixed<const N: usize>(bytes: &[u8]) -> Result<[u8; N], Flaw> {
    bytes
        .try_into()
        .map_err(|_| Flaw::Damaged("it is too short"))
}

/// A writer that sums what it writes, and remembers what went wrong.
struct Summed<W> {
    inner: W,
    sum: Box<Xxh3>,
    error: Option<io::Error>,
}

impl<W: Write> Write for Summed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.inner.write(bytes) {
            Ok(written) => {
                self.sum.update(&bytes[..written]);
                Ok(written)
            }
            Err(error) => {
                let kind = error.kind();
                self.error = Some(error);
                Err(kind.into())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}
