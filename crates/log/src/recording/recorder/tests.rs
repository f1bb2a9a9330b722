//! A slow, a full and a broken disk.

use super::{Entry, FRAMES, Recorder, RecordingTimes, Stopped};
use crate::checkpoint::{Identity, Keeper, Spent};
use crate::counts_before::CountsBefore;
use crate::logbook::Logbook;
use crate::message::event::Gravity;
use crate::recording::{Drawn, DrawnPellet, Recording, Title};
use crate::run::RunRequest;
use mcap::{McapError, McapResult};
use pelletflow_core::{Bounds, ContactLaws, Material, PairProperties, Shape, Vec3};
use pelletflow_sim::{
    Domain, Fill, FillAmount, Integrator, KeptFrames, Limits, Model, NamedMaterial, NeighborSearch,
    PelletKind, RunPlan, Seats, Setup, Simulation, SizeDistribution, Skips, StepRequest,
};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Cursor, Seek, SeekFrom, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

const PELLETS: u32 = 500;

/// A disk in memory that does something else before it writes.
struct Disk<B> {
    bytes: Cursor<Vec<u8>>,
    before: B,
}

/// A disk that calls `before` with the bytes that it holds, before it writes more.
fn disk<B: FnMut(usize) -> io::Result<()>>(before: B) -> Disk<B> {
    Disk {
        bytes: Cursor::new(Vec::new()),
        before,
    }
}

impl<B: FnMut(usize) -> io::Result<()>> Write for Disk<B> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        (self.before)(self.bytes.get_ref().len())?;
        self.bytes.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl<B> Seek for Disk<B> {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        self.bytes.seek(position)
    }
}

/// A scene with nothing in it.
fn setup() -> Setup {
    Setup {
        seed: 1,
        gravity: Vec3::zeros(),
        materials: vec![NamedMaterial {
            name: "ore".into(),
            material: Material::from_shear_modulus(3700.0, 6.0e7, 0.25),
            true_youngs_modulus: None,
        }],
        pairs: Vec::new(),
        pellets: vec![PelletKind {
            name: "ore".into(),
            material: 0,
            size: SizeDistribution::Single { diameter: 0.015 },
        }],
        laws: ContactLaws::default(),
        walls: Vec::new(),
        fills: Vec::new(),
        inlets: Vec::new(),
        outlets: Vec::new(),
        meters: Vec::new(),
        domain: Domain::closed(Bounds {
            min: -Vec3::repeat(1.0),
            max: Vec3::repeat(1.0),
        }),
        integrator: Integrator::default(),
        step: StepRequest::PeakForceError(0.01),
        search: NeighborSearch::Auto,
        skin: None,
        limits: Limits::default(),
        skips: Skips::default(),
        instructions: None,
        hits: None,
    }
}

/// Pellets stored in the reverse order of their numbers, each at another place at each time [s].
fn fill(pellets: &mut Vec<DrawnPellet>, time: f64) {
    pellets.clear();
    pellets.extend((0..PELLETS).rev().map(|id| DrawnPellet {
        id,
        position: Vec3::new(f64::from(id), time, f64::from(id).sin() * time.cos()),
        radius: 0.0075,
        speed: time,
        force: 1.0,
    }));
}

/// Puts a frame and what stands between frames, and ends the chunk, so that the disk is written to.
fn put_frame<W>(recorder: &mut Recorder<'_, W>, index: u32) -> Result<(), Stopped> {
    let mut frame = recorder.blank()?;
    frame.time = f64::from(index);
    fill(&mut frame.pellets, frame.time);
    recorder.put(Entry::Frame(frame))?;
    recorder.put(Entry::Event {
        time: f64::from(index),
        gravity: Gravity::Information,
        text: format!("frame {index}"),
    })?;
    recorder.put(Entry::Flush)
}

/// Puts twenty frames onto a disk that takes them all.
fn put_frames<W>(recorder: &mut Recorder<'_, W>) {
    for index in 0..20 {
        put_frame(recorder, index).expect("the disk takes it");
    }
}

