//! Angles of repose.

use super::common::{GRAVITY, RADIUS, held, one, setup, simulation, smooth};
use super::{meter, value};
use pelletflow::core::Vec3;
use pelletflow::sim::{Fill, Heap, Meter, MeterKind, Seats};
use std::f64::consts::TAU;

/// A meter of a heap about the vertical through a point of the ground.
fn heap(point: Vec3) -> Vec<Meter> {
    vec![meter(MeterKind::Heap(Heap {
        point,
        up: Vec3::z_axis(),
    }))]
}

#[test]
fn the_angle_of_a_cone_of_placed_pellets_is_that_of_the_cone() {
    let angle = 30.0_f64.to_radians();
    let (tip, spacing) = (0.2, 2.1 * RADIUS);
    let foot = Vec3::new(0.1, -0.2, 0.3);
    let mut places = Vec::new();
    let rings = (tip / angle.tan() / spacing) as usize;
    for ring in 1..rings {
        let radius = ring as f64 * spacing;
        let count = (TAU * radius / spacing) as usize;
        for place in 0..count {
            let turn = TAU * place as f64 / count as f64;
            let height = tip - radius * angle.tan() - RADIUS;
            places.push(foot + Vec3::new(radius * turn.cos(), radius * turn.sin(), height));
        }
    }
    let mut setup = setup(smooth(0.5), smooth(0.5));
    setup.gravity = GRAVITY;
    setup.fills = vec![Fill {
        seats: Seats::Points(places),
        ..one("cone", Vec3::zeros(), Vec3::zeros())
    }];
    setup.meters = heap(foot);
    let simulation = simulation(setup);
    assert_eq!(value(&simulation, "sectors"), 12.0);
    held(
        "meters",
        "angle of a cone of placed pellets",
        value(&simulation, "angle_deg") / 30.0 - 1.0,
        // Every top lies on the cone: rounding alone.
        1.0e-10,
        "30°",
    );
    assert!(value(&simulation, "scatter_deg") < 1.0e-9);
}

#[test]
fn the_angle_of_a_cone_of_stacked_pellets_is_that_of_the_cone_within_its_scatter() {
    let slope = 32.0_f64.to_radians().tan();
    let (tip, spacing) = (0.25, 2.1 * RADIUS);
    let steps = (tip / slope / spacing) as i32;
    let mut places = Vec::new();
    for x in -steps..steps {
        for y in -steps..steps {
            for z in 0..steps {
                // Off the axis, so that the sectors differ.
                let place =
                    spacing * Vec3::new(f64::from(x) + 0.3, f64::from(y) + 0.2, f64::from(z) + 0.5);
                if place.z + RADIUS < tip - slope * place.x.hypot(place.y) {
                    places.push(place);
                }
            }
        }
    }
    let mut setup = setup(smooth(0.5), smooth(0.5));
    setup.gravity = GRAVITY;
    setup.fills = vec![Fill {
        seats: Seats::Points(places),
        ..one("cone", Vec3::zeros(), Vec3::zeros())
    }];
    setup.meters = heap(Vec3::zeros());
    let simulation = simulation(setup);
    assert_eq!(value(&simulation, "sectors"), 12.0);
    // The mean of twelve sectors, to three of its deviations.
    let margin = 3.0 * value(&simulation, "scatter_deg") / 12.0_f64.sqrt();
    assert!(
        margin < 0.5,
        "the mean of the sectors is uncertain by {margin}°"
    );
    held(
        "meters",
        "angle of a cone of stacked pellets",
        value(&simulation, "angle_deg") / 32.0 - 1.0,
        margin / 32.0,
        "32°, within three deviations of the mean of twelve sectors",
    );
}
