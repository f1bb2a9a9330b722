//! Contacts between pellets.
//!
//! Two passes over a chunk: a filter that picks the touching pairs without a branch to mispredict, then the laws on
//! batches of those alone, several contacts to an instruction.
#![expect(
    clippy::inline_always,
    reason = "what is not inlined is not compiled for the instruction set"
)]

use crate::contact_view::KeptContact;
use crate::hit;
use crate::memory::ContactMemory;
use crate::model::Model;
use crate::share::Share;
use crate::state::{ChunkContacts, State};
use crate::tally::{DeepestContact, Partner, greater};
use crate::workspace::{ChunkList, ChunkScratch, Load, Touch, Workspace};
use pelletflow_core::Vec3;
use pelletflow_core::contact::batch::{Batch, LANES, Row, SpherePair};
use pelletflow_core::instructions::Task;
use std::ops::Range;

/// Adds the forces of all pairs that the chunk lists.
///
/// A pair across chunks is evaluated by both, each adding to its own pellet: the two results are exact
/// negatives, and no chunk writes to another's rows.
pub(crate) fn add_forces(share: &mut Share) {
    let instructions = share.model.instructions();
    match share.model.periodic() {
        None => instructions.run(AllPairs {
            share,
            image: |displacement| displacement,
        }),
        Some(periodic) => instructions.run(AllPairs {
            share,
            image: |displacement| periodic.nearest(displacement),
        }),
    }
}

/// Notes of new lists which of their pairs touched in the last step, as the memories tell, and whether they name anything.
pub(crate) fn note_lists(state: &State, workspace: &mut Workspace) {
    let lists = workspace.lists.iter().zip(&state.contacts);
    workspace
        .chunks
        .resize_with(lists.len(), ChunkScratch::default);
    for ((list, contacts), chunk) in lists.zip(&mut workspace.chunks) {
        chunk.touches = open_touches(list, contacts);
    }
    workspace.is_free = workspace
        .lists
        .iter()
        .all(|list| list.partners.is_empty() && list.near_walls.is_empty());
}

/// Pairs whose memory says that they touch.
fn open_touches(list: &ChunkList, contacts: &ChunkContacts) -> Vec<Touch> {
    let mut touches = Vec::new();
    for (local, ends) in list.offsets.windows(2).enumerate() {
        let open = (ends[0]..ends[1]).filter(|&slot| contacts.pellet.is_open(slot as usize));
        touches.extend(open.map(|slot| Touch {
            local: local as u32,
            slot,
        }));
    }
    touches
}

/// The pairs of a chunk; `image` gives the shortest image of a displacement [m].
struct AllPairs<'a, 'b, I> {
    share: &'a mut Share<'b>,
    image: I,
}

impl<I: Fn([f64; 3]) -> [f64; 3] + Copy> Task for AllPairs<'_, '_, I> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { share, image } = self;
        let last = std::mem::take(&mut share.scratch.touches);
        let mut touches = std::mem::take(&mut share.scratch.spare_touches);
        let gap = share.model.holding_gap();
        if gap > 0.0 {
            let held = |memory: &ContactMemory| if memory.steps > 0 { gap } else { 0.0 };
            find_touches(share, &mut touches, image, held);
        } else {
            find_touches(share, &mut touches, image, |_| 0.0);
        }
        end_contacts(share, &last, &touches);
        let mut batch = share
            .scratch
            .pairs
            .take()
            .unwrap_or_else(|| new_batch(share.model));
        for touches in touches.chunks(LANES) {
            add_batch(share, &mut batch, touches, image);
        }
        share.scratch.pairs = Some(batch);
        share.scratch.touches = touches;
        share.scratch.spare_touches = last;
    }
}

/// A batch of pairs, all of the first kind of pellets: where there are more, each is set when it is filled.
fn new_batch(model: &Model) -> Box<Batch> {
    let mut batch = Box::new(Batch::new(model.laws()));
    for lane in 0..LANES {
        batch.set_pair(lane, model.pair_of_kinds(0, 0));
    }
    batch
}

