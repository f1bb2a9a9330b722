//! A bed of sizes from 1 to 10, each class of sizes with as much volume as any other.

use crate::{bed, silo};
use pelletflow::core::{Shape, Vec3};
use pelletflow::sim::{Setup, SizeDistribution, StepRequest};

/// Pellets [-].
pub(crate) const PELLETS: usize = 100_000;
/// Smallest diameter [m].
const SMALLEST: f64 = 3.0e-3;
/// Extra reach of a neighbor list [m].
const SKIN: f64 = 0.1 * 5.5 * SMALLEST;
/// Classes from the smallest to ten times its size [-].
const CLASSES: u32 = 5;
/// Height of the region that pellets are put down in [m].
const HEIGHT: f64 = 0.9;

pub(crate) fn setup() -> Setup {
    let mut setup = bed::setup([1, 1]);
    let share = |class: u32| f64::from(class) / f64::from(CLASSES);
    setup.pellets[0].size = SizeDistribution::Sieve {
        openings: (0..=CLASSES)
            .map(|class| SMALLEST * 10.0_f64.powf(share(class)))
            .collect(),
        passing: (0..=CLASSES).map(share).collect(),
    };
    // The Rayleigh time goes with the size.
    setup.step = StepRequest::Fixed(silo::TIME_STEP * SMALLEST / silo::DIAMETER);
    setup.skin = Some(SKIN);
    setup
}

pub(crate) fn region() -> Shape {
    let size = Vec3::new(bed::SIDE, bed::SIDE, HEIGHT);
    Shape::Cuboid {
        half_sides: size / 2.0,
    }
    .translated(size / 2.0)
}
