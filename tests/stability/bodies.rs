//! Hard bodies: stiff, soft, large, heavy, fast, slippery, rough.

use crate::case::{Case, Course, expect, holds_its_pellets};
use crate::common::ORE;
use crate::scenes::{ROUGH, in_vessel, lattice, pellets, poured, scene, with_modulus};
use pelletflow::core::{PairProperties, Vec3};
use pelletflow::sim::{PelletKind, Setup, SizeDistribution};

/// Radius of the coarse ball, a hundred times that of the fines [m].
const COARSE: f64 = 0.1;
const FINE: f64 = 0.01 * COARSE;

pub(crate) const CASES: [Case; 7] = [
    Case {
        name: "Young's modulus 1 MPa",
        setup: || poured(with_modulus(scene(ROUGH), 1.0e6), 0.3),
        time: 1.0,
        quick: 0.5,
        holds: holds_its_pellets,
    },
    Case {
        name: "Young's modulus 200 GPa",
        setup: || poured(with_modulus(scene(ROUGH), 2.0e11), 0.3),
        time: 0.06,
        quick: 0.5,
        holds: holds_its_pellets,
    },
    Case {
        name: "size ratio 1:100",
        setup: fines_on_a_ball,
        time: 0.06,
        quick: 1.0,
        holds: holds_its_pellets,
    },
    Case {
        name: "mass ratio 1:10⁶",
        setup: ball_on_fines,
        time: 0.03,
        quick: 0.5,
        holds: carries_the_ball,
    },
    Case {
        name: "impacts at 30 m/s",
        setup: || poured(with_modulus(scene(ROUGH), 2.0e9), 30.0),
        time: 0.1,
        quick: 0.5,
        holds: holds_its_pellets,
    },
    Case {
        name: "friction 0",
        setup: || poured(scene(with_friction(0.0)), 0.5),
        time: 1.0,
        quick: 0.3,
        holds: holds_its_pellets,
    },
    Case {
        name: "friction 10",
        setup: || poured(scene(with_friction(10.0)), 0.5),
        time: 1.0,
        quick: 0.3,
        holds: holds_its_pellets,
    },
];

fn with_friction(friction: f64) -> PairProperties {
    PairProperties { friction, ..ROUGH }
}

/// A ball on a floor, and fines of a hundredth of its size.
fn with_ball(height: f64, fines: Vec<Vec3>) -> Setup {
    let mut setup = in_vessel(scene(ROUGH), 2.0 * COARSE, 3.0 * COARSE);
    setup.pellets = [("ball", COARSE), ("fines", FINE)]
        .map(|(name, radius)| PelletKind {
            name: name.into(),
            material: ORE,
            size: SizeDistribution::Single {
                diameter: 2.0 * radius,
            },
        })
        .into();
    setup.fills = vec![
        pellets("ball", 0, vec![height * Vec3::z()], Vec3::zeros()),
        pellets("fines", 1, fines, Vec3::zeros()),
    ];
    setup
}

/// Fines that fall on a ball a hundred times their size.
fn fines_on_a_ball() -> Setup {
    with_ball(
        COARSE,
        lattice([5, 5, 3], 2.2 * FINE, 2.0 * COARSE + 3.0 * FINE),
    )
}

/// A ball put on a layer of fines of a millionth of its mass.
fn ball_on_fines() -> Setup {
    let layer = lattice([9, 9, 1], 2.0 * FINE, FINE);
    // Stiff, or the fines under it would be flat.
    with_modulus(with_ball(COARSE + 2.0 * FINE, layer), 2.0e9)
}

/// The ball has sunk by less than half a fine's diameter.
fn carries_the_ball(course: &Course) -> Result<(), String> {
    let height = course.end[0].position.z;
    expect(height > COARSE + FINE, || "crushed".into())
}
