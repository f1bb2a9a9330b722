//! Contacts that end, and those still open, as rows of the ledger.

use super::ledger::IsKept;
use super::{Cause, Hit, HitLedger, HitPartner, Trace};
use crate::memory::ContactMemories;
use crate::model::Model;
use crate::state::{Pellets, State};
use crate::tally::Partner;
use crate::workspace::{ChunkList, Workspace};
use crate::{chunk, pair_contacts};
use pelletflow_impact::ElasticImpact;

/// How many times the force of its own arrival a hit must have before the bed is what squeezes it [-].
///
/// The arrival counts as elastic. Damping takes up to half of that force, so a hit beyond it is not one by itself; one
/// whose arrival explains it to a half may have help, and counts as an arrival all the same.
const SQUEEZED: f64 = 2.0;

/// A contact that has ended.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ended {
    /// The pellet, by index.
    pub(crate) pellet: usize,
    pub(crate) partner: Partner,
    /// Steps that it lasted.
    pub(crate) steps: u32,
    pub(crate) trace: Trace,
}

/// Enters the hits that ended in this step, chunk by chunk.
pub(crate) fn enter(model: &Model, state: &mut State, workspace: &Workspace) {
    let State {
        step,
        pellets,
        hits,
        ..
    } = state;
    for ended in workspace.chunks.iter().flat_map(|chunk| &chunk.ended) {
        enter_one(model, *step, pellets, hits, ended);
    }
}

/// Ends the contacts of pellets that are not kept.
pub(crate) fn end_leaving(model: &Model, state: &mut State, workspace: &Workspace, kept: &[u32]) {
    let listed = state.searched_position.len();
    let mut leaves = vec![true; state.pellets.len()];
    for &index in kept {
        leaves[index as usize] = false;
    }
    if model.setup().hits.is_none() || !leaves.contains(&true) {
        return;
    }
    let ended: Vec<Ended> = open_contacts(state, &workspace.lists, listed)
        .filter(|ended| {
            let partner_leaves = matches!(ended.partner, Partner::Pellet(other) if leaves[other]);
            leaves[ended.pellet] || partner_leaves
        })
        .collect();
    for ended in &ended {
        enter_one(
            model,
            state.step,
            &mut state.pellets,
            &mut state.hits,
            ended,
        );
    }
}

/// The ledger as if every open contact ended now: its sketch with them, and of its rows only theirs.
pub(crate) fn open(model: &Model, state: &State, lists: &[ChunkList]) -> HitLedger {
    let mut ledger = state.hits.clone();
    ledger.take_rows();
    if model.setup().hits.is_some() {
        let mut pellets = state.pellets.clone();
        for ended in open_contacts(state, lists, state.searched_position.len()) {
            enter_one(model, state.step, &mut pellets, &mut ledger, &ended);
        }
    }
    ledger.mark_open();
    ledger
}

/// Every open contact that a chunk counts, among a number of pellets that are listed.
fn open_contacts<'a>(
    state: &'a State,
    lists: &'a [ChunkList],
    pellets: usize,
) -> impl Iterator<Item = Ended> + 'a {
    let chunks = chunk::ranges(pellets).zip(lists).zip(&state.contacts);
    chunks.flat_map(|((range, list), contacts)| {
        let start = range.start;
        let of_pellets = list
            .offsets
            .windows(2)
            .enumerate()
            .flat_map(move |(local, ends)| {
                (ends[0] as usize..ends[1] as usize).map(move |slot| (start + local, slot))
            })
            .map(|(pellet, slot)| (pellet, slot, list.partners[slot] as usize))
            .filter(move |&(a, _, b)| pair_contacts::is_counted(&range, a, b))
            .filter_map(|(a, slot, b)| ended(&contacts.pellet, slot, a, Partner::Pellet(b)));
        let of_walls = list
            .near_walls
            .iter()
            .enumerate()
            .filter_map(move |(slot, near)| {
                let partner = Partner::Wall(near.wall as usize);
                ended(&contacts.wall, slot, start + near.pellet as usize, partner)
            });
        of_pellets.chain(of_walls)
    })
}

