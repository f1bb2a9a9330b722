//! What a large bed takes.

#![cfg(target_os = "linux")]

mod common;

use common::{setup, simulation};
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{Fill, FillAmount, Seats};

/// Greatest memory of this process so far [B].
fn peak_memory() -> u64 {
    let status =
        std::fs::read_to_string("/proc/self/status").expect("Linux tells of every process");
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))
        .expect("the peak is told");
    let kilobytes = line.trim().trim_end_matches(" kB");
    1024 * kilobytes.parse::<u64>().expect("the peak is a number")
}

#[test]
fn a_hundred_thousand_pellets_fit_in_200_megabytes() {
    let properties = PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.1,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(properties, properties);
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::repeat(0.4),
            },
            amount: FillAmount::Count(100_000),
        },
        // Squeezed from one side, so that contacts open.
        velocity: Vec3::new(1.0, 0.0, 0.0),
        spin: Vec3::zeros(),
    }];
    setup.skin = Some(2.0e-3);
    let mut simulation = simulation(setup);
    simulation.advance(60).expect("the block flies");
    let peak = peak_memory();
    assert!(peak < 200_000_000, "{} MB", peak / 1_000_000);
}
