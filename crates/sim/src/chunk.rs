//! Chunks: runs of pellets stored together, advanced by one thread at a time.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::ops::Range;

/// Chunks to aim for: enough to keep several threads busy, few enough to keep cross-chunk pairs rare [-].
const CHUNKS: usize = 12;
/// A chunk's pellets fill a level-2 cache beyond this [-].
const LARGEST: usize = 2048;
/// A smaller chunk is more border than bulk [-].
const SMALLEST: usize = 128;

/// Pellets per chunk. It follows from the count alone, because the order of summation follows from it:
/// the bits must not depend on the thread count.
pub(crate) fn size(pellets: usize) -> usize {
    pellets
        .div_ceil(CHUNKS)
        .next_multiple_of(64)
        .clamp(SMALLEST, LARGEST)
}

/// The ranges of pellets of all chunks.
pub(crate) fn ranges(pellets: usize) -> impl ExactSizeIterator<Item = Range<usize>> {
    let size = size(pellets);
    (0..pellets.div_ceil(size)).map(move |chunk| chunk * size..((chunk + 1) * size).min(pellets))
}

/// Runs one piece of work per chunk, in parallel where that pays, and gives the results in chunk order.
pub(crate) fn map<W: Send, R: Send>(
    is_parallel: bool,
    work: Vec<W>,
    run: impl Fn(W) -> R + Sync + Send,
) -> Vec<R> {
    if is_parallel && work.len() > 1 {
        work.into_par_iter().map(run).collect()
    } else {
        work.into_iter().map(run).collect()
    }
}

/// Runs one piece of work per chunk, in parallel where that pays.
pub(crate) fn for_each<W: Send>(
    is_parallel: bool,
    work: impl ExactSizeIterator<Item = W>,
    run: impl Fn(W) + Sync + Send,
) {
    if is_parallel && work.len() > 1 {
        let work: Vec<W> = work.collect();
        work.into_par_iter().for_each(run);
    } else {
        work.for_each(run);
    }
}
