//! Hard motions: vibrated, turned, squeezed, cut off, undamped, shot.

use crate::case::{Case, Course, expect, holds_its_pellets};
use crate::common::{ORE, RADIUS, STEEL, smooth, wall};
use crate::scenes::{ROUGH, in_vessel, lattice, pellets, pipe, plane, poured, scene, with_modulus};
use pelletflow::core::contact::{TangentialLaw, TurningLaw};
use pelletflow::core::{Bounds, Shape, UnitVector3, Vec3};
use pelletflow::sim::{Domain, Fill, Motion, Seats, Setup};
use std::f64::consts::TAU;

/// Turns of the drum [rad/s], its radius [m], and its pellets [-].
const TURN: f64 = 30.0;
const DRUM: f64 = 0.1;
const HELD: u32 = 36;

pub(crate) const CASES: [Case; 6] = [
    Case {
        name: "vibrated bed",
        setup: vibrated_bed,
        time: 1.0,
        quick: 0.2,
        holds: holds_its_pellets,
    },
    Case {
        name: "undamped gas",
        setup: undamped_gas,
        time: 1.0,
        quick: 0.4,
        holds: keeps_its_energy,
    },
    Case {
        name: "rotating frame of rigid contacts",
        setup: turning_drum,
        time: 1.0,
        quick: 0.4,
        holds: turns_as_one,
    },
    Case {
        name: "wedge that squeezes",
        setup: wedge,
        time: 0.3,
        quick: 1.0,
        holds: holds_its_pellets,
    },
    Case {
        name: "gate that closes on pellets",
        setup: gate,
        time: 0.4,
        quick: 1.0,
        holds: holds_its_pellets,
    },
    Case {
        name: "15 m/s onto a plate of 2 mm",
        setup: shot_at_a_plate,
        time: 0.02,
        quick: 1.0,
        holds: |course| {
            let is_above = course.end[0].position.z > 0.0;
            expect(is_above, || "passed the plate".into())
        },
    },
];

/// 100 pellets on a floor that shakes at 3.8 times gravity.
pub(crate) fn vibrated_bed() -> Setup {
    let mut setup = in_vessel(scene(ROUGH), 5.3 * RADIUS, 0.4);
    for wall in &mut setup.walls {
        wall.motion = Motion::Vibrating {
            amplitude: 1.5e-3 * Vec3::z(),
            frequency: 25.0,
            swing: None,
        };
    }
    let places = lattice([5, 5, 4], 2.02 * RADIUS, 1.1 * RADIUS);
    setup.fills = vec![pellets("bed", 0, places, Vec3::zeros())];
    setup
}

/// 64 pellets without friction or damping.
fn undamped_gas() -> Setup {
    let mut setup = scene(smooth(1.0));
    setup.gravity = Vec3::zeros();
    setup.laws.tangential = TangentialLaw::None;
    setup.laws.rolling = TurningLaw::None;
    let half = 8.0 * RADIUS;
    let mut setup = in_vessel(setup, half, 2.0 * half);
    let places = lattice([4, 4, 4], 3.5 * RADIUS, 2.5 * RADIUS);
    let thrown = places.into_iter().zip(0_u32..).map(|(place, index)| {
        let turn = 2.4 * f64::from(index);
        let velocity = Vec3::new(turn.cos(), turn.sin(), (0.7 * turn).sin());
        pellets(&format!("pellet {index}"), 0, vec![place], velocity)
    });
    setup.fills = thrown.collect();
    setup
}

fn keeps_its_energy(course: &Course) -> Result<(), String> {
    let energy = course.simulation.energy_ledger();
    let now = energy.kinetic + energy.elastic;
    let change = now / energy.carried_in - 1.0;
    // The energy of a moment swings with the contacts that are open.
    expect(change.abs() < 0.01, || {
        format!("energy {:+.0} %", 100.0 * change)
    })
}

/// Pellets that lie in a turning drum, held to its shell by their own turning.
fn turning_drum() -> Setup {
    let mut setup = scene(ROUGH);
    setup.gravity = Vec3::zeros();
    let mut drum = pipe("drum", DRUM, 0.5 * DRUM);
    drum.motion = Motion::Rotating {
        center: Vec3::zeros(),
        axis: Vec3::z_axis(),
        rate: TURN,
        start: 0.0,
        end: f64::INFINITY,
    };
    setup.walls = vec![drum];
    setup.domain = Domain::closed(Bounds {
        min: Vec3::repeat(-2.0 * DRUM),
        max: Vec3::repeat(2.0 * DRUM),
    });
    let out = DRUM - RADIUS;
    setup.fills = (0..HELD)
        .map(|index| {
            let angle = TAU * f64::from(index) / f64::from(HELD);
            let place = out * Vec3::new(angle.cos(), angle.sin(), 0.0);
            Fill {
                name: format!("pellet {index}"),
                pellets: 0,
                seats: Seats::Points(vec![place]),
                velocity: TURN * Vec3::z().cross(&place),
                spin: TURN * Vec3::z(),
            }
        })
        .collect();
    setup
}

