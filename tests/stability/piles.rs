//! Hard piles: high, long at rest, full of rattlers, far from the origin, in a corner.

use crate::case::{Case, Course, expect};
use crate::common::RADIUS;
use crate::scenes::{ROUGH, in_vessel, pellets, pipe, plane, scene};
use pelletflow::core::{Bounds, PairProperties, Vec3};
use pelletflow::sim::{Domain, PelletKind, PelletView, Setup, SizeDistribution};

/// Pellets of the tower [-].
const STORIES: u32 = 100;
/// Cells along each side of the lattice that rattlers rattle in [-].
const CELLS: u32 = 13;
/// Place that is 10⁴ diameters from the origin [m].
const FAR: Vec3 = Vec3::new(2.0e4 * RADIUS, 0.0, 0.0);

pub(crate) const CASES: [Case; 5] = [
    Case {
        name: "tower of 100 pellets",
        setup: tower,
        time: 1.0,
        quick: 0.12,
        holds: |course| expect(is_in_order(course), || "fell".into()),
    },
    Case {
        name: "pyramid at rest",
        setup: pyramid,
        time: 0.5,
        quick: 1.0,
        holds: |course| {
            let creep = way(&course.middle, &course.end);
            expect(creep < 1.0e-3, || format!("crept {creep:.0e} radii"))
        },
    },
    Case {
        name: "2,197 rattlers",
        setup: rattlers,
        time: 0.02,
        quick: 0.1,
        holds: |course| expect(are_caged(course), || "left its cell".into()),
    },
    Case {
        name: "corner of three walls",
        setup: corner,
        time: 1.0,
        quick: 1.0,
        holds: rests_in_the_corner,
    },
    Case {
        name: "10⁴ diameters from the origin",
        setup: far_from_the_origin,
        time: 0.5,
        quick: 1.0,
        holds: bounces_as_at_the_origin,
    },
];

/// Pellets above each other in a tube that is a little wider.
fn tower() -> Setup {
    let mut setup = scene(PairProperties {
        friction: 0.0,
        restitution: 0.3,
        ..ROUGH
    });
    let height = 2.0 * RADIUS * f64::from(STORIES);
    setup.walls = vec![
        plane("floor", Vec3::zeros(), Vec3::z()),
        pipe("tube", 1.02 * RADIUS, 1.1 * height),
    ];
    setup.domain = Domain::closed(Bounds {
        min: Vec3::repeat(-4.0 * RADIUS),
        max: Vec3::new(4.0 * RADIUS, 4.0 * RADIUS, 1.1 * height),
    });
    let story = |index: u32| {
        let aside = 0.01 * RADIUS * f64::from(index).sin();
        Vec3::new(aside, 0.0, RADIUS * (1.0 + 2.0 * f64::from(index)))
    };
    let stories = (0..STORIES).map(story).collect();
    setup.fills = vec![pellets("tower", 0, stories, Vec3::zeros())];
    setup
}

/// Whether each pellet is above the one before, by a diameter or a little less: the tower starts unpressed, and bounces.
fn is_in_order(course: &Course) -> bool {
    let rises = course.end.windows(2);
    rises
        .map(|pair| pair[1].position.z - pair[0].position.z)
        .all(|rise| rise > 1.9 * RADIUS && rise < 2.2 * RADIUS)
}

/// 30 pellets, layer on layer, each in the hollow of four.
pub(crate) fn pyramid() -> Setup {
    // Rough enough for the lowest layer to hold the others up.
    let mut setup = scene(PairProperties {
        friction: 0.8,
        rolling_friction: 0.2,
        ..ROUGH
    });
    setup.walls = vec![plane("floor", Vec3::zeros(), Vec3::z())];
    setup.domain = Domain::closed(Bounds {
        min: Vec3::repeat(-10.0 * RADIUS),
        max: Vec3::repeat(10.0 * RADIUS),
    });
    let mut places = Vec::new();
    for layer in 0..4_u32 {
        let along = 4 - layer;
        let at = |index: u32| RADIUS * (2.0 * f64::from(index) - f64::from(along - 1));
        let height = RADIUS * (1.0 + 2.0_f64.sqrt() * f64::from(layer));
        for i in 0..along {
            places.extend((0..along).map(|j| Vec3::new(at(i), at(j), height)));
        }
    }
    setup.fills = vec![pellets("pyramid", 0, places, Vec3::zeros())];
    setup
}

