//! Contacts as a step found them: what bears what, and by how much.

mod common;

use common::{
    GRAVITY, ORE, RADIUS, STEEL, floor, one, run_until, setup, simulation, simulation_on, smooth,
    tube, wall,
};
use pelletflow::core::{Bounds, MaterialPair, PairProperties, Shape, Vec3};
use pelletflow::sim::{
    ContactPartner, ContactView, Domain, Fill, FillAmount, Meter, MeterKind, Seats, Setup,
    Simulation, WallForce,
};
use std::collections::BTreeMap;

/// Pellets that fall into a ring on a floor, with friction.
fn bed() -> Setup {
    let rough = PairProperties {
        restitution: 0.4,
        friction: 0.5,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(rough, rough);
    setup.gravity = GRAVITY;
    let cylinder = |radius: f64, half_length: f64| Shape::Cylinder {
        radius,
        half_length,
    };
    setup.walls = vec![
        wall("floor", floor(0.0)),
        wall("ring", tube([0.08, 0.15], 0.3)),
    ];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: cylinder(0.07, 0.1).translated(0.12 * Vec3::z()),
            amount: FillAmount::Count(400),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::zeros(),
    }];
    setup.meters = vec![Meter {
        name: "load".into(),
        kind: MeterKind::WallForce(WallForce {
            wall: 0,
            about: Vec3::zeros(),
        }),
    }];
    setup
}

/// The bed while it settles, its contacts shown.
fn settling(threads: usize) -> Simulation {
    let mut simulation = simulation_on(bed(), threads);
    simulation.show_contacts(true);
    run_until(&mut simulation, 0.2).expect("the bed is sound");
    simulation
}

/// Contacts of the last step, in order.
fn contacts(simulation: &Simulation) -> Vec<ContactView> {
    let contacts = simulation.contacts().expect("they are shown");
    let mut contacts: Vec<_> = contacts.collect();
    contacts.sort_unstable_by(ContactView::by_number);
    contacts
}

/// Mass [kg] and half-step velocity [m/s] of each pellet, by number.
fn half_steps(simulation: &Simulation) -> BTreeMap<u32, (f64, Vec3)> {
    let pellets = &simulation.state().pellets;
    let rows = pellets.id.iter().zip(&pellets.half_step_velocity);
    rows.map(|(&id, &[x, y, z, mass])| (id, (mass, Vec3::new(x, y, z))))
        .collect()
}

#[test]
fn a_stack_of_two_bears_on_each_contact_what_lies_above_it() {
    let mut setup = setup(smooth(0.3), smooth(0.3));
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.fills = vec![
        one("lower", Vec3::new(0.1, 0.0, RADIUS), Vec3::zeros()),
        one("upper", Vec3::new(0.1, 0.0, 3.0 * RADIUS), Vec3::zeros()),
    ];
    let mut simulation = simulation(setup);
    simulation.show_contacts(true);
    run_until(&mut simulation, 0.5).expect("it settles");
    let [between, below] = contacts(&simulation)[..] else {
        panic!("{:?}", contacts(&simulation));
    };
    let weight = common::pellet(&simulation, 0).mass * GRAVITY.norm();
    assert_eq!(
        (between.pellet, between.partner),
        (0, ContactPartner::Pellet(1))
    );
    assert_eq!((below.pellet, below.partner), (0, ContactPartner::Wall(0)));
    for (contact, force, height) in [(between, -weight, 2.0 * RADIUS), (below, 2.0 * weight, 0.0)] {
        // What is left of the first bounces.
        assert!(
            (contact.force - force * Vec3::z()).norm() < 1.0e-6 * weight,
            "{contact:?}"
        );
        assert!((contact.normal_force - force.abs()).abs() < 1.0e-6 * weight);
        // The pellets sink by less than the two overlaps.
        let place = Vec3::new(0.1, 0.0, height);
        assert!((contact.point - place).norm() < 2.0 * (between.overlap + below.overlap));
        assert!(contact.overlap > 0.0 && contact.overlap < 0.01 * RADIUS);
        assert_eq!(contact.radius, RADIUS);
    }
    // Hertz (Johnson 1985, eq. 4.23): F = 4/3 E* √R* δ^(3/2), the floor being flat.
    let materials = &simulation.model().setup().materials;
    for (contact, partner, radius) in [(between, ORE, RADIUS / 2.0), (below, STEEL, RADIUS)] {
        let [ore, other] = [ORE, partner].map(|index| &materials[index].material);
        let modulus = MaterialPair::new(ore, other, &smooth(0.3)).effective_youngs_modulus;
        let law = 4.0 / 3.0 * modulus * radius.sqrt() * contact.overlap.powf(1.5);
        let error = contact.normal_force / law - 1.0;
        // The step is chosen for 1e-3; the sampling takes Δt² S / 12 m* off the law, 5e-4 here (Takahashi & Imada 1984).
        assert!(error.abs() < 1.0e-3, "{error} of {law} N");
    }
}

