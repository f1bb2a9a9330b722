//! Contacts between pellets.
//!
//! Two passes over a chunk: a filter that picks the touching pairs without a branch to mispredict, then the laws on
//! those alone, so that the processor works on several contacts at once.

use crate::forces::ForceChunk;
use crate::state::{Pellets, row, vector};
use crate::tally::Partner;
use crate::workspace::{Load, Touch};
use pelletflow_core::{Contact, ContactForce, ContactHistory, Vec3};

/// Adds the forces of all pairs that the chunk lists.
///
/// A pair across chunks is evaluated by both, each adding to its own pellet: the two results are exact
/// negatives, and no chunk writes to another's rows.
pub(crate) fn add_forces(chunk: &mut ForceChunk) {
    let mut touches = std::mem::take(chunk.touches);
    find_touches(chunk, &mut touches);
    for &touch in &touches {
        add_force(chunk, touch);
    }
    *chunk.touches = touches;
}

/// Lists the touching pairs, and ends the contacts of those that touch no more.
fn find_touches(chunk: &mut ForceChunk, touches: &mut Vec<Touch>) {
    let positions = chunk.pellets.position.as_slice();
    let partners = chunk.list.partners.as_slice();
    let memories = chunk.contacts.pellet.as_mut_slice();
    touches.clear();
    touches.resize(partners.len(), Touch::default());
    let mut found = 0;
    for (local, ends) in chunk.list.offsets.windows(2).enumerate() {
        let a = chunk.range.start + local;
        let center = positions[a];
        for slot in ends[0] as usize..ends[1] as usize {
            let b = partners[slot];
            let other = &positions[b as usize];
            let (dx, dy, dz) = (
                center[0] - other[0],
                center[1] - other[1],
                center[2] - other[2],
            );
            let reach = center[3] + other[3];
            let is_touching = dx * dx + dy * dy + dz * dz < reach * reach;
            // Written in any case and kept only by the count: cheaper than a branch that half the slots take.
            touches[found] = Touch {
                local: local as u32,
                partner: b,
                slot: slot as u32,
            };
            found += usize::from(is_touching);
            if !is_touching && memories[slot][3] > 0.0 {
                if b as usize > a || chunk.range.contains(&(b as usize)) {
                    chunk.tally.finish(memories[slot][3]);
                }
                memories[slot] = [0.0; 4];
            }
        }
    }
    touches.truncate(found);
}

#[inline]
fn add_force(chunk: &mut ForceChunk, touch: Touch) {
    let (local, b, slot) = (
        touch.local as usize,
        touch.partner as usize,
        touch.slot as usize,
    );
    let a = chunk.range.start + local;
    let model = chunk.model;
    let time_step = model.time_step().seconds;
    let (contact, arms) = contact_of(chunk.pellets, a, b, model.has_rotation());
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

/// The contact of two touching pellets seen from `a`, and the arms from both centers to its middle [m].
#[inline]
fn contact_of(pellets: &Pellets, a: usize, b: usize, has_rotation: bool) -> (Contact, [f64; 2]) {
    let (center, other) = (&pellets.position[a], &pellets.position[b]);
    let between = vector(center) - vector(other);
    let distance = between.norm();
    let normal = between * (1.0 / distance);
    let radii_sum = center[3] + other[3];
    let overlap = radii_sum - distance;
    let arms = [center[3] - 0.5 * overlap, other[3] - 0.5 * overlap];
    let (velocity, other_velocity) = (&pellets.velocity[a], &pellets.velocity[b]);
    let mut relative_velocity = vector(velocity) - vector(other_velocity);
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
        effective_radius: center[3] * other[3] / radii_sum,
        effective_mass: 1.0 / (velocity[3] + other_velocity[3]),
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
