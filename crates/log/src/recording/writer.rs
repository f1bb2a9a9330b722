//! The writer of a recording, which knows what it has written.

use mcap::records::MessageHeader;
use mcap::{McapResult, Writer};
use std::io::{Seek, Write};
use std::ops::{Deref, DerefMut};
use xxhash_rust::xxh3::Xxh3;

/// A writer that counts and sums the messages.
pub(super) struct MessageWriter<W: Write + Seek> {
    inner: Writer<W>,
    messages: u64,
    sum: Box<Xxh3>,
}

impl<W: Write + Seek> MessageWriter<W> {
    pub(super) fn new(inner: Writer<W>) -> Self {
        Self {
            inner,
            messages: 0,
            sum: Box::default(),
        }
    }

    /// Writes a message.
    pub(super) fn write_message(&mut self, header: &MessageHeader, bytes: &[u8]) -> McapResult<()> {
        self.messages += 1;
        self.sum.update(&header.log_time.to_le_bytes());
        self.sum.update(bytes);
        self.inner.write_to_known_channel(header, bytes)
    }

    /// Messages so far [-].
    pub(super) fn messages(&self) -> u64 {
        self.messages
    }

    /// Sum of their times and bytes.
    pub(super) fn sum(&self) -> u128 {
        self.sum.digest128()
    }

    pub(super) fn into_inner(self) -> W {
        self.inner.into_inner()
    }
}

impl<W: Write + Seek> Deref for MessageWriter<W> {
    type Target = Writer<W>;

    fn deref(&self) -> &Writer<W> {
        &self.inner
    }
}

impl<W: Write + Seek> DerefMut for MessageWriter<W> {
    fn deref_mut(&mut self) -> &mut Writer<W> {
        &mut self.inner
    }
}
