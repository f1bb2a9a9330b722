//! Contacts that end, and those still open, as rows of the ledger.

use super::ledger::IsKept;
use super::{Cause, Hit, HitLedger, HitPartner, HitRequest, Trace};
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
    let ended = workspace.chunks.iter().flat_map(|chunk| &chunk.ended);
    enter_all(model, state, ended.copied());
}

/// Ends the contacts of pellets that are not kept.
pub(crate) fn end_leaving(model: &Model, state: &mut State, workspace: &Workspace, kept: &[u32]) {
    if !model.follows_hits() || kept.len() == state.pellets.len() {
        return;
    }
    let mut leaves = vec![true; state.pellets.len()];
    for &index in kept {
        leaves[index as usize] = false;
    }
    let ended: Vec<Ended> = open_contacts(state, &workspace.lists)
        .filter(|ended| {
            let partner_leaves = matches!(ended.partner, Partner::Pellet(other) if leaves[other]);
            leaves[ended.pellet] || partner_leaves
        })
        .collect();
    enter_all(model, state, ended);
}

/// The ledger as if every open contact ended now: its sketch with them, and of its rows only theirs.
pub(crate) fn open(model: &Model, state: &State, lists: &[ChunkList]) -> HitLedger {
    let mut ledger = state.hits.without_rows();
    if let Some(request) = &model.setup().hits {
        let mut hardest = state.pellets.hardest_hit.clone();
        for ended in open_contacts(state, lists) {
            let hit = Hit {
                is_open: true,
                ..row(model, state.step, &state.pellets, &ended)
            };
            let is_kept = endure(*request, &mut hardest, &ended, &hit);
            ledger.enter(hit, is_kept);
        }
    }
    ledger
}

/// Every open contact that a chunk counts.
fn open_contacts<'a>(state: &'a State, lists: &'a [ChunkList]) -> impl Iterator<Item = Ended> + 'a {
    let listed = state.searched_position.len();
    let chunks = chunk::ranges(listed).zip(lists).zip(&state.contacts);
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

/// Enters contacts that end before the coming step.
fn enter_all(model: &Model, state: &mut State, all: impl IntoIterator<Item = Ended>) {
    let Some(request) = &model.setup().hits else {
        return;
    };
    for ended in all {
        let hit = row(model, state.step, &state.pellets, &ended);
        let is_kept = endure(*request, &mut state.pellets.hardest_hit, &ended, &hit);
        state.hits.enter(hit, is_kept);
    }
}

/// Notes what the pellets of a hit have endured; the hit is kept if it is new to one of them, or reaches the threshold.
fn endure(request: HitRequest, hardest: &mut [f64], ended: &Ended, hit: &Hit) -> IsKept {
    let other = match ended.partner {
        Partner::Pellet(other) => Some(other),
        Partner::Wall(_) => None,
    };
    let mut is_kept = IsKept::InSums;
    if hit.peak_force >= request.threshold {
        is_kept = IsKept::InFull;
    }
    for pellet in std::iter::once(ended.pellet).chain(other) {
        if hit.peak_force > hardest[pellet] {
            hardest[pellet] = hit.peak_force;
            is_kept = IsKept::InFull;
        }
    }
    is_kept
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
    let [arrival_force, arrival_pressure] = model
        .arrivals()
        .force_and_pressure([material, other_material], &arrival);
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
        arrival_force,
        arrival_pressure,
        peak_pressure: arrival.pressure(peak_force),
        normal_impulse: time_step * trace.normal_forces,
        tangential_impulse: time_step * trace.tangential_forces,
        lost_energy: time_step * trace.powers,
        approach_speed: f64::from(trace.approach_speed),
        sliding_speed: f64::from(trace.sliding_speed),
        effective_radius: arrival.effective_radius,
    }
}
