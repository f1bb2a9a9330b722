//! The ledger of hits: what it says of one hit, of a flow, and of all together.

#[path = "../common/mod.rs"]
mod common;
mod oracle;

use common::{GRAVITY, RADIUS, floor, one, setup, simulation, simulation_on, smooth, wall};
use oracle::Oracle;
use pelletflow::core::contact::NormalLaw;
use pelletflow::core::{MaterialPair, PairProperties, Shape, Vec3};
use pelletflow::impact::{Damping, ElasticImpact, Impact};
use pelletflow::sim::{
    Cause, Fill, FillAmount, Hit, HitPartner, HitRequest, NeighborSearch, Outlet, Seats, Setup,
    Simulation,
};
use std::collections::BTreeMap;

/// Every hit in full.
const ALL: Option<HitRequest> = Some(HitRequest { threshold: 0.0 });
/// Of every pellet only those hits that no earlier one reached.
const RECORDS: Option<HitRequest> = Some(HitRequest {
    threshold: f64::INFINITY,
});

/// Enough for three chunks, so that contacts lie across them and threads have something to share [-].
const PELLETS: usize = 300;

/// A pellet that meets the floor, or its like, at a speed [m/s].
fn hit_alone(restitution: f64, speed: f64, against: Against, phase: f64) -> (Hit, Impact) {
    let setup = setup(smooth(restitution), smooth(restitution));
    hit_of(setup, restitution, speed, against, phase)
}

