//! Contacts between pellets.
//!
//! Two passes over a chunk: a filter that picks the touching pairs without a branch to mispredict, then the laws on
//! batches of those alone, several contacts to an instruction.

use crate::forces::ForceChunk;
use crate::memory::ContactMemory;
use crate::state::{Pellets, vector};
use crate::tally::{DeepestContact, Partner};
use crate::workspace::{Load, Touch};
use pelletflow_core::contact::batch::{Batch, LANES, Sphere};
use pelletflow_core::{ContactForce, ContactHistory, Vec3};
use std::ops::Range;

/// Adds the forces of all pairs that the chunk lists.
///
/// A pair across chunks is evaluated by both, each adding to its own pellet: the two results are exact
/// negatives, and no chunk writes to another's rows.
pub(crate) fn add_forces(chunk: &mut ForceChunk) {
    match chunk.model.periodic() {
        None => add_all(chunk, |displacement| displacement),
        Some(periodic) => add_all(chunk, |displacement| periodic.nearest(displacement)),
    }
}

/// Adds the forces; `image` gives the shortest image of a displacement [m].
fn add_all(chunk: &mut ForceChunk, image: impl Fn([f64; 3]) -> [f64; 3] + Copy) {
    let mut touches = std::mem::take(chunk.touches);
    let gap = chunk.model.holding_gap();
    if gap > 0.0 {
        let held = |memory: &ContactMemory| if memory.steps > 0 { gap } else { 0.0 };
        find_touches(chunk, &mut touches, image, held);
    } else {
        find_touches(chunk, &mut touches, image, |_| 0.0);
    }
    let mut batch = Batch::default();
    for lane in 0..LANES {
        batch.set_pair(lane, chunk.model.pair_of_kinds(0, 0));
    }
    for touches in touches.chunks(LANES) {
        add_batch(chunk, &mut batch, touches, image);
    }
    *chunk.touches = touches;
}

/// Lists the touching pairs, and ends the contacts of those that touch no more.
///
/// A pair touches up to the gap `held` [m] by what it remembers.
fn find_touches(
    chunk: &mut ForceChunk,
    touches: &mut Vec<Touch>,
    image: impl Fn([f64; 3]) -> [f64; 3],
    held: impl Fn(&ContactMemory) -> f64,
) {
    let positions = chunk.pellets.position.as_slice();
    let partners = chunk.list.partners.as_slice();
    let memories = &mut chunk.contacts.pellet;
    touches.clear();
    touches.resize(partners.len(), Touch::default());
    let mut found = 0;
    for (local, ends) in chunk.list.offsets.windows(2).enumerate() {
        let a = chunk.range.start + local;
        let center = positions[a];
        let slots = ends[0] as usize..ends[1] as usize;
        for (&b, slot) in partners[slots.clone()].iter().zip(slots) {
            let other = &positions[b as usize];
            let [dx, dy, dz] = image([
                center[0] - other[0],
                center[1] - other[1],
                center[2] - other[2],
            ]);
            let reach = center[3] + other[3] + held(&memories.rows[slot]);
            let is_touching = dx * dx + dy * dy + dz * dz < reach * reach;
            // Written in any case and kept only by the count: cheaper than a branch that half the slots take.
            touches[found] = Touch {
                local: local as u32,
                partner: b,
                slot: slot as u32,
            };
            found += usize::from(is_touching);
            let steps = memories.rows[slot].steps;
            if !is_touching && steps > 0 {
                if is_counted(&chunk.range, a, b as usize) {
                    chunk.tally.finish(steps);
                }
                memories.forget(slot);
            }
        }
    }
    touches.truncate(found);
}

/// Whether a chunk enters a pair into its books: of two chunks that share one, that of the first pellet does.
#[inline]
fn is_counted(range: &Range<usize>, a: usize, b: usize) -> bool {
    b > a || range.contains(&b)
}

