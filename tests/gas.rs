//! Gases of pellets without gravity: energy over many collisions, and how it cools.

mod common;

use common::{RADIUS, held, one, setup, simulation_on, smooth, wall};
use pelletflow::core::contact::{TangentialLaw, TurningLaw};
use pelletflow::core::{Shape, UnitVector3, Vec3};
use pelletflow::sim::{Integrator, Simulation, StepRequest};
use std::f64::consts::PI;

/// A gas in a box with elastic walls.
struct Gas {
    /// Pellets along each side of the box [-].
    along: u32,
    /// Volume of the pellets over that of the box [-].
    volume_share: f64,
    /// Of pellets on pellets [-].
    restitution: f64,
    integrator: Integrator,
    /// Error of the peak force from which the step is chosen [-].
    error: f64,
}

impl Gas {
    fn count(&self) -> f64 {
        f64::from(self.along.pow(3))
    }

    fn volume(&self) -> f64 {
        self.count() * 4.0 / 3.0 * PI * RADIUS.powi(3) / self.volume_share
    }

    /// Pellets on a lattice, with velocities of any direction up to 1 m/s along each axis.
    fn started(&self) -> Simulation {
        let mut setup = setup(smooth(self.restitution), smooth(1.0));
        setup.laws.tangential = TangentialLaw::None;
        setup.laws.rolling = TurningLaw::None;
        setup.integrator = self.integrator;
        setup.step = StepRequest::PeakForceError(self.error);
        let side = self.volume().cbrt();
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut outward = Vec3::zeros();
                outward[axis] = sign;
                let plane = Shape::HalfSpace {
                    point: 0.5 * side * outward,
                    normal: UnitVector3::new_normalize(-outward),
                };
                // Of steel, and elastic where the pellets are not.
                setup.walls.push(wall(&format!("{axis} {sign}"), plane));
            }
        }
        let spacing = side / f64::from(self.along);
        let seat = |index: u32| (f64::from(index) + 0.5) * spacing - 0.5 * side;
        let mut random = Random(1);
        for i in 0..self.along {
            for j in 0..self.along {
                for k in 0..self.along {
                    let velocity = Vec3::from_fn(|_, _| random.symmetric());
                    let position = Vec3::new(seat(i), seat(j), seat(k));
                    setup
                        .fills
                        .push(one(&format!("{i} {j} {k}"), position, velocity));
                }
            }
        }
        simulation_on(setup, 2)
    }
}

/// Numbers that look random enough for velocities (Knuth's linear congruential generator).
struct Random(u64);

impl Random {
    /// From -1 to 1.
    fn symmetric(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

fn energy(simulation: &Simulation) -> f64 {
    let ledger = simulation.energy_ledger();
    ledger.kinetic + ledger.elastic
}

/// Share by which the energy of an elastic gas has changed after a number of collisions per pellet [-].
fn drift(gas: &Gas, collisions: f64) -> f64 {
    let mut simulation = gas.started();
    simulation.advance(1).expect("nothing touches yet");
    let before = energy(&simulation);
    let per_pellet = |simulation: &Simulation| {
        2.0 * simulation.contact_statistics().finished as f64 / gas.count()
    };
    while per_pellet(&simulation) < collisions {
        simulation.advance(500).expect("it is a gas");
    }
    energy(&simulation) / before - 1.0
}

const ELASTIC: Gas = Gas {
    along: 10,
    volume_share: 0.3,
    restitution: 1.0,
    integrator: Integrator::LocatedVerlet,
    error: 1.0e-4,
};

#[test]
fn an_elastic_gas_keeps_its_energy_over_hundreds_of_collisions_per_pellet() {
    let small = Gas {
        along: 6,
        ..ELASTIC
    };
    // The energy of a moment swings by this much with the contacts that are open.
    assert!(drift(&small, 300.0).abs() < 3.0e-4);
}

#[test]
#[ignore = "minutes; `cargo xtask verify` runs it"]
fn an_elastic_gas_keeps_its_energy_over_ten_thousand_collisions_per_pellet() {
    for (integrator, error, bound) in [
        (Integrator::LocatedVerlet, 1.0e-3, 4.0e-3),
        (Integrator::LocatedVerlet, 1.0e-4, 1.0e-3),
        (Integrator::VelocityVerlet, 1.0e-3, 1.0e-3),
    ] {
        let gas = Gas {
            integrator,
            error,
            ..ELASTIC
        };
        let claim = format!(
            "energy of 1,000 elastic pellets after 10,000 collisions each, {integrator:?} for a peak force within {} %",
            100.0 * error
        );
        held("gas", &claim, drift(&gas, 1.0e4), bound, "conservation");
    }
}

#[test]
fn a_dissipative_gas_cools_by_haffs_law() {
    let gas = Gas {
        along: 10,
        volume_share: 0.05,
        restitution: 0.9,
        integrator: Integrator::LocatedVerlet,
        error: 1.0e-3,
    };
    let mut simulation = gas.started();
    // A few collisions make the velocities those of a gas.
    let until = |simulation: &mut Simulation, collisions: f64| {
        while 2.0 * simulation.contact_statistics().finished as f64 / gas.count() < collisions {
            simulation.advance(100).expect("it is a gas");
        }
        (simulation.time(), simulation.energy_ledger().kinetic)
    };
    let (start, before) = until(&mut simulation, 4.0);
    let (end, after) = until(&mut simulation, 20.0);
    // Brilliantov & Pöschel (2004), eq. 5.9: the energy falls as (1 + t/τ)^-2, τ = 6/((1 − e²) ω), where
    // ω = 4 n d² g₀ √(π T/m) is how often a pellet collides at the start, g₀ = (1 − φ/2)/(1 − φ)³.
    let mass = 3700.0 * 4.0 / 3.0 * PI * RADIUS.powi(3);
    let thermal = before / gas.count() / mass / 1.5;
    let density = gas.count() / gas.volume();
    let crowding = (1.0 - 0.5 * gas.volume_share) / (1.0 - gas.volume_share).powi(3);
    let frequency = 4.0 * density * (2.0 * RADIUS).powi(2) * crowding * (PI * thermal).sqrt();
    let cooling_time = 6.0 / ((1.0 - 0.9_f64.powi(2)) * frequency);
    let found = (end - start) / ((before / after).sqrt() - 1.0);
    // A thousand pellets, some always at the walls, which take no energy but room.
    held(
        "gas",
        "cooling time of a gas of 1,000 pellets, restitution 0.9",
        found / cooling_time - 1.0,
        0.05,
        "Haff 1983; Brilliantov & Pöschel 2004",
    );
}
