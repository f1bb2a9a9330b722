//! One chunk's share of a step: what it reads, and what only it writes.

use crate::chunk;
use crate::hit::{Ended, Trace};
use crate::model::Model;
use crate::profile::{self, Profile, Stage};
use crate::state::{ChunkContacts, Row, State};
use crate::tally::Partner;
use crate::wall::WallNow;
use crate::workspace::{ChunkList, ChunkScratch, Load, Workspace};
use std::ops::Range;
use std::time::Instant;

/// A chunk at work.
///
/// Pellets are read as they are and written as they will be, so that no chunk sees what another has already moved.
pub(crate) struct Share<'a> {
    pub(crate) model: &'a Model,
    pub(crate) walls: &'a [WallNow],
    /// Steps taken before this one [-].
    pub(crate) step: u64,
    pub(crate) pellets: Columns<'a>,
    /// The chunk's pellets.
    pub(crate) range: Range<usize>,
    pub(crate) list: &'a ChunkList,
    /// Whether contacts are kept for those who look.
    pub(crate) keeps_contacts: bool,
    pub(crate) contacts: &'a mut ChunkContacts,
    pub(crate) scratch: &'a mut ChunkScratch,
    pub(crate) half_step_velocity: &'a mut [Row],
    pub(crate) half_step_spin: &'a mut [Row],
    pub(crate) next_position: &'a mut [Row],
    pub(crate) next_velocity: &'a mut [Row],
    pub(crate) next_spin: &'a mut [Row],
}

/// What every chunk may read of all pellets.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Columns<'a> {
    pub(crate) kind: &'a [u16],
    pub(crate) position: &'a [Row],
    pub(crate) velocity: &'a [Row],
    pub(crate) spin: &'a [Row],
}

impl Share<'_> {
    /// Does one stage.
    #[inline]
    pub(crate) fn stage(&mut self, stage: Stage, run: impl FnOnce(&mut Self)) {
        let start = self.scratch.clock.now();
        run(self);
        self.scratch.clock.enter(stage, start);
    }

    /// Enters the end of a contact of a pellet, by index, that was open for some steps.
    pub(crate) fn finish(
        &mut self,
        pellet: usize,
        partner: Partner,
        (steps, trace): (u32, Option<Trace>),
    ) {
        self.scratch.tally.finish(steps);
        self.scratch.ended.extend(trace.map(|trace| Ended {
            pellet,
            partner,
            steps,
            trace,
        }));
    }

    /// Time at the start of the step [s].
    pub(crate) fn time(&self) -> f64 {
        self.step as f64 * self.model.time_step().seconds
    }
}

/// Has every chunk do its share, and puts what they did together into the workspace's tally.
///
/// Each pellet's forces are summed by its own chunk in list order, and chunks are put together in their own order, so the
/// bits do not depend on the threads.
pub(crate) fn each_chunk(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    profile: &mut Profile,
    run: impl Fn(&mut Share) + Sync + Send,
) {
    let State {
        step,
        pellets,
        contacts,
        books,
        ..
    } = state;
    let count = pellets.len();
    workspace.next.resize(count);
    workspace
        .chunks
        .resize_with(contacts.len(), ChunkScratch::default);
    let columns = Columns {
        kind: &pellets.kind,
        position: &pellets.position,
        velocity: &pellets.velocity,
        spin: &pellets.spin,
    };
    let (step, walls, size) = (*step, workspace.walls.as_slice(), chunk::size(count));
    let keeps_contacts = workspace.keeps_contacts;
    let shares = chunk::ranges(count)
        .zip(&workspace.lists)
        .zip(contacts)
        .zip(&mut workspace.chunks)
        .zip(pellets.half_step_velocity.chunks_mut(size))
        .zip(pellets.half_step_spin.chunks_mut(size))
        .zip(workspace.next.position.chunks_mut(size))
        .zip(workspace.next.velocity.chunks_mut(size))
        .zip(workspace.next.spin.chunks_mut(size))
        .map(|((((row, own_spin), position), velocity), spin)| {
            let ((((range, list), contacts), scratch), own_velocity) = row;
            Share {
                model,
                walls,
                step,
                pellets: columns,
                range,
                list,
                keeps_contacts,
                contacts,
                scratch,
                half_step_velocity: own_velocity,
                half_step_spin: own_spin,
                next_position: position,
                next_velocity: velocity,
                next_spin: spin,
            }
        });
    let so_far = &books.contacts;
    let start = profile::is_timed(step).then(Instant::now);
    chunk::for_each(workspace.is_parallel, shares, |mut share| {
        let scratch = &mut *share.scratch;
        scratch.tally.begin(walls.len(), so_far);
        scratch.ended.clear();
        scratch.clock.begin(step);
        scratch.loads.clear();
        scratch.loads.resize(share.range.len() + 1, Load::default());
        run(&mut share);
    });
    if let Some(start) = start {
        let clocks = workspace.chunks.iter().map(|chunk| &chunk.clock);
        profile.share_out(start.elapsed(), clocks);
    }
    workspace.tally.begin(walls.len(), so_far);
    for chunk in &workspace.chunks {
        workspace.tally.add(&chunk.tally);
    }
}