/// In the second half no pellet has moved along the shell by a hundredth of its radius.
fn turns_as_one(course: &Course) -> Result<(), String> {
    let Course {
        middle,
        end,
        simulation,
        ..
    } = course;
    let steps = simulation.step_count() / 2;
    let turned = TURN * steps as f64 * simulation.model().time_step().seconds;
    let slip = middle
        .iter()
        .zip(end)
        .map(|(before, after)| {
            let angle = |place: Vec3| place.y.atan2(place.x);
            let ahead = angle(after.position) - angle(before.position) - turned;
            let ahead = ahead - TAU * (ahead / TAU).round();
            ahead.abs() * DRUM / RADIUS
        })
        .fold(0.0, f64::max);
    expect(slip < 0.01, || format!("slipped {slip:.0e} radii"))
}

/// A wedge that is pressed into pellets in a trough, and drives them up its sides.
fn wedge() -> Setup {
    let mut setup = scene(ROUGH);
    let side = |sign: f64| Vec3::new(sign, 0.0, 1.0);
    setup.walls = vec![
        plane("left", Vec3::zeros(), side(1.0)),
        plane("right", Vec3::zeros(), side(-1.0)),
        plane("front", -4.0 * RADIUS * Vec3::y(), Vec3::y()),
        plane("back", 4.0 * RADIUS * Vec3::y(), -Vec3::y()),
    ];
    let face = |sign: f64| Shape::HalfSpace {
        point: 11.0 * RADIUS * Vec3::z(),
        // Sharper than the trough, so that what is squeezed has a way out.
        normal: UnitVector3::new_normalize(Vec3::new(sign, 0.0, -0.4)),
    };
    let mut edge = wall(
        "wedge",
        Shape::Intersection {
            of: vec![face(1.0), face(-1.0)],
        },
    );
    edge.motion = Motion::Translating {
        velocity: -0.2 * Vec3::z(),
        start: 0.0,
        end: 0.25,
    };
    setup.walls.push(edge);
    setup.domain = Domain::closed(Bounds {
        min: Vec3::new(-0.3, -5.0 * RADIUS, -0.02),
        max: Vec3::new(0.3, 5.0 * RADIUS, 0.3),
    });
    let places = lattice([3, 3, 2], 2.3 * RADIUS, 4.5 * RADIUS);
    setup.fills = vec![pellets("bed", 0, places, Vec3::zeros())];
    setup
}

/// A gate that slides into a bed and stops before it pinches.
fn gate() -> Setup {
    let mut setup = poured(scene(ROUGH), 0.5);
    let plate = Shape::Cuboid {
        half_sides: Vec3::new(4.0 * RADIUS, 5.0 * RADIUS, 0.3 * RADIUS),
    };
    let mut gate = wall("gate", plate.translated(RADIUS * Vec3::new(9.0, 0.0, 2.5)));
    // Its tip goes from beside the bed to a diameter and a half before the far wall.
    gate.motion = Motion::Translating {
        velocity: -0.3 * Vec3::x(),
        start: 0.1,
        end: 0.1 + 6.0 * RADIUS / 0.3,
    };
    setup.walls.push(gate);
    setup
}

/// A pellet shot at a plate, stiff enough to be thrown back.
fn shot_at_a_plate() -> Setup {
    let mut setup = with_modulus(scene(ROUGH), 5.0e8);
    setup.materials[STEEL].material.youngs_modulus = setup.materials[ORE].material.youngs_modulus;
    let plate = Shape::Cuboid {
        half_sides: Vec3::new(0.1, 0.1, 1.0e-3),
    };
    setup.walls = vec![wall("plate", plate)];
    setup.domain = Domain::closed(Bounds {
        min: Vec3::repeat(-0.5),
        max: Vec3::repeat(0.5),
    });
    let place = 3.0 * RADIUS * Vec3::z();
    setup.fills = vec![pellets("shot", 0, vec![place], -15.0 * Vec3::z())];
    setup
}