/// Lists the touching pairs.
///
/// A pair touches up to the gap `held` [m] by what it remembers.
#[inline(always)]
fn find_touches(
    share: &Share,
    touches: &mut Vec<Touch>,
    image: impl Fn([f64; 3]) -> [f64; 3],
    held: impl Fn(&ContactMemory) -> f64,
) {
    let positions = share.pellets.position;
    let partners = share.list.partners.as_slice();
    let memories = share.contacts.pellet.rows.as_slice();
    touches.resize(partners.len(), Touch::default());
    let room = touches.as_mut_slice();
    let mut found = 0;
    for (local, ends) in share.list.offsets.windows(2).enumerate() {
        let center = positions[share.range.start + local];
        for slot in ends[0]..ends[1] {
            let other = &positions[partners[slot as usize] as usize];
            let [dx, dy, dz] = image([
                center[0] - other[0],
                center[1] - other[1],
                center[2] - other[2],
            ]);
            let reach = center[3] + other[3] + held(&memories[slot as usize]);
            let is_touching = dx * dx + dy * dy + dz * dz < reach * reach;
            // Written in any case and kept only by the count: cheaper than a branch that half the slots take.
            room[found] = Touch {
                local: local as u32,
                slot,
            };
            found += usize::from(is_touching);
        }
    }
    touches.truncate(found);
}

/// Ends the contacts of pairs that touched in the last step and touch no more.
fn end_contacts(share: &mut Share, last: &[Touch], touches: &[Touch]) {
    if last == touches {
        return;
    }
    let mut present = touches.iter().peekable();
    for touch in last {
        while present.next_if(|now| now.slot < touch.slot).is_some() {}
        if present.next_if_eq(&touch).is_none() {
            end(share, *touch);
        }
    }
}

/// Ends the contact of a pair, if it was open.
#[cold]
#[inline(never)]
fn end(share: &mut Share, touch: Touch) {
    let ended = share.contacts.pellet.end(touch.slot as usize);
    let (a, b) = ends(share, touch);
    if ended.0 > 0 && is_counted(&share.range, a, b) {
        share.finish(a, Partner::Pellet(b), ended);
    }
}

/// The two pellets that touch, by index.
#[inline(always)]
fn ends(share: &Share, touch: Touch) -> (usize, usize) {
    let a = share.range.start + touch.local as usize;
    (a, share.list.partners[touch.slot as usize] as usize)
}

/// Whether a chunk enters a pair into its books: of two chunks that share one, that of the first pellet does.
#[inline(always)]
pub(crate) fn is_counted(range: &Range<usize>, a: usize, b: usize) -> bool {
    b > a || range.contains(&b)
}

/// Works out one batch of touching pairs and adds what they do.
#[inline(always)]
fn add_batch(
    share: &mut Share,
    batch: &mut Batch,
    touches: &[Touch],
    image: impl Fn([f64; 3]) -> [f64; 3],
) {
    let model = share.model;
    fill(share, batch, touches, image);
    let (sampling, instructions) = (model.sampling(), model.instructions());
    batch.meet(touches.len(), instructions);
    let laws = model.laws();
    laws.forces(batch, touches.len(), sampling, instructions);
    if model.follows_hits() {
        follow_all(share, batch, touches);
    }
    for (lane, touch) in touches.iter().enumerate() {
        let memories = &mut share.contacts.pellet;
        if !memories.step(touch.slot as usize, batch, lane) {
            end(share, *touch);
        }
    }
    add_loads(share, batch, touches);
    let tally = &mut share.scratch.tally;
    tally.totals.add(&batch.totals(touches.len()));
    tally.open += batch.counted(touches.len());
    let limit = model.setup().limits.overlap_ratio;
    let is_noteworthy = batch.exceeds_force(touches.len(), tally.noteworthy_force())
        || batch.exceeds_overlap(touches.len(), tally.noteworthy_overlap_ratio(limit));
    if is_noteworthy || share.keeps_contacts {
        look(share, batch, touches, is_noteworthy);
    }
}

/// Looks at the contacts of a batch: for records that they may hold, and for those who asked to see them.
#[cold]
#[inline(never)]
fn look(share: &mut Share, batch: &Batch, touches: &[Touch], is_noteworthy: bool) {
    for (lane, touch) in touches.iter().enumerate() {
        if is_noteworthy {
            look_closely(share, batch, lane, *touch);
        }
        if share.keeps_contacts {
            keep(share, batch, lane, *touch);
        }
    }
}

