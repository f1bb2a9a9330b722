//! Contacts between pellets.

use crate::forces::ForceChunk;
use crate::state::{Pellets, Row, row, vector};
use crate::tally::Partner;
use crate::workspace::Load;
use pelletflow_core::{Contact, ContactForce, ContactHistory, Vec3};

/// Adds the forces of all pairs that the chunk lists.
///
/// A pair across chunks is evaluated by both, each adding to its own pellet: the two results are exact
/// negatives, and no chunk writes to another's rows.
pub(crate) fn add_forces(chunk: &mut ForceChunk) {
    let positions = &chunk.pellets.position;
    for local in 0..chunk.range.len() {
        let a = chunk.range.start + local;
        let center = positions[a];
        let slots = chunk.list.offsets[local] as usize..chunk.list.offsets[local + 1] as usize;
        for slot in slots {
            let b = chunk.list.partners[slot] as usize;
            let other = &positions[b];
            let between = Vec3::new(
                center[0] - other[0],
                center[1] - other[1],
                center[2] - other[2],
            );
            let reach = center[3] + other[3];
            let squared = between.norm_squared();
            if squared < reach * reach {
                touch(chunk, local, b, slot, between, squared.sqrt());
            } else if chunk.contacts.pellet[slot][3] > 0.0 {
                let is_counted_here = b > a || chunk.range.contains(&b);
                if is_counted_here {
                    chunk.tally.finish(chunk.contacts.pellet[slot][3]);
                }
                chunk.contacts.pellet[slot] = [0.0; 4];
            }
        }
    }
}

#[inline]
fn touch(
    chunk: &mut ForceChunk,
    local: usize,
    b: usize,
    slot: usize,
    between: Vec3,
    distance: f64,
) {
    let a = chunk.range.start + local;
    let model = chunk.model;
    let time_step = model.time_step().seconds;
    let (contact, arms) = contact_of(chunk.pellets, a, b, between, distance, model.has_rotation());
    let pair = model.pair_of_kinds(chunk.pellets.kind[a], chunk.pellets.kind[b]);
    let memory = &mut chunk.contacts.pellet[slot];
    let mut history = ContactHistory {
        tangential_displacement: vector(memory),
    };
    let force = model.laws().force(&contact, pair, &mut history, time_step);
    *memory = row(history.tangential_displacement, memory[3] + 1.0);

    let twist = contact.normal.cross(&force.force);
    add_load(&mut chunk.loads[local], &force, 1.0, -arms[0] * twist);
    let is_in_chunk = chunk.range.contains(&b);
    if is_in_chunk {
        add_load(
            &mut chunk.loads[b - chunk.range.start],
            &force,
            -1.0,
            -arms[1] * twist,
        );
    }
    if is_in_chunk || b > a {
        chunk.tally.open(&contact, pair, &force, time_step);
        let smaller = chunk.pellets.position[a][3].min(chunk.pellets.position[b][3]);
        chunk
            .tally
            .depth(contact.overlap / smaller, a, Partner::Pellet(b));
    }
}

/// The contact seen from `a`, and the arms from both centers to its middle [m].
#[inline]
fn contact_of(
    pellets: &Pellets,
    a: usize,
    b: usize,
    between: Vec3,
    distance: f64,
    has_rotation: bool,
) -> (Contact, [f64; 2]) {
    let radii = [pellets.position[a][3], pellets.position[b][3]];
    let velocities: [&Row; 2] = [&pellets.velocity[a], &pellets.velocity[b]];
    let normal = between / distance;
    let overlap = radii[0] + radii[1] - distance;
    let arms = [radii[0] - 0.5 * overlap, radii[1] - 0.5 * overlap];
    let mut relative_velocity = vector(velocities[0]) - vector(velocities[1]);
    let mut relative_spin = Vec3::zeros();
    if has_rotation {
        let spins = [vector(&pellets.spin[a]), vector(&pellets.spin[b])];
        relative_velocity -= (arms[0] * spins[0] + arms[1] * spins[1]).cross(&normal);
        relative_spin = spins[0] - spins[1];
    }
    let contact = Contact {
        normal,
        overlap,
        relative_velocity,
        relative_spin,
        effective_radius: radii[0] * radii[1] / (radii[0] + radii[1]),
        effective_mass: 1.0 / (velocities[0][3] + velocities[1][3]),
    };
    (contact, arms)
}

/// Adds a force with a sign, its moment, and the rolling torque with the same sign.
#[inline]
pub(crate) fn add_load(load: &mut Load, force: &ContactForce, sign: f64, moment: Vec3) {
    let torque = moment + sign * force.rolling_torque;
    for axis in 0..3 {
        load.force[axis] += sign * force.force[axis];
        load.torque[axis] += torque[axis];
    }
    load.force[3] = load.force[3].max(force.normal);
}