/// Records onto a disk; what came of the recording, and how long it was waited for.
fn record<W: Write + Seek + Send>(
    disk: W,
    feed: impl FnOnce(&mut Recorder<'_, W>),
) -> (McapResult<W>, Duration) {
    let title = Title {
        scene_text: "",
        layout: "",
        facts: BTreeMap::new(),
    };
    let drawn = Drawn {
        spheres_up_to: PELLETS as usize,
        full_speed: 1.0,
        contacts: false,
    };
    let recording =
        Recording::start(disk, &setup(), &title, drawn, None).expect("these disks take the title");
    thread::scope(|scope| {
        let mut recorder = Recorder::start(scope, recording).expect("a thread can be started");
        feed(&mut recorder);
        let waiting = recorder.waiting();
        (recorder.finish().0, waiting)
    })
}

#[test]
fn a_slow_disk_holds_the_same_bytes_and_is_waited_for() {
    let nap = Duration::from_millis(1);
    let (fast, _) = record(Cursor::new(Vec::new()), put_frames);
    let slow = disk(|_| {
        thread::sleep(nap);
        Ok(())
    });
    let (slow, waiting) = record(slow, put_frames);
    let fast = fast.expect("it is written").into_inner();
    let slow = slow.expect("it is written").bytes.into_inner();
    assert!(fast == slow, "{} and {} bytes", fast.len(), slow.len());
    // All but the last frames are waited for, and each is written in a nap at least.
    assert!(waiting > 10 * nap, "{waiting:?}");
}

#[test]
fn a_disk_that_stands_still_stops_the_run_with_three_frames_in_memory() {
    let is_still = AtomicBool::new(false);
    let put = AtomicUsize::new(0);
    let standing = disk(|_| {
        while is_still.load(Ordering::Relaxed) {
            thread::sleep(Duration::from_millis(1));
        }
        Ok(())
    });
    // The first frame is written into the chunk, whose end then stands still.
    let most = FRAMES + 1;
    thread::scope(|scope| {
        let watch = scope.spawn(|| {
            let began = Instant::now();
            while put.load(Ordering::Relaxed) < most && began.elapsed() < Duration::from_mins(1) {
                thread::sleep(Duration::from_millis(1));
            }
            // Time for a run that did not wait to put many more.
            thread::sleep(Duration::from_millis(50));
            let found = put.load(Ordering::Relaxed);
            is_still.store(false, Ordering::Relaxed);
            found
        });
        let (written, _) = record(standing, |recorder| {
            is_still.store(true, Ordering::Relaxed);
            for index in 0..40 {
                put_frame(recorder, index).expect("the disk takes it in the end");
                put.fetch_add(1, Ordering::Relaxed);
            }
        });
        assert!(written.is_ok());
        assert_eq!(watch.join().expect("the watch does not panic"), most);
    });
    assert_eq!(put.into_inner(), 40);
}

#[test]
fn frames_are_filled_into_the_same_memory_again() {
    let mut places = BTreeSet::new();
    let (written, _) = record(Cursor::new(Vec::new()), |recorder| {
        for index in 0..50 {
            let mut frame = recorder.blank().expect("the disk takes it");
            fill(&mut frame.pellets, f64::from(index));
            places.insert(frame.pellets.as_ptr().addr());
            recorder
                .put(Entry::Frame(frame))
                .expect("the disk takes it");
        }
    });
    assert!(written.is_ok());
    assert!(places.len() <= FRAMES, "{places:?}");
}

#[test]
fn a_full_disk_stops_the_run_and_tells_its_error() {
    let full = disk(|held| {
        if held < 50_000 {
            Ok(())
        } else {
            Err(io::ErrorKind::StorageFull.into())
        }
    });
    let mut taken = 0;
    let (written, _) = record(full, |recorder| {
        while put_frame(recorder, taken).is_ok() {
            taken += 1;
            assert!(taken < 10_000, "the disk is full long before");
        }
        assert!(recorder.put(Entry::Flush).is_err());
    });
    assert!(taken > 0);
    match written.map(|_| ()) {
        Err(McapError::Io(error)) => assert_eq!(error.kind(), io::ErrorKind::StorageFull),
        other => panic!("expected the error of the disk, not {other:?}"),
    }
}

#[test]
fn a_disk_that_fills_up_at_the_very_end_is_told_too() {
    let is_full = AtomicBool::new(false);
    let filling = disk(|_| {
        if is_full.load(Ordering::Relaxed) {
            Err(io::ErrorKind::StorageFull.into())
        } else {
            Ok(())
        }
    });
    let (written, _) = record(filling, |recorder| {
        put_frame(recorder, 0).expect("the disk takes it");
        is_full.store(true, Ordering::Relaxed);
    });
    assert!(written.is_err());
}

#[test]
#[should_panic(expected = "the disk is on fire")]
fn a_panic_of_the_thread_goes_on_in_the_run() {
    let mut has_burned = false;
    let burning = disk(|held| {
        let burns = held > 5000 && !has_burned;
        has_burned |= burns;
        assert!(!burns, "the disk is on fire");
        Ok(())
    });
    let _ = record(burning, |recorder| while put_frame(recorder, 0).is_ok() {});
}

#[test]
fn no_checkpoint_is_due_while_one_waits_for_the_disk() {
    let lone = Setup {
        pairs: vec![([0, 0], PairProperties::ELASTIC)],
        fills: vec![Fill {
            name: "lone".into(),
            pellets: 0,
            seats: Seats::Lattice {
                region: Shape::Cuboid {
                    half_sides: Vec3::repeat(0.1),
                },
                amount: FillAmount::Count(1),
            },
            velocity: Vec3::x(),
            spin: Vec3::zeros(),
        }],
        step: StepRequest::Fixed(1.0e-5),
        ..setup()
    };
    let model = Model::new(lone).expect("it is a right setup");
    let simulation = Simulation::new(model, 1).expect("it fits");
    let plan = RunPlan {
        end_time: 1.0,
        stop: Vec::new(),
        frame_interval: 0.1,
        kept_frames: KeptFrames::default(),
        meter_interval: 0.1,
        checkpoint_interval: 0.0,
    };
    let directory = tempfile::tempdir().expect("a temporary directory can be made");
    let file = tempfile::tempfile().expect("a temporary file can be made");
    let request = RunRequest {
        directory: directory.path(),
        scene_name: "lone",
        scene_title: "One pellet",
        scene_text: "",
        scene_hash: "",
        scene_files: &[],
        plan: &plan,
        spheres_up_to: 0,
        contacts: false,
        live: None,
    };
    let mut keeper = Keeper::new(
        directory.path().into(),
        Identity::of(&request),
        Arc::new(file),
        plan.checkpoint_interval,
        (CountsBefore::of(&simulation), Spent::default()),
    );
    assert!(keeper.is_due());
    let logbook = Logbook::new(&simulation, &plan);
    let waiting = keeper.save(&simulation, &logbook, RecordingTimes::default());
    assert!(!keeper.is_due());
    drop(waiting);
    assert!(keeper.is_due());
}