fn hit_of(
    mut setup: Setup,
    restitution: f64,
    speed: f64,
    against: Against,
    phase: f64,
) -> (Hit, Impact) {
    setup.hits = ALL;
    let materials = &setup.materials;
    let mass = setup.mass(0, RADIUS);
    let other = match against {
        Against::Floor => common::STEEL,
        Against::Pellet => common::ORE,
    };
    let pair = MaterialPair::new(
        &materials[common::ORE].material,
        &materials[other].material,
        &smooth(restitution),
    );
    let exact = match against {
        Against::Floor => ElasticImpact::on_plane(&pair, RADIUS, mass, speed),
        Against::Pellet => ElasticImpact::of_equals(&pair, RADIUS, mass, speed),
    };
    // Some steps before first touch, and a part of one.
    let gap = speed * exact.contact_time() * (1.0 + phase / 12.0);
    match against {
        Against::Floor => {
            setup.walls = vec![wall("floor", floor(0.0))];
            let height = Vec3::new(0.0, 0.0, RADIUS + gap);
            setup.fills = vec![one("drop", height, Vec3::new(0.0, 0.0, -speed))];
        }
        Against::Pellet => {
            let half = Vec3::new(RADIUS + 0.5 * gap, 0.0, 0.0);
            let velocity = Vec3::new(0.5 * speed, 0.0, 0.0);
            setup.fills = vec![one("left", -half, velocity), one("right", half, -velocity)];
        }
    }
    let mut simulation = simulation(setup);
    let mut hits = Vec::new();
    while hits.is_empty() {
        simulation.step().expect("one hit is no trouble");
        hits = simulation.take_hits();
    }
    let impact = Impact::new(&exact, Damping::Restitution(restitution), None);
    (hits[0], impact.expect("a hit with an end"))
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Against {
    Floor,
    Pellet,
}

#[test]
fn a_hit_alone_is_that_of_the_solver_of_impacts() {
    for against in [Against::Floor, Against::Pellet] {
        for restitution in [1.0, 0.8, 0.5] {
            for speed in [0.5, 2.0, 5.0] {
                for phase in [0.0, 0.35, 0.7] {
                    let (hit, exact) = hit_alone(restitution, speed, against, phase);
                    let which = format!("{against:?}, e {restitution}, {speed} m/s, {phase}");
                    let share = |found: f64, exact: f64| (found / exact - 1.0).abs();
                    // The step is chosen for 0.1 % of the peak force.
                    let error = share(hit.peak_force, exact.outline.peak_force);
                    assert!(error < 1.0e-3, "{which}: peak {error:.5}");
                    let error = share(hit.peak_pressure, exact.outline.peak_pressure);
                    assert!(error < 1.0e-3, "{which}: pressure {error:.5}");
                    assert!(share(hit.approach_speed, speed) < 1.0e-6, "{which}");
                    let brought = hit.approach_energy();
                    let lost = brought * (1.0 - restitution.powi(2));
                    let error = (hit.lost_energy - lost).abs() / brought;
                    // Heat is the sum of a dozen samples.
                    assert!(error < 1.0e-2, "{which}: lost {error:.5}");
                    let step = hit.duration / hit.steps as f64;
                    // Damped bodies still overlap when their force is gone.
                    let longer = (hit.duration - exact.outline.contact_time) / step;
                    let most = if restitution == 1.0 { 1.01 } else { 6.0 };
                    assert!((-1.01..most).contains(&longer), "{which}: {longer} steps");
                    let is_wall = against == Against::Floor;
                    let cause = if is_wall {
                        Cause::Drop
                    } else {
                        Cause::Collision
                    };
                    assert_eq!(hit.cause, cause, "{which}");
                }
            }
        }
    }
}

#[test]
fn a_softened_hit_tells_its_force_at_true_stiffness() {
    for restitution in [1.0, 0.5] {
        let mut setup = setup(smooth(restitution), smooth(restitution));
        let ore = &mut setup.materials[common::ORE];
        ore.true_youngs_modulus = Some(100.0 * ore.material.youngs_modulus);
        let (hit, soft) = hit_of(setup, restitution, 2.0, Against::Pellet, 0.3);
        // Both bodies are softened a hundred times, and force goes as the power 2/5 of the modulus.
        let exact = 100.0_f64.powf(0.4) * soft.outline.peak_force;
        assert!((hit.true_force() / exact - 1.0).abs() < 1.0e-6);
        assert!((hit.peak_force / soft.outline.peak_force - 1.0).abs() < 1.0e-3);
    }
}

/// Pellets that fall on a floor and lie there, and an outlet beside it for those that roll away.
fn heap(hits: Option<HitRequest>) -> Setup {
    let rough = PairProperties {
        restitution: 0.5,
        friction: 0.5,
        rolling_friction: 0.05,
        ..PairProperties::ELASTIC
    };
    let mut setup = setup(rough, rough);
    setup.hits = hits;
    setup.gravity = GRAVITY;
    setup.walls = vec![wall("floor", floor(0.0))];
    setup.fills = vec![Fill {
        name: "pile".into(),
        pellets: 0,
        seats: Seats::Lattice {
            region: Shape::Cuboid {
                half_sides: Vec3::new(0.06, 0.06, 0.09),
            }
            .translated(Vec3::new(0.0, 0.0, 0.12)),
            amount: FillAmount::Count(PELLETS),
        },
        velocity: Vec3::new(0.4, 0.0, -1.0),
        spin: Vec3::zeros(),
    }];
    setup.outlets = vec![Outlet {
        name: "side".into(),
        region: Shape::HalfSpace {
            point: Vec3::new(0.2, 0.0, 0.0),
            normal: -Vec3::x_axis(),
        },
    }];
    setup
}

fn run(setup: Setup, threads: usize, stride: u64) -> (Vec<Hit>, Simulation) {
    let mut simulation = simulation_on(setup, threads);
    let mut hits = Vec::new();
    while simulation.step_count() < 14_000 {
        simulation.advance(stride).expect("the scene is sound");
        hits.extend(simulation.take_hits());
    }
    assert!(
        simulation.mass_ledger().discharged.count > 2,
        "some roll away"
    );
    (hits, simulation)
}

#[test]
fn all_hits_together_are_what_the_ledger_of_energy_says() {
    let (hits, simulation) = run(heap(ALL), 1, 400);
    let all = simulation.hits_with_open();
    let total = all.total();
    let statistics = simulation.contact_statistics();
    // Pellets that leave end contacts that the statistics of finished ones do not count.
    assert!(total.count >= statistics.finished + statistics.open);
    assert_eq!(total.count, (hits.len() + all.rows().len()) as u64);
    assert_eq!(all.rows().len() as u64, statistics.open);
    assert!(all.rows().iter().all(|hit| hit.is_open) && hits.iter().all(|hit| !hit.is_open));
    let books = &simulation.state().books.energy;
    // Of the step that is now the books hold half, the hits all.
    let half = 0.5 * simulation.model().time_step().seconds;
    let now = half * (books.powers.damping + books.powers.shear);
    // Sums of some 1e5 numbers in another order.
    let taken = books.damped + books.shear_work + now;
    assert!(
        (total.lost_energy / taken - 1.0).abs() < 1.0e-10,
        "{} {taken}",
        total.lost_energy
    );
    let of_rows: f64 = hits
        .iter()
        .chain(all.rows())
        .map(|hit| hit.lost_energy)
        .sum();
    assert!((of_rows / taken - 1.0).abs() < 1.0e-10);
}

#[test]
fn impulses_on_the_floor_are_what_stops_the_pellets() {
    let mut setup = heap(ALL);
    setup.outlets.clear();
    let mut simulation = simulation(setup);
    // Positions and half-step velocities are what the steps add up.
    let momentum = |simulation: &Simulation| -> f64 {
        let rows = simulation.state().pellets.half_step_velocity.iter();
        rows.map(|row| row[2] * row[3]).sum()
    };
    simulation.step().expect("nothing touches yet");
    let (before, begin) = (momentum(&simulation), simulation.time());
    simulation.advance(6000).expect("the scene is sound");
    let mass = simulation.mass_ledger().inside.mass;
    let weight = mass * -GRAVITY.z * (simulation.time() - begin);
    let all = simulation.hits_with_open();
    let on_floor: f64 = all
        .classes()
        .iter()
        .filter(|(key, _)| key.wall == Some(0))
        .map(|(_, class)| class.normal_impulse)
        .sum();
    let gained = momentum(&simulation) - before + weight;
    assert!(
        (on_floor / gained - 1.0).abs() < 1.0e-10,
        "{on_floor} {gained}"
    );
}

#[test]
fn threads_search_and_readings_change_no_row() {
    let (oracle, of_oracle) = run(heap(ALL), 1, 400);
    for (search, threads, stride) in [
        (NeighborSearch::Grid, 2, 25),
        (NeighborSearch::Tree, 3, 1000),
        (NeighborSearch::AllPairs, 1, 2000),
    ] {
        let mut setup = heap(ALL);
        setup.search = search;
        let (hits, simulation) = run(setup, threads, stride);
        assert!(hits == oracle, "{search:?}");
        assert!(
            simulation.hits_with_open() == of_oracle.hits_with_open(),
            "{search:?}"
        );
    }
}

#[test]
fn following_hits_changes_no_bit_of_the_state() {
    let (_, with) = run(heap(ALL), 1, 400);
    let (_, without) = run(heap(None), 1, 400);
    assert_eq!(with.state_hash(), without.state_hash());
}

#[test]
fn records_alone_tell_the_greatest_force_of_every_pellet() {
    let greatest = |(hits, simulation): (Vec<Hit>, Simulation)| {
        let mut of_pellets: BTreeMap<u32, f64> = BTreeMap::new();
        let open = simulation.hits_with_open();
        for hit in hits.iter().chain(open.rows()) {
            let other = match hit.partner {
                HitPartner::Pellet { id, .. } => Some(id),
                HitPartner::Wall(_) => None,
            };
            for id in [Some(hit.pellet), other].into_iter().flatten() {
                let force = of_pellets.entry(id).or_default();
                *force = force.max(hit.peak_force);
            }
        }
        (of_pellets, hits.len(), open.total())
    };
    let (all, rows, total) = greatest(run(heap(ALL), 1, 400));
    let (kept, few, same_total) = greatest(run(heap(RECORDS), 1, 400));
    assert_eq!(kept, all);
    assert_eq!(
        (total.count, total.lost_energy),
        (same_total.count, same_total.lost_energy)
    );
    assert!(3 * few < rows, "{few} of {rows}");
}

#[test]
fn every_row_of_a_flow_is_what_following_its_contact_alone_gives() {
    let mut setup = heap(ALL);
    setup.outlets.clear();
    let mut simulation = simulation(setup);
    let mut oracle = Oracle::default();
    let mut hits = Vec::new();
    while simulation.step_count() < 6000 {
        oracle.step(&simulation);
        simulation.step().expect("the scene is sound");
        hits.extend(simulation.take_hits());
    }
    assert!(hits.len() > 300, "{}", hits.len());
    assert_eq!(hits.len(), oracle.ended.len());
    let time_step = simulation.model().time_step().seconds;
    let mut between_steps = 0;
    for hit in &hits {
        let other = match hit.partner {
            HitPartner::Pellet { id, .. } => Some(id),
            HitPartner::Wall(_) => None,
        };
        let (a, b) = match other {
            Some(other) => (hit.pellet.min(other), Some(hit.pellet.max(other))),
            None => (hit.pellet, None),
        };
        let end = ((hit.begin + hit.duration) / time_step).round() as u64;
        let trace = &oracle.ended[&(a, b, end)];
        assert_eq!(hit.sampled_force, trace.force, "{hit:?} {trace:?}");
        assert_eq!(hit.steps, trace.steps);
        assert_eq!(
            hit.normal_impulse,
            time_step * trace.normal,
            "{hit:?} {trace:?}"
        );
        assert_eq!(hit.tangential_impulse, time_step * trace.tangential);
        assert_eq!(hit.lost_energy, time_step * trace.power);
        // Between two steps a hit rises by a few percent at most; single precision rounds it.
        let rise = hit.peak_force / hit.sampled_force;
        assert!((1.0..1.1).contains(&rise), "{rise}");
        between_steps += usize::from(rise > 1.0);
    }
    assert!(
        2 * between_steps > hits.len(),
        "{between_steps} of {}",
        hits.len()
    );
}

#[test]
fn a_hit_that_yields_has_the_force_that_its_row_tells_for_that_yield_pressure() {
    for speed in [0.5, 2.0, 5.0] {
        let (elastic, _) = hit_alone(1.0, speed, Against::Floor, 0.35);
        for share in [0.9, 0.5, 0.25] {
            let yield_pressure = share * elastic.peak_pressure;
            let properties = PairProperties {
                yield_pressure: Some(yield_pressure),
                ..smooth(1.0)
            };
            let mut setup = setup(properties, properties);
            setup.laws.normal = NormalLaw::Plastic;
            let (hit, _) = hit_of(setup, 1.0, speed, Against::Floor, 0.35);
            let told = elastic.yielded_force(yield_pressure);
            let error = (hit.peak_force / told - 1.0).abs();
            // The peak of a straight line is sampled, not followed.
            assert!(error < 2.0e-3, "{speed} m/s, {share}: {error:.5}");
            assert!(told < elastic.peak_force);
        }
    }
}