/// Works out one batch of touching pairs and adds what they do.
fn add_batch(
    chunk: &mut ForceChunk,
    batch: &mut Batch,
    touches: &[Touch],
    image: impl Fn([f64; 3]) -> [f64; 3],
) {
    let model = chunk.model;
    let pellets = chunk.pellets;
    for (lane, touch) in touches.iter().enumerate() {
        let a = chunk.range.start + touch.local as usize;
        let b = touch.partner as usize;
        let history = chunk.contacts.pellet.rows[touch.slot as usize].history();
        let (mut first, mut second) = (sphere(pellets, a), sphere(pellets, b));
        // Seen from the second, so that the two ends of a pair across chunks stay exact negatives.
        first.center = Vec3::from(image((first.center - second.center).into()));
        second.center = Vec3::zeros();
        batch.set(lane, &first, &second, &history);
        if model.has_many_kinds() {
            batch.set_pair(lane, model.pair_of_kinds(pellets.kind[a], pellets.kind[b]));
        }
    }
    if model.laws().forces(batch, touches.len(), model.sampling()) {
        for (lane, touch) in touches.iter().enumerate() {
            let memory = &mut chunk.contacts.pellet.rows[touch.slot as usize];
            *memory = memory.stepped(&batch.next_history(lane));
            add_force(chunk, batch, lane, *touch, || batch.history(lane));
        }
    } else {
        for (lane, touch) in touches.iter().enumerate() {
            add_single(chunk, batch, lane, *touch);
        }
    }
}

/// Works out one contact by laws that have no batch, and adds what it does.
fn add_single(chunk: &mut ForceChunk, batch: &mut Batch, lane: usize, touch: Touch) {
    let (model, laws) = (chunk.model, chunk.model.laws());
    let a = chunk.range.start + touch.local as usize;
    let (b, slot) = (touch.partner as usize, touch.slot as usize);
    let pair = model.pair_of_kinds(chunk.pellets.kind[a], chunk.pellets.kind[b]);
    let contact = batch.contact(lane);
    let last = chunk.contacts.pellet.history(slot, laws);
    let mut history = last;
    let force = laws.force(&contact, pair, &mut history, model.sampling());
    batch.set_force(lane, &contact, &force, &history);
    let steps = chunk.contacts.pellet.rows[slot].steps;
    let is_open = chunk.contacts.pellet.step(slot, &history, laws);
    if !is_open && is_counted(&chunk.range, a, b) {
        chunk.tally.finish(steps);
    }
    add_force(chunk, batch, lane, touch, || last);
}

/// Adds the force of a lane; `last` gives what the contact remembered before.
#[inline]
fn add_force(
    chunk: &mut ForceChunk,
    batch: &Batch,
    lane: usize,
    touch: Touch,
    last: impl Fn() -> ContactHistory,
) {
    let (local, b) = (touch.local as usize, touch.partner as usize);
    let a = chunk.range.start + local;
    let force = batch.force(lane);
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
    if is_counted(&chunk.range, a, b) {
        let kind = &chunk.pellets.kind;
        let pair = || *chunk.model.pair_of_kinds(kind[a], kind[b]);
        let smaller = chunk.pellets.position[a][3].min(chunk.pellets.position[b][3]);
        let depth = DeepestContact {
            ratio: batch.overlap(lane) / smaller,
            pellet: a,
            partner: Partner::Pellet(b),
        };
        let contact = || (batch.contact(lane), pair(), last());
        chunk.tally.open(&force, depth, contact, chunk.model);
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

/// Adds a force with a sign, its moment, and the turning torque with the same sign.
#[inline]
pub(crate) fn add_load(load: &mut Load, force: &ContactForce, sign: f64, moment: Vec3) {
    let torque = moment + sign * force.turning_torque;
    for axis in 0..3 {
        load.force[axis] += sign * force.force[axis];
        load.torque[axis] += torque[axis];
    }
    load.force[3] = load.force[3].max(force.normal);
}