/// Greatest way of a pellet, in radii [-].
pub(crate) fn way(before: &[PelletView], after: &[PelletView]) -> f64 {
    let ways = before.iter().zip(after);
    ways.map(|(before, after)| (after.position - before.position).norm() / RADIUS)
        .fold(0.0, f64::max)
}

/// A cubic lattice of pellets, and in each of its cells a small one that flies to and fro.
fn rattlers() -> Setup {
    let half = RADIUS * f64::from(CELLS + 1);
    let mut setup = in_vessel(scene(ROUGH), half, 2.0 * half);
    setup.gravity = Vec3::zeros();
    setup.pellets.push(PelletKind {
        name: "rattler".into(),
        material: crate::common::ORE,
        size: SizeDistribution::Single { diameter: RADIUS },
    });
    let cubic = |count: u32| {
        let at = move |index: u32| RADIUS * (2.0 * f64::from(index) - f64::from(count - 1));
        let place = move |index: u32| {
            let [i, j, k] = [index % count, index / count % count, index / count / count];
            Vec3::new(at(i), at(j), at(k) + half)
        };
        (0..count.pow(3)).map(place).collect()
    };
    setup.fills = vec![
        pellets("lattice", 0, cubic(CELLS + 1), Vec3::zeros()),
        pellets("rattlers", 1, cubic(CELLS), Vec3::new(0.9, 0.5, -0.3)),
    ];
    setup
}

/// Whether each rattler is still in its cell, and has not come to rest at once.
fn are_caged(course: &Course) -> bool {
    let rattlers = course
        .start
        .iter()
        .zip(&course.end)
        .filter(|(a, _)| a.kind == 1);
    rattlers
        .map(|(before, after)| (after.position - before.position).norm())
        .all(|way| way > 0.0 && way < RADIUS)
}

/// A pellet thrown into a corner, to which gravity pulls it.
fn corner() -> Setup {
    let mut setup = scene(ROUGH);
    setup.gravity = -9.81 * Vec3::repeat(1.0).normalize();
    setup.walls = [Vec3::x(), Vec3::y(), Vec3::z()]
        .iter()
        .zip(["x", "y", "z"])
        .map(|(&normal, name)| plane(name, Vec3::zeros(), normal))
        .collect();
    setup.domain = Domain::closed(Bounds {
        min: Vec3::repeat(-RADIUS),
        max: Vec3::repeat(1.0),
    });
    let place = RADIUS * Vec3::new(4.0, 5.0, 3.0);
    setup.fills = vec![pellets(
        "throw",
        0,
        vec![place],
        Vec3::new(-3.0, -2.0, -1.0),
    )];
    setup
}

fn rests_in_the_corner(course: &Course) -> Result<(), String> {
    // It sinks into each wall by some micrometers.
    let aside = (course.end[0].position - Vec3::repeat(RADIUS)).norm();
    expect(aside < 0.01 * RADIUS, || "not in the corner".into())
}

/// A pellet that falls on a floor, far away.
fn far_from_the_origin() -> Setup {
    let mut setup = scene(ROUGH);
    let drop = FAR + 4.0 * RADIUS * Vec3::z();
    setup.walls = vec![plane("floor", FAR, Vec3::z())];
    setup.domain = Domain::closed(Bounds {
        min: FAR - Vec3::repeat(2.0 * RADIUS),
        max: FAR + Vec3::repeat(8.0 * RADIUS),
    });
    setup.fills = vec![pellets("drop", 0, vec![drop], Vec3::zeros())];
    setup
}

/// The pellet is where it would be had all been moved to the origin.
fn bounces_as_at_the_origin(course: &Course) -> Result<(), String> {
    let mut near = course.simulation.model().setup().clone();
    let drop = 4.0 * RADIUS * Vec3::z();
    near.walls = vec![plane("floor", Vec3::zeros(), Vec3::z())];
    near.domain.bounds.min -= FAR;
    near.domain.bounds.max -= FAR;
    near.fills = vec![pellets("drop", 0, vec![drop], Vec3::zeros())];
    let mut near = crate::common::simulation(near);
    near.advance(course.simulation.step_count())
        .map_err(|error| error.to_string())?;
    let aside = crate::common::pellet(&near, 0).position - (course.end[0].position - FAR);
    // Coordinates of 150 m are rounded by 3·10⁻¹⁴ m, which the hits of half a second multiply.
    expect(aside.norm() < 1.0e-6 * RADIUS, || {
        format!("off by {:.0e} radii", aside.norm() / RADIUS)
    })
}
