//! A run that goes on takes no more memory.

#![cfg(target_os = "linux")]

mod common;

use common::{floor, setup, simulation_on, wall};
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::log::{RunRequest, run};
use pelletflow::sim::{HitRequest, Inlet, KeptFrames, Outlet, Rate, RunPlan, Setup};
use std::ops::ControlFlow;

/// Simulated time [s]; the stream is steady, and room is made for all it needs, in the first half of it.
const TIME: f64 = 16.0;

/// What the process may grow by besides [B].
const SLACK: f64 = 128.0 * 1024.0;

/// Pellets that rain on a slope, slide off and leave, with every hit recorded.
fn stream() -> Setup {
    let rough = PairProperties {
        restitution: 0.5,
        friction: 0.3,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(rough, rough);
    setup.gravity = common::GRAVITY;
    setup.walls = vec![wall("slope", floor(0.6))];
    setup.inlets = vec![Inlet {
        name: "rain".into(),
        pellets: 0,
        region: Shape::Cuboid {
            half_sides: Vec3::new(0.1, 0.1, 0.03),
        }
        .translated(0.2 * Vec3::z()),
        rate: Rate::Count(400.0),
        velocity: -Vec3::z(),
        start: 0.0,
        end: f64::INFINITY,
    }];
    setup.outlets = vec![Outlet {
        name: "foot".into(),
        region: Shape::HalfSpace {
            point: Vec3::new(0.3, 0.0, 0.0),
            normal: -Vec3::x_axis(),
        },
    }];
    setup.hits = Some(HitRequest { threshold: 0.0 });
    setup
}

/// Memory of this process that is in use [B].
fn resident_memory() -> u64 {
    let status =
        std::fs::read_to_string("/proc/self/status").expect("Linux tells of every process");
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kilobytes = line.expect("it is told").trim().trim_end_matches(" kB");
    1024 * kilobytes.parse::<u64>().expect("it is a number")
}

#[test]
fn the_last_quarter_of_a_recorded_run_takes_no_more_memory_than_the_one_before() {
    let mut simulation = simulation_on(stream(), 2);
    let directory = tempfile::TempDir::new().expect("a directory");
    let plan = RunPlan {
        end_time: TIME,
        stop: Vec::new(),
        frame_interval: 0.02,
        kept_frames: KeptFrames::default(),
        meter_interval: 0.01,
        checkpoint_interval: 0.1,
    };
    let request = RunRequest {
        directory: directory.path(),
        scene_name: "stream",
        scene_title: "Stream",
        scene_text: "",
        scene_hash: "",
        scene_files: &[],
        plan: &plan,
        spheres_up_to: 1000,
        contacts: false,
        live: None,
    };
    // Pages come and go with every frame, by a percent or two of so small a process: means tell growth from that.
    let mut quarters: [Vec<f64>; 4] = Default::default();
    let summary = run(&mut simulation, &request, &mut |progress| {
        let quarter = (4.0 * progress.time / TIME).min(3.0) as usize;
        quarters[quarter].push(resident_memory() as f64);
        ControlFlow::Continue(())
    })
    .expect("rain is no trouble");
    assert!(summary.bodies.discharged > 2000, "the stream flows");
    let mean = |samples: &[f64]| samples.iter().sum::<f64>() / samples.len() as f64;
    let [_, _, third, last] = quarters.map(|samples| mean(&samples));
    // The promise, and what a process of a few megabytes shows beside it: half of a percent is seen from quarter to quarter,
    // of which the index of the recording is a part.
    assert!(
        last < 1.01 * third + SLACK,
        "{third:.0} B, then {last:.0} B"
    );
}
