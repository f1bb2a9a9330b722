//! Flow through an orifice.

mod common;

use common::{GRAVITY, RADIUS, held, setup, simulation_on, wall};
use pelletflow::core::{PairProperties, Profile, Shape, Vec3};
use pelletflow::sim::{Fill, FillAmount, Outlet, Schedule, Seats};
use std::f64::consts::PI;

#[test]
fn a_flat_silo_discharges_by_beverloos_law() {
    let pair = PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(pair, pair);
    setup.gravity = GRAVITY;
    let diameter = 2.0 * RADIUS;
    let (silo, orifice) = (7.0 * diameter, 3.5 * diameter);
    let tube = |radius, half_length| Shape::Cylinder {
        radius,
        half_length,
    };
    let opening = 0.6;
    let mut gate = wall("gate", tube(orifice, 0.02).translated(-0.02 * Vec3::z()));
    gate.schedule = Schedule::opening_at(vec![opening]);
    // One body of revolution: its lip is felt where it is.
    let (outside, under) = (silo + 0.02, -0.008);
    let profile = Profile::Closed {
        corners: vec![
            [orifice, 0.0],
            [silo, 0.0],
            [silo, 1.0],
            [outside, 1.0],
            [outside, under],
            [orifice, under],
        ],
    };
    setup.walls = vec![wall("silo", Shape::Revolution { profile }), gate];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: tube(silo - 1.0e-4, 0.35).translated(0.37 * Vec3::z()),
            amount: FillAmount::Count(2400),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    setup.outlets = vec![Outlet {
        name: "below".into(),
        region: tube(silo, 0.2).translated(-0.5 * Vec3::z()),
    }];
    let mut simulation = simulation_on(setup, 2);
    let step = simulation.model().time_step().seconds;
    let mut until = |time: f64| {
        let steps = ((time - simulation.time()) / step) as u64;
        simulation.advance(steps).expect("it flows");
        let inside: f64 = simulation
            .pellets()
            .filter(|pellet| (0.05..0.15).contains(&pellet.position.z))
            .map(|pellet| pellet.mass)
            .sum();
        (
            simulation.time(),
            simulation.mass_ledger().discharged.mass,
            inside,
        )
    };
    let (_, _, inside) = until(opening);
    let bulk_density = inside / (0.1 * PI * silo * silo);
    let (start, before, _) = until(opening + 0.5);
    let (end, after, _) = until(opening + 1.0);
    let flow = (after - before) / (end - start);
    let effective: f64 = 2.0 * orifice - 1.4 * diameter;
    let beverloo = 0.58 * bulk_density * 9.81_f64.sqrt() * effective.powf(2.5);
    held(
        "flows",
        "mass flow from a flat silo through an orifice of 7 diameters",
        flow / beverloo - 1.0,
        0.15,
        "Beverloo, Leniger & van de Velde 1961, C = 0.58, k = 1.4, whose constants scatter by 10 %",
    );
}
