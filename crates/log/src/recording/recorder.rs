//! The thread that writes a recording while the run goes on.
//!
//! A frame is copied into one of [`FRAMES`] buffers, handed over, written, and handed back.
//! Where none is free the run waits: a slow disk slows it, and never grows it.

use super::{Frame, Recording};
use crate::checkpoint::Save;
use crate::message::event::Gravity;
use mcap::McapResult;
use pelletflow_sim::{Hit, HitClass, HitClassKey, MeterReading};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{self, Seek, Write};
use std::panic;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{Builder, Scope, ScopedJoinHandle};
use std::time::{Duration, Instant};

/// Frames in memory at once [-]: one is written, one waits, one is filled.
pub(crate) const FRAMES: usize = 3;
/// Entries that wait at most [-]; all but frames are small.
const QUEUE: usize = 64;

/// What is written next.
#[derive(Debug)]
pub(crate) enum Entry {
    /// Where everything is.
    Frame(Box<Frame>),
    /// Which walls are there from a time on [s].
    Walls { time: f64, is_present: Vec<bool> },
    /// What the meters read at a time [s].
    Meters {
        time: f64,
        readings: Vec<MeterReading>,
    },
    /// Hits that have ended, told at a time [s].
    Hits { time: f64, hits: Vec<Hit> },
    /// The sketch of all hits at a time [s].
    HitClasses {
        time: f64,
        classes: BTreeMap<HitClassKey, HitClass>,
    },
    /// New ones among the hardest hits up to a time [s], and all of these, the hardest first.
    WorstHits {
        time: f64,
        entered: Vec<Hit>,
        worst: Vec<Hit>,
    },
    /// What happened at a time [s].
    Event {
        time: f64,
        gravity: Gravity,
        text: String,
    },
    /// A file cut off from now on is to be whole up to here.
    Flush,
    /// The run as it is now, to be written beside the recording once the disk holds that up to here.
    Checkpoint(Box<Save>),
}

/// The thread takes nothing any more; [`Recorder::finish`] tells why.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stopped;

/// What recording took so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub(crate) struct RecordingTimes {
    /// The run copied what is recorded.
    pub(crate) copying: Duration,
    /// The run waited for the thread.
    pub(crate) waiting: Duration,
    /// The thread encoded, compressed and wrote, while the run went on.
    pub(crate) writing: Duration,
}

impl RecordingTimes {
    /// What two parts of a run took together.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            copying: self.copying + other.copying,
            waiting: self.waiting + other.waiting,
            writing: self.writing + other.writing,
        }
    }
}

/// A recording that a thread of its own writes.
pub(crate) struct Recorder<'scope, W> {
    entries: SyncSender<Entry>,
    blanks: Receiver<Box<Frame>>,
    thread: ScopedJoinHandle<'scope, (McapResult<W>, Duration)>,
    waiting: Duration,
}

impl<'scope, W: Write + Seek + Send + 'scope> Recorder<'scope, W> {
    /// Starts the thread; the scope ends no sooner than the recording is finished, even if the run panics.
    pub(crate) fn start(
        scope: &'scope Scope<'scope, '_>,
        recording: Recording<W>,
    ) -> io::Result<Self> {
        let (entries, entries_to_write) = sync_channel(QUEUE);
        let (blanks_to_fill, blanks) = sync_channel(FRAMES);
        for _ in 0..FRAMES {
            blanks_to_fill
                .send(Box::default())
                .expect("the receiver is above, and the channel holds them all");
        }
        let thread = Builder::new()
            .name("recording".into())
            .spawn_scoped(scope, move || {
                write(recording, entries_to_write, &blanks_to_fill)
            })?;
        Ok(Self {
            entries,
            blanks,
            thread,
            waiting: Duration::ZERO,
        })
    }
}

impl<W> Recorder<'_, W> {
    /// A frame to be filled and put down; waits until one is free.
    pub(crate) fn blank(&mut self) -> Result<Box<Frame>, Stopped> {
        let began = Instant::now();
        let blank = self.blanks.recv().map_err(|_| Stopped);
        self.waiting += began.elapsed();
        blank
    }

    /// Hands an entry over; waits until there is room for it.
    pub(crate) fn put(&mut self, entry: Entry) -> Result<(), Stopped> {
        let began = Instant::now();
        let taken = self.entries.send(entry).map_err(|_| Stopped);
        self.waiting += began.elapsed();
        taken
    }

    /// How long the run has waited so far.
    pub(crate) fn waiting(&self) -> Duration {
        self.waiting
    }

    /// Waits until all is written and the recording has its index and end mark;
    /// how long the thread worked, and the error that stopped it, if one did.
    ///
    /// A panic of the thread goes on here.
    pub(crate) fn finish(self) -> (McapResult<W>, Duration) {
        drop(self.entries);
        let joined = self.thread.join();
        joined.unwrap_or_else(|panicked| panic::resume_unwind(panicked))
    }
}

/// Writes entries until no more can come or one cannot be written; the time that this took.
fn write<W: Write + Seek>(
    mut recording: Recording<W>,
    entries: Receiver<Entry>,
    blanks: &SyncSender<Box<Frame>>,
) -> (McapResult<W>, Duration) {
    let mut writing = Duration::ZERO;
    let mut written = Ok(());
    for entry in entries {
        let began = Instant::now();
        written = put_down(&mut recording, entry, blanks, writing);
        writing += began.elapsed();
        if written.is_err() {
            break;
        }
    }
    let began = Instant::now();
    let finished = written.and_then(|()| recording.finish());
    (finished, writing + began.elapsed())
}

fn put_down<W: Write + Seek>(
    recording: &mut Recording<W>,
    entry: Entry,
    blanks: &SyncSender<Box<Frame>>,
    writing: Duration,
) -> McapResult<()> {
    match entry {
        Entry::Frame(mut frame) => {
            frame.sort();
            recording.frame(&frame)?;
            // At the end of a run nobody waits for it.
            let _ = blanks.send(frame);
            Ok(())
        }
        Entry::Walls { time, is_present } => recording.walls(time, &is_present),
        Entry::Meters { time, readings } => recording.meters(time, &readings),
        Entry::Hits { time, hits } => recording.hits(time, &hits),
        Entry::HitClasses { time, classes } => recording.hit_classes(time, &classes),
        Entry::WorstHits {
            time,
            entered,
            worst,
        } => recording.worst_hits(time, &entered, &worst),
        Entry::Event {
            time,
            gravity,
            text,
        } => recording.event(time, gravity, &text),
        Entry::Flush => recording.flush(),
        Entry::Checkpoint(save) => {
            recording.flush()?;
            Ok(save.write(recording.mark(), writing)?)
        }
    }
}

#[cfg(test)]
mod tests;