#[test]
fn contacts_and_gravity_are_all_that_moves_a_pellet() {
    let mut simulation = settling(1);
    let before = half_steps(&simulation);
    simulation.step().expect("the bed is sound");
    let after = half_steps(&simulation);
    let contacts = contacts(&simulation);
    assert!(contacts.len() > 200, "{} contacts", contacts.len());
    let mut forces: BTreeMap<u32, Vec3> = BTreeMap::new();
    for contact in &contacts {
        *forces.entry(contact.pellet).or_default() += contact.force;
        if let ContactPartner::Pellet(other) = contact.partner {
            *forces.entry(other).or_default() -= contact.force;
        }
    }
    let time_step = simulation.model().time_step().seconds;
    let greatest = contacts.iter().map(|contact| contact.normal_force);
    let greatest = greatest.fold(0.0, f64::max);
    for (id, (mass, velocity)) in after {
        let change = velocity - before[&id].1;
        let force = forces.get(&id).copied().unwrap_or_default() + mass * GRAVITY;
        let error = (force - mass * change / time_step).norm();
        // Velocities of up to 1 m/s are rounded to 1e-16 of that, over a step.
        let rounding = mass * 1.0e-15 / time_step + 1.0e-12 * greatest;
        assert!(error < rounding, "pellet {id}: {error} N");
    }
}

#[test]
fn what_lies_on_a_wall_is_what_its_meter_reads() {
    let simulation = settling(1);
    let on_floor = contacts(&simulation).into_iter();
    let on_floor = on_floor.filter(|contact| contact.partner == ContactPartner::Wall(0));
    let force: Vec3 = on_floor.map(|contact| contact.force).sum();
    let readings = simulation.meter_readings();
    for (axis, name) in ["force_x_n", "force_y_n", "force_z_n"]
        .into_iter()
        .enumerate()
    {
        let read = readings[0].values.iter().find(|(key, _)| *key == name);
        let (_, read) = read.expect("the meter reads forces");
        // Sums of the same numbers in another order.
        assert!(
            (read + force[axis]).abs() < 1.0e-12 * force.norm(),
            "{name}"
        );
    }
}

#[test]
fn any_number_of_threads_shows_the_same_contacts() {
    let alone = contacts(&settling(1));
    assert!(alone.is_sorted_by_key(|contact| (contact.pellet, contact.partner)));
    assert_eq!(contacts(&settling(3)), alone);
}

#[test]
fn contacts_are_known_of_the_last_step_alone_and_only_where_asked_for() {
    let mut simulation = settling(1);
    simulation.show_contacts(false);
    simulation.step().expect("the bed is sound");
    assert!(simulation.contacts().is_none());

    let mut falling = simulation_on(bed(), 1);
    falling.show_contacts(true);
    assert!(falling.contacts().is_none(), "no step was taken");
    falling.advance(10).expect("pellets fall");
    assert!(contacts(&falling).is_empty(), "nothing touches yet");
}

#[test]
fn contacts_are_not_known_after_a_step_that_failed() {
    let mut setup = bed();
    setup.limits.overlap_ratio = 1.0e-4;
    let mut simulation = simulation(setup);
    simulation.show_contacts(true);
    let mut failed = false;
    for _ in 0..1000 {
        failed = simulation.advance(16).is_err();
        if failed {
            break;
        }
        assert!(simulation.contacts().is_some());
    }
    assert!(failed && simulation.contacts().is_none());
}

#[test]
fn showing_contacts_changes_no_bit() {
    let mut hidden = simulation_on(bed(), 1);
    run_until(&mut hidden, 0.2).expect("the bed is sound");
    assert_eq!(settling(1).state_hash(), hidden.state_hash());
}

#[test]
fn a_pair_across_a_border_is_one_contact_beside_the_smaller_number() {
    let side = 0.2;
    let mut setup = setup(smooth(0.5), smooth(0.5));
    setup.domain = Domain {
        bounds: Bounds::about_origin(Vec3::repeat(side / 2.0)),
        is_periodic: [true, false, false],
    };
    let border = side / 2.0;
    let (near, overlap) = (RADIUS - 0.5e-5, 1.0e-5);
    setup.fills = vec![
        one("right", (border - near) * Vec3::x(), Vec3::zeros()),
        one("left", (near - border) * Vec3::x(), Vec3::zeros()),
    ];
    let mut simulation = simulation(setup);
    simulation.show_contacts(true);
    simulation.step().expect("they touch");
    let [contact] = contacts(&simulation)[..] else {
        panic!("{:?}", contacts(&simulation));
    };
    assert_eq!(
        (contact.pellet, contact.partner),
        (0, ContactPartner::Pellet(1))
    );
    assert!((contact.overlap - overlap).abs() < 1.0e-12);
    assert!((contact.point - border * Vec3::x()).norm() < 1.0e-12);
    assert!(contact.force.x < 0.0, "it is pushed back");
}
