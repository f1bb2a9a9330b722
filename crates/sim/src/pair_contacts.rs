//! Contacts between pellets.
//!
//! Two passes over a chunk: a filter that picks the touching pairs without a branch to mispredict, then the laws on
//! batches of those alone, several contacts to an instruction.

use crate::forces::ForceChunk;
use crate::memory::ContactMemory;
use crate::state::{Pellets, vector};
use crate::tally::Partner;
use crate::workspace::{Load, Touch};
use pelletflow_core::contact::batch::{Batch, LANES, Sphere};
use pelletflow_core::{ContactForce, Vec3};

/// Adds the forces of all pairs that the chunk lists.
///
/// A pair across chunks is evaluated by both, each adding to its own pellet: the two results are exact
/// negatives, and no chunk writes to another's rows.
pub(crate) fn add_forces(chunk: &mut ForceChunk) {
    let mut touches = std::mem::take(chunk.touches);
    find_touches(chunk, &mut touches);
    let mut batch = Batch::default();
    for lane in 0..LANES {
        batch.set_pair(lane, chunk.model.pair_of_kinds(0, 0));
    }
    for touches in touches.chunks(LANES) {
        add_batch(chunk, &mut batch, touches);
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
            if !is_touching && memories[slot].steps > 0 {
                if b as usize > a || chunk.range.contains(&(b as usize)) {
                    chunk.tally.finish(memories[slot].steps);
                }
                memories[slot] = ContactMemory::default();
            }
        }
    }
    touches.truncate(found);
}

/// Works out one batch of touching pairs and adds what they do.
fn add_batch(chunk: &mut ForceChunk, batch: &mut Batch, touches: &[Touch]) {
    let model = chunk.model;
    let pellets = chunk.pellets;
    for (lane, touch) in touches.iter().enumerate() {
        let a = chunk.range.start + touch.local as usize;
        let b = touch.partner as usize;
        let history = chunk.contacts.pellet[touch.slot as usize].history();
        batch.set(lane, &sphere(pellets, a), &sphere(pellets, b), &history);
        if model.has_many_kinds() {
            batch.set_pair(lane, model.pair_of_kinds(pellets.kind[a], pellets.kind[b]));
        }
    }
    model.laws().forces(batch, touches.len(), model.sampling());
    for (lane, touch) in touches.iter().enumerate() {
        add_force(chunk, batch, lane, *touch);
    }
}

#[inline]
fn add_force(chunk: &mut ForceChunk, batch: &Batch, lane: usize, touch: Touch) {
    let (local, b) = (touch.local as usize, touch.partner as usize);
    let a = chunk.range.start + local;
    let force = batch.force(lane);
    let memory = &mut chunk.contacts.pellet[touch.slot as usize];
    *memory = memory.stepped(&batch.next_history(lane));

    let (twist, arms) = (batch.twist(lane), batch.arms(lane));
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
        chunk.tally.open(
            &force,
            || (batch.contact(lane), batch.pair(lane), batch.history(lane)),
            chunk.model.sampling(),
        );
        let smaller = chunk.pellets.position[a][3].min(chunk.pellets.position[b][3]);
        chunk
            .tally
            .depth(batch.overlap(lane) / smaller, a, Partner::Pellet(b));
    }
}

#[inline]
fn sphere(pellets: &Pellets, index: usize) -> Sphere {
    let (position, velocity) = (&pellets.position[index], &pellets.velocity[index]);
    Sphere {
        center: vector(position),
        radius: position[3],
        velocity: vector(velocity),
        spin: vector(&pellets.spin[index]),
        inverse_mass: velocity[3],
    }
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
