//! A bed on a floor, without end along x and y: its depth is the same however many pellets it has.

use crate::silo;
use pelletflow::core::{Bounds, Shape, Vec3};
use pelletflow::sim::{Domain, Setup};

/// Pellets of a tile [-].
pub(crate) const PELLETS: usize = 10_000;
/// Side of a tile, 20 diameters [m].
pub(crate) const SIDE: f64 = 20.0 * silo::DIAMETER;
/// Height of the box: three times that of the bed [m].
const HEIGHT: f64 = 1.0;

/// The bed's box, so many tiles along x and y.
pub(crate) fn setup(tiles: [usize; 2]) -> Setup {
    let mut setup = silo::silo(0, 0.15);
    // The floor stays.
    setup.walls.remove(0);
    let [along_x, along_y] = tiles.map(|count| count as f64 * SIDE);
    setup.domain = Domain {
        bounds: Bounds {
            min: Vec3::new(0.0, 0.0, -2.0 * silo::DIAMETER),
            max: Vec3::new(along_x, along_y, HEIGHT),
        },
        is_periodic: [true, true, false],
    };
    setup
}

/// Where the pellets of a tile are put down.
pub(crate) fn region() -> Shape {
    let size = Vec3::new(SIDE, SIDE, HEIGHT);
    Shape::Cuboid {
        half_sides: size / 2.0,
    }
    .translated(size / 2.0)
}
