//! Frames of a recording, as many of them and as much of each as memory may hold.

use crate::frames::PelletRecord;
use crate::walls::WallPlace;

/// Frames that are more than a replay needs, as it moves pellets evenly from one to the next [-].
const MANY_FRAMES: usize = 120;
/// Pellets in a frame that are few enough to keep each [-].
const FEW_PELLETS: usize = 10_000;

/// Frames at most, even of no pellets [-].
const MOST_FRAMES: usize = 4096;

/// Pellets and walls at one time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ReplayFrame {
    /// Simulated time [s].
    pub(super) time: f64,
    /// Pellets, sorted by their number.
    pub(super) pellets: Vec<PelletRecord>,
    pub(super) walls: Vec<WallPlace>,
}

/// Frames that are kept, thinned when they have become too many.
#[derive(Debug, Clone)]
pub(super) struct FrameStore {
    frames: Vec<ReplayFrame>,
    /// The newest frame, if it is none of those kept: a replay ends where the run ended.
    last: Option<ReplayFrame>,
    /// Pellets times frames at most [-].
    capacity: usize,
    /// One frame of so many is kept [-].
    every: usize,
    /// How often the pellets were halved [-].
    halvings: u32,
    seen: usize,
    most_pellets: usize,
}

impl FrameStore {
    /// Room for so many pellets times frames [-].
    pub(super) fn new(capacity: usize) -> Self {
        Self {
            frames: Vec::new(),
            last: None,
            capacity,
            every: 1,
            halvings: 0,
            seen: 0,
            most_pellets: 0,
        }
    }

    /// Takes the next frame.
    pub(super) fn push(&mut self, mut frame: ReplayFrame) {
        self.most_pellets = self.most_pellets.max(frame.pellets.len());
        self.keep_share(&mut frame);
        if self.seen.is_multiple_of(self.every) {
            self.frames.push(frame);
            self.last = None;
        } else {
            self.last = Some(frame);
        }
        self.seen += 1;
        while self.is_too_much() && self.thin() {}
    }

    /// Lets go of every second frame or of half the pellets; whether there was something to let go of.
    pub(super) fn thin(&mut self) -> bool {
        let mean = self.held() / self.frames.len().max(1);
        if self.frames.len() > MANY_FRAMES || (mean <= FEW_PELLETS && self.frames.len() > 1) {
            self.every *= 2;
            let mut index = 0;
            let newest = self.frames.last().cloned();
            self.frames.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            if self.last.is_none() && self.frames.last() != newest.as_ref() {
                self.last = newest;
            }
            true
        } else if mean > 0 && self.halvings < u32::BITS {
            self.halvings += 1;
            let halvings = self.halvings;
            for frame in self.frames.iter_mut().chain(&mut self.last) {
                frame.pellets.retain(|pellet| is_kept(pellet.id, halvings));
            }
            true
        } else {
            false
        }
    }

    /// The frames that are kept, the newest among them.
    pub(super) fn frames(&self) -> impl Iterator<Item = &ReplayFrame> {
        self.frames.iter().chain(&self.last)
    }

    /// What was left out, in words; nothing where all is here.
    pub(super) fn omissions(&self) -> Vec<String> {
        let mut omissions = Vec::new();
        if self.every > 1 {
            omissions.push(format!(
                "every {} frame of {}; in between pellets move evenly",
                ordinal(self.every),
                crate::figures::count(self.seen as u64)
            ));
        }
        if self.halvings > 0 {
            let most = self.frames().map(|frame| frame.pellets.len()).max();
            omissions.push(format!(
                "{} of {} pellets, chosen at random",
                crate::figures::count(most.unwrap_or(0) as u64),
                crate::figures::count(self.most_pellets as u64)
            ));
        }
        omissions
    }

    /// Frames of the recording [-].
    pub(super) fn seen(&self) -> usize {
        self.seen
    }

    /// Most pellets of any frame of the recording [-].
    pub(super) fn most_pellets(&self) -> usize {
        self.most_pellets
    }

    fn is_too_much(&self) -> bool {
        self.held() > self.capacity || self.frames.len() > MOST_FRAMES
    }

    /// Pellets times frames [-].
    fn held(&self) -> usize {
        self.frames.iter().map(|frame| frame.pellets.len()).sum()
    }

    fn keep_share(&self, frame: &mut ReplayFrame) {
        let halvings = self.halvings;
        if halvings > 0 {
            frame.pellets.retain(|pellet| is_kept(pellet.id, halvings));
        }
    }
}

/// Whether a pellet is among those left after so many halvings: the same ones in each frame, from everywhere.
fn is_kept(id: u32, halvings: u32) -> bool {
    // Knuth's multiplicative hash: neighbors in number are neighbors in the bed, and must not stay or go together.
    let scattered = id.wrapping_mul(0x9E37_79B1);
    scattered.leading_zeros() >= halvings
}

fn ordinal(number: usize) -> String {
    match number {
        2 => "2nd".into(),
        32 => "32nd".into(),
        _ => format!("{number}th"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(time: u32, pellets: u32) -> ReplayFrame {
        ReplayFrame {
            time: f64::from(time),
            pellets: (0..pellets)
                .map(|id| PelletRecord {
                    id,
                    position: [0.0; 3],
                    radius: 0.01,
                    speed: 0.0,
                    force: 0.0,
                })
                .collect(),
            walls: Vec::new(),
        }
    }

    fn stored(capacity: usize, frames: u32, pellets: u32) -> FrameStore {
        let mut store = FrameStore::new(capacity);
        for time in 0..frames {
            store.push(frame(time, pellets));
        }
        store
    }

    #[test]
    fn what_fits_is_kept_whole() {
        let store = stored(1000, 10, 100);
        assert_eq!(store.frames().count(), 10);
        assert!(store.omissions().is_empty());
    }

    #[test]
    fn memory_is_bounded_and_first_and_last_frame_stay() {
        for (frames, pellets) in [(1000, 50), (37, 40_000), (700, 20_000)] {
            let store = stored(200_000, frames, pellets);
            let held: usize = store.frames().map(|frame| frame.pellets.len()).sum();
            // The newest frame comes on top.
            assert!(held <= 200_000 + pellets as usize, "{frames} {pellets}");
            assert!(held > 50_000.min(frames as usize * pellets as usize / 2));
            let times: Vec<f64> = store.frames().map(|frame| frame.time).collect();
            assert_eq!(times[0], 0.0);
            assert_eq!(times[times.len() - 1], f64::from(frames - 1));
            assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }

    #[test]
    fn what_is_left_out_is_said() {
        let store = stored(100_000, 1000, 1000);
        assert_eq!(
            store.omissions(),
            ["every 16th frame of 1,000; in between pellets move evenly"]
        );
        let store = stored(200_000, 40, 40_000);
        let omissions = store.omissions();
        assert_eq!(
            omissions[0],
            "every 2nd frame of 40; in between pellets move evenly"
        );
        assert!(omissions[1].contains(" of 40,000 pellets"), "{omissions:?}");
    }

    #[test]
    fn halving_takes_about_half_and_the_same_in_each_frame() {
        let kept = |halvings| (0..10_000).filter(|&id| is_kept(id, halvings)).count();
        // The hash spreads a run of numbers evenly.
        assert!((kept(1) as f64 / 5000.0 - 1.0).abs() < 0.02);
        assert!((kept(3) as f64 / 1250.0 - 1.0).abs() < 0.02);
        assert!((0..10_000).all(|id| !is_kept(id, 3) || is_kept(id, 2)));
    }
}
