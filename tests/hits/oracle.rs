//! Contacts followed one by one: what the ledger of hits is held against.

use crate::common::{ORE, STEEL};
use pelletflow::core::contact::batch::SpherePair;
use pelletflow::core::contact::{Batch, Sampling, curvature};
use pelletflow::core::{Contact, ContactHistory, InstructionSet, MaterialPair, Vec3};
use pelletflow::sim::Simulation;
use std::collections::BTreeMap;

/// What a contact did, followed one by one.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Trace {
    pub(super) history: ContactHistory,
    pub(super) steps: u64,
    pub(super) force: f64,
    pub(super) normal: f64,
    pub(super) tangential: f64,
    pub(super) power: f64,
}

/// Follows every pair of pellets and every pellet on the floor at every step, by the law of a single contact.
#[derive(Debug, Default)]
pub(super) struct Oracle {
    pub(super) open: BTreeMap<(u32, Option<u32>), Trace>,
    pub(super) ended: BTreeMap<(u32, Option<u32>, u64), Trace>,
}

impl Oracle {
    pub(super) fn step(&mut self, simulation: &Simulation) {
        let pellets = &simulation.state().pellets;
        for a in 0..pellets.len() {
            let id = pellets.id[a];
            let (position, velocity) = (&pellets.position[a], &pellets.velocity[a]);
            let overlap = position[3] - position[2];
            let contact = (overlap > 0.0).then(|| {
                let arm = position[3] - 0.5 * overlap;
                let spin = Vec3::new(pellets.spin[a][0], pellets.spin[a][1], pellets.spin[a][2]);
                let speed = Vec3::new(velocity[0], velocity[1], velocity[2]);
                Contact {
                    normal: Vec3::z(),
                    overlap,
                    relative_velocity: speed - arm * spin.cross(&Vec3::z()),
                    relative_spin: spin,
                    effective_radius: curvature::effective_radius([1.0 / position[3]; 2]),
                    effective_mass: 1.0 / velocity[3],
                    inverse_mass: velocity[3],
                }
            });
            self.touch(simulation, (id, None), contact);
            for b in 0..pellets.len() {
                let other = pellets.id[b];
                if id < other {
                    self.touch(simulation, (id, Some(other)), between(simulation, a, b));
                }
            }
        }
    }

    fn touch(
        &mut self,
        simulation: &Simulation,
        key: (u32, Option<u32>),
        contact: Option<Contact>,
    ) {
        let step = simulation.step_count();
        let Some(contact) = contact else {
            if let Some(trace) = self.open.remove(&key) {
                self.ended.insert((key.0, key.1, step), trace);
            }
            return;
        };
        let setup = simulation.model().setup();
        let materials = [ORE, key.1.map_or(STEEL, |_| ORE)];
        let [a, b] = materials.map(|index| &setup.materials[index].material);
        let properties = setup.pair_properties(materials[0], materials[1]);
        let pair = MaterialPair::new(a, b, properties.expect("all pairs are given"));
        let sampling = Sampling::located(simulation.model().time_step().seconds);
        let trace = self.open.entry(key).or_default();
        let force = setup
            .laws
            .force(&contact, &pair, &mut trace.history, &sampling);
        trace.force = trace.force.max(force.normal);
        trace.normal += trace.history.normal_force;
        trace.tangential += force.tangential;
        trace.power += force.dissipation + force.shear_power;
        if trace.history.normal_force == 0.0 {
            let trace = self.open.remove(&key).expect("it was just there");
            if trace.steps > 0 {
                self.ended.insert((key.0, key.1, step), trace);
            }
            return;
        }
        trace.steps += 1;
        // A memory keeps this force in single precision, and 0 for a contact that is over alone.
        let rounded = trace.history.normal_force as f32;
        trace.history.normal_force = f64::from(if rounded == 0.0 {
            f32::MIN_POSITIVE
        } else {
            rounded
        });
    }
}

/// The contact of two pellets, seen from the first.
fn between(simulation: &Simulation, a: usize, b: usize) -> Option<Contact> {
    let pellets = &simulation.state().pellets;
    let (first, second) = (&pellets.position[a], &pellets.position[b]);
    let (va, vb) = (&pellets.velocity[a], &pellets.velocity[b]);
    let away = [0, 1, 2].map(|axis| first[axis] - second[axis]);
    let reach = first[3] + second[3];
    let is_touching = away[0] * away[0] + away[1] * away[1] + away[2] * away[2] < reach * reach;
    is_touching.then(|| {
        let mut batch = Batch::new(simulation.model().setup().laws);
        let pair = SpherePair {
            between: [away[0], away[1], away[2], first[3]],
            other_radius: second[3],
            velocity: [va[0] - vb[0], va[1] - vb[1], va[2] - vb[2], va[3] + vb[3]],
            spins: [pellets.spin[a], pellets.spin[b]],
        };
        batch.set_spheres(0, &pair, true);
        batch.meet(1, InstructionSet::Baseline);
        batch.contact(0)
    })
}