fn ended(
    memories: &ContactMemories,
    slot: usize,
    pellet: usize,
    partner: Partner,
) -> Option<Ended> {
    memories.is_open(slot).then(|| Ended {
        pellet,
        partner,
        steps: memories.rows[slot].steps,
        trace: memories.traces[slot],
    })
}

/// Enters one contact that ends before a step.
fn enter_one(
    model: &Model,
    step: u64,
    pellets: &mut Pellets,
    ledger: &mut HitLedger,
    ended: &Ended,
) {
    let Some(request) = &model.setup().hits else {
        return;
    };
    let hit = row(model, step, pellets, ended);
    let mut is_hardest = hit.peak_force > pellets.hardest_hit[ended.pellet];
    let mut endure = |index: usize| {
        let hardest = &mut pellets.hardest_hit[index];
        is_hardest |= hit.peak_force > *hardest;
        *hardest = hardest.max(hit.peak_force);
    };
    endure(ended.pellet);
    if let Partner::Pellet(other) = ended.partner {
        endure(other);
    }
    let is_kept = if is_hardest || hit.peak_force >= request.threshold {
        IsKept::InFull
    } else {
        IsKept::InSums
    };
    ledger.enter(hit, is_kept);
}

/// A contact that ends before a step, told in full.
fn row(model: &Model, step: u64, pellets: &Pellets, ended: &Ended) -> Hit {
    let time_step = model.time_step().seconds;
    let trace = &ended.trace;
    let (kind, inverse_mass) = (
        pellets.kind[ended.pellet],
        pellets.velocity[ended.pellet][3],
    );
    let setup = model.setup();
    let material = setup.pellets[usize::from(kind)].material;
    let (partner, other_material, pair, inverse_mass) = match ended.partner {
        Partner::Pellet(other) => (
            HitPartner::Pellet {
                id: pellets.id[other],
                diameter: 2.0 * pellets.position[other][3],
                mass: pellets.mass(other),
            },
            setup.pellets[usize::from(pellets.kind[other])].material,
            model.pair_of_kinds(kind, pellets.kind[other]),
            inverse_mass + pellets.velocity[other][3],
        ),
        Partner::Wall(wall) => (
            HitPartner::Wall(wall),
            setup.walls[wall].material,
            model.pair_with_wall(kind, wall),
            inverse_mass,
        ),
    };
    let arrival = ElasticImpact {
        effective_youngs_modulus: pair.effective_youngs_modulus,
        effective_radius: f64::from(trace.effective_radius),
        effective_mass: 1.0 / inverse_mass,
        speed: f64::from(trace.approach_speed).max(0.0),
    };
    let peak_force = trace.peak_force();
    let first_step = step - u64::from(ended.steps);
    let time_of = |step: u64| step as f64 * time_step;
    Hit {
        pellet: pellets.id[ended.pellet],
        diameter: 2.0 * pellets.position[ended.pellet][3],
        mass: pellets.mass(ended.pellet),
        partner,
        cause: match ended.partner {
            _ if peak_force > SQUEEZED * arrival.peak_force() => Cause::Squeeze,
            Partner::Pellet(_) => Cause::Collision,
            Partner::Wall(_) => Cause::Drop,
        },
        is_open: false,
        begin: time_of(first_step),
        duration: time_of(u64::from(ended.steps)),
        steps: u64::from(ended.steps),
        peak_time: time_of(first_step + u64::from(trace.steps_to_peak)),
        place: trace.place(),
        peak_force,
        sampled_force: trace.sampled_force,
        arrival_force: model.arrivals().force([material, other_material], &arrival),
        peak_pressure: arrival.pressure(peak_force),
        normal_impulse: time_step * trace.normal_forces,
        tangential_impulse: time_step * trace.tangential_forces,
        lost_energy: time_step * trace.powers,
        approach_speed: f64::from(trace.approach_speed),
        sliding_speed: f64::from(trace.sliding_speed),
        effective_radius: arrival.effective_radius,
    }
}