/// Follows the contacts of a batch one step on.
#[inline(always)]
fn follow_all(share: &mut Share, batch: &Batch, touches: &[Touch]) {
    let centers = &share.pellets.position[share.range.clone()];
    let memories = &mut share.contacts.pellet;
    for (lane, touch) in touches.iter().enumerate().take(LANES) {
        let (slot, center) = (touch.slot as usize, &centers[touch.local as usize]);
        hit::follow(share.model, memories, slot, (batch, lane), center);
    }
}

/// Fills a batch with touching pairs.
#[inline(always)]
fn fill(share: &Share, batch: &mut Batch, touches: &[Touch], image: impl Fn([f64; 3]) -> [f64; 3]) {
    let (model, pellets) = (share.model, share.pellets);
    let partners = share.list.partners.as_slice();
    let memories = &share.contacts.pellet;
    let range = share.range.clone();
    for (lane, touch) in touches.iter().enumerate() {
        let a = range.start + touch.local as usize;
        let b = partners[touch.slot as usize] as usize;
        let (first, second) = (&pellets.position[a], &pellets.position[b]);
        // Seen from the second, so that the two ends of a pair across chunks stay exact negatives.
        let [dx, dy, dz] = image([
            first[0] - second[0],
            first[1] - second[1],
            first[2] - second[2],
        ]);
        let (va, vb) = (&pellets.velocity[a], &pellets.velocity[b]);
        let pair = SpherePair {
            between: [dx, dy, dz, first[3]],
            other_radius: second[3],
            velocity: [va[0] - vb[0], va[1] - vb[1], va[2] - vb[2], va[3] + vb[3]],
            spins: [pellets.spin[a], pellets.spin[b]],
        };
        batch.set_spheres(lane, &pair, is_counted(&range, a, b));
        memories.fill(touch.slot as usize, batch, lane);
        if model.has_many_kinds() {
            batch.set_pair(lane, model.pair_of_kinds(pellets.kind[a], pellets.kind[b]));
        }
    }
}

/// Adds the forces and torques of a batch to the chunk's pellets.
#[inline(always)]
fn add_loads(share: &mut Share, batch: &Batch, touches: &[Touch]) {
    let rest = share.range.len();
    let start = share.range.start;
    let partners = share.list.partners.as_slice();
    let loads = share.scratch.loads.as_mut_slice();
    for (lane, touch) in touches.iter().enumerate() {
        let b = partners[touch.slot as usize] as usize;
        let force = batch.force(lane);
        let torques = batch.torques(lane);
        add_load(&mut loads[touch.local as usize], &force, &torques[0]);
        // What acts on another chunk's pellet goes to a row that nobody reads: cheaper than a branch.
        let other = b.wrapping_sub(start).min(rest);
        let reaction = [-force[0], -force[1], -force[2], force[3]];
        add_load(&mut loads[other], &reaction, &torques[1]);
    }
}

/// Keeps a contact of a batch, if it is the chunk's to count.
fn keep(share: &mut Share, batch: &Batch, lane: usize, touch: Touch) {
    let (a, b) = ends(share, touch);
    if is_counted(&share.range, a, b) {
        share.scratch.kept.push(KeptContact {
            pellet: a,
            partner: Partner::Pellet(b),
            ends: [share.pellets.position[a], share.pellets.position[b]],
            normal: batch.lie(lane).0,
            overlap: batch.overlap(lane),
            force: batch.force(lane),
        });
    }
}

/// Looks at a contact of a batch that may hold a record.
fn look_closely(share: &mut Share, batch: &Batch, lane: usize, touch: Touch) {
    let (model, pellets) = (share.model, share.pellets);
    let (a, b) = ends(share, touch);
    let pair = model.pair_of_kinds(pellets.kind[a], pellets.kind[b]);
    let smaller = pellets.position[a][3].min(pellets.position[b][3]);
    let depth = DeepestContact {
        ratio: batch.overlap(lane) / smaller,
        pellet: a,
        partner: Partner::Pellet(b),
    };
    let last = batch.history(lane, model.laws());
    let about = (&batch.contact(lane), pair, &last);
    let tally = &mut share.scratch.tally;
    tally.look_at(model, depth, batch.normal_force(lane), about);
}

/// Adds a force and a torque; of the normal forces the greatest is kept.
#[inline(always)]
pub(crate) fn add_load(load: &mut Load, force: &Row, torque: &Vec3) {
    for axis in 0..3 {
        load.force[axis] += force[axis];
        load.torque[axis] += torque[axis];
    }
    load.force[3] = greater(load.force[3], force[3]);
}
