//! Every contact law in a poured bed: it comes to rest, keeps its books and gives the same bits on any number of threads.

mod common;

use common::{floor, one, setup, simulation_on, tube, wall};
use pelletflow::core::contact::{ContactLaws, NormalLaw, TangentialLaw, TurningLaw};
use pelletflow::core::{PairProperties, Shape, Vec3};
use pelletflow::sim::{Fill, FillAmount, Model, Seats, Simulation};

/// Each choice of each part at least once, with the default for the others.
fn laws() -> Vec<ContactLaws> {
    let default = ContactLaws::default();
    let mut all = Vec::new();
    for normal in [NormalLaw::Linear, NormalLaw::Plastic, NormalLaw::Jkr] {
        all.push(ContactLaws { normal, ..default });
    }
    for tangential in [
        TangentialLaw::None,
        TangentialLaw::Coulomb,
        TangentialLaw::PartialSlip,
    ] {
        all.push(ContactLaws {
            tangential,
            ..default
        });
    }
    for turning in [
        TurningLaw::None,
        TurningLaw::ConstantTorque,
        TurningLaw::SpringDashpot,
    ] {
        all.push(ContactLaws {
            rolling: turning,
            twisting: turning,
            ..default
        });
    }
    all.push(ContactLaws {
        normal: NormalLaw::Plastic,
        tangential: TangentialLaw::PartialSlip,
        rolling: TurningLaw::SpringDashpot,
        twisting: TurningLaw::SpringDashpot,
    });
    all
}

/// 120 pellets let fall into a tube.
fn poured(laws: ContactLaws, threads: usize, time: f64) -> Simulation {
    let properties = PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.1,
        stiffness: Some(2.0e5),
        yield_pressure: Some(5.0e6),
        surface_energy: Some(0.5),
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(properties, properties);
    setup.gravity = common::GRAVITY;
    setup.laws = laws;
    let cylinder = |radius, half_length| Shape::Cylinder {
        radius,
        half_length,
    };
    setup.walls = vec![
        wall("floor", floor(0.0)),
        wall("tube", tube([0.05, 0.2], 0.5)),
    ];
    setup.fills = vec![Fill {
        name: "bed".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: cylinder(0.049, 0.15).translated(0.2 * Vec3::z()),
            amount: FillAmount::Count(120),
        },
        velocity: Vec3::zeros(),
        spin: Vec3::new(3.0, -2.0, 5.0),
    }];
    let mut simulation = simulation_on(setup, threads);
    let steps = (time / simulation.model().time_step().seconds) as u64;
    simulation.advance(steps).expect("the bed settles");
    simulation
}

#[test]
fn a_bed_comes_to_rest_and_its_energy_ledger_closes_by_every_law() {
    for laws in laws() {
        let simulation = poured(laws, 1, 1.0);
        let energy = simulation.energy_ledger();
        assert!(
            energy.kinetic < 1.0e-4 * energy.throughput,
            "{laws:?} moves: {energy:?}"
        );
        // Coulomb's friction without memory, the worst, acts on a predicted velocity.
        assert!(
            energy.residual.abs() < 1.0e-2 * energy.throughput,
            "{laws:?} misses energy: {energy:?}"
        );
    }
}

#[test]
fn every_law_gives_the_same_bits_on_one_and_three_threads() {
    for laws in laws() {
        let alone = poured(laws, 1, 0.25).state_hash();
        assert_eq!(poured(laws, 3, 0.25).state_hash(), alone, "{laws:?}");
    }
}

#[test]
fn a_law_without_what_it_needs_of_the_pairs_is_refused_with_the_cure() {
    for (normal, key, cure) in [
        (NormalLaw::Linear, "pairs.ore-ore.stiffness", "stiffness = "),
        (NormalLaw::Plastic, "contact.normal", "yield_pressure = "),
        (NormalLaw::Jkr, "contact.normal", "surface_energy = "),
    ] {
        let mut setup = setup(PairProperties::ELASTIC, PairProperties::ELASTIC);
        setup.laws.normal = normal;
        setup.walls = vec![wall("floor", floor(0.0))];
        setup.fills = vec![one("drop", 0.1 * Vec3::z(), Vec3::zeros())];
        let mistakes = Model::new(setup).expect_err("something is missing");
        assert_eq!(mistakes[0].key, key);
        assert!(mistakes[0].message.contains(cure), "{mistakes:?}");
    }
}

#[test]
fn a_skin_that_a_sticky_contact_outreaches_is_refused() {
    let sticky = PairProperties {
        surface_energy: Some(1.0e3),
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(sticky, sticky);
    setup.laws.normal = NormalLaw::Jkr;
    setup.fills = vec![one("drop", 0.1 * Vec3::z(), Vec3::zeros())];
    setup.skin = Some(1.0e-6);
    let mistakes = Model::new(setup).expect_err("the skin is too thin");
    assert_eq!(mistakes[0].key, "contact.skin");
}
