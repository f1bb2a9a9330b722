//! Chunks at rest sleep: they are not worked out until something disturbs them.
//!
//! A pellet is at rest while, for as long as it takes to fall by half its own diameter, it stays within a small distance
//! of one place: the overlap that its own weight makes. So a pellet that sleeps although it should move would
//! do so at less than two such distances over the square of that time, and creep by less than one in that time.
//! A chunk falls asleep when all its pellets are at rest and nothing that touches it has moved for as long.
//! It wakes when a pellet of another chunk comes to touch it, lets go of it, or moves by that distance while it touches.
//! What speed the pellets of a chunk had left is entered as heat.

use crate::chunk;
use crate::model::Model;
use crate::pair_contacts::open_touches;
use crate::setup::Setup;
use crate::share::Share;
use crate::state::{Pellets, Row, State};
use crate::tally::{Tally, greater};
use crate::workspace::{ChunkList, Workspace};
use pelletflow_core::contact::NormalLaw;
use std::ops::Range;

/// Steps between two looks at whether pellets have moved [-].
const STEPS_BETWEEN_LOOKS: u64 = 16;

/// When a chunk fell asleep, and what its contacts did then.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sleep {
    since: u64,
    pub(crate) tally: Tally,
}

/// A pair with a pellet of another chunk.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Border {
    own: u32,
    other: u32,
    slot: u32,
}

/// What is rest in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rest {
    /// Way that a pellet at rest stays within [m].
    pub(crate) distance: f64,
    /// For this many steps [-].
    pub(crate) steps: u64,
}

impl Rest {
    /// Rest among the pellets of a setup, none where they are never at rest.
    pub(crate) fn new(setup: &Setup, smallest: f64, largest: f64, time_step: f64) -> Option<Self> {
        let gravity = setup.gravity.norm();
        let overlaps = (0..setup.pellets.len()).map(|kind| {
            let material = setup.pellets[kind].material;
            let pair = setup.pair(material, material);
            let weight = gravity * setup.mass(kind, smallest / 2.0);
            if setup.laws.normal == NormalLaw::Linear {
                return weight / pair.linear_stiffness;
            }
            let root = (smallest / 4.0).sqrt();
            (0.75 * weight / (pair.effective_youngs_modulus * root)).powf(2.0 / 3.0)
        });
        let overlap = overlaps.fold(f64::INFINITY, f64::min);
        (setup.skips.rest && gravity > 0.0).then(|| Self {
            distance: overlap,
            steps: ((largest / gravity).sqrt() / time_step).ceil() as u64,
        })
    }
}

/// Wakes the chunks that something disturbs.
pub(crate) fn wake(model: &Model, state: &mut State, workspace: &mut Workspace) {
    if state.sleeping.iter().all(Option::is_none) {
        return;
    }
    let has_gate_moved = model.has_gate_moved(state.step);
    let count = state.pellets.len();
    let is_asleep: Vec<bool> = state.sleeping.iter().map(Option::is_some).collect();
    let size = chunk::size(count);
    let mut woken = Vec::new();
    for index in 0..is_asleep.len() {
        let Some(sleep) = &state.sleeping[index] else {
            continue;
        };
        let scratch = &workspace.chunks[index];
        let memories = &state.contacts[index].pellet;
        let is_disturbed = has_gate_moved
            || scratch.borders.iter().any(|border| {
                let other = border.other as usize;
                !is_asleep[other / size] && {
                    let is_touching = is_touching(&state.pellets, border.own as usize, other);
                    is_touching != memories.is_open(border.slot as usize)
                        || is_touching && state.pellets.anchor[other][3] > sleep.since as f64
                }
            });
        if is_disturbed {
            woken.push(index);
        }
    }
    for index in woken {
        state.sleeping[index] = None;
        let range = index * size..((index + 1) * size).min(count);
        let anchors = state.pellets.anchor[range.clone()].iter_mut();
        for (anchor, position) in anchors.zip(&state.pellets.position[range]) {
            // It may take as long as at first to get going.
            *anchor = [position[0], position[1], position[2], state.step as f64];
        }
        adopt(model, state, workspace, index, &is_asleep);
    }
}

fn borders(list: &ChunkList, range: &Range<usize>) -> Vec<Border> {
    let mut borders = Vec::new();
    for (local, ends) in list.offsets.windows(2).enumerate() {
        let slots = (ends[0]..ends[1]).map(|slot| (slot, list.partners[slot as usize]));
        borders.extend(
            slots
                .filter(|(_, other)| !range.contains(&(*other as usize)))
                .map(|(slot, other)| Border {
                    own: (range.start + local) as u32,
                    other,
                    slot,
                }),
        );
    }
    borders
}

fn is_touching(pellets: &Pellets, a: usize, b: usize) -> bool {
    let (a, b) = (&pellets.position[a], &pellets.position[b]);
    let reach = a[3] + b[3];
    distance_squared(a, b) < reach * reach
}

fn distance_squared(a: &Row, b: &Row) -> f64 {
    let (dx, dy, dz) = (a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    dx * dx + dy * dy + dz * dz
}

/// Has a chunk that wakes remember its contacts with chunks that were awake as those do: the two ends of a contact must
/// stay exact negatives.
fn adopt(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    index: usize,
    was_asleep: &[bool],
) {
    let size = chunk::size(state.pellets.len());
    let scratch = &workspace.chunks[index];
    for border in &scratch.borders {
        let (chunk, local) = (border.other as usize / size, border.other as usize % size);
        if was_asleep[chunk] {
            continue;
        }
        let list = &workspace.lists[chunk];
        let slots = list.offsets[local] as usize..list.offsets[local + 1] as usize;
        if let Ok(place) = list.partners[slots.clone()].binary_search(&border.own) {
            let [own, theirs] = state
                .contacts
                .get_disjoint_mut([index, chunk])
                .expect("a border is with another chunk");
            let slot = slots.start + place;
            own.pellet
                .adopt(border.slot as usize, &theirs.pellet, slot, model.laws());
        }
    }
    workspace.chunks[index].touches = open_touches(&workspace.lists[index], &state.contacts[index]);
}

/// Forgets which chunks slept where a search has put other pellets into them; `before` are the numbers that were there.
pub(crate) fn carry(model: &Model, state: &mut State, workspace: &mut Workspace, before: &[u32]) {
    let now = &state.pellets.id;
    let is_same_size = chunk::size(before.len()) == chunk::size(now.len());
    let ranges = chunk::ranges(now.len());
    state.sleeping.resize(ranges.len(), None);
    for ((sleep, range), list) in state.sleeping.iter_mut().zip(ranges).zip(&workspace.lists) {
        let is_same = is_same_size && before.get(range.clone()) == Some(&now[range]);
        if !is_same || is_beside_moving_wall(model, list) {
            *sleep = None;
        }
    }
    let is_order_kept = before == now.as_slice();
    let chunks = workspace.chunks.iter_mut().zip(&workspace.lists);
    let ranges = chunk::ranges(now.len()).zip(&state.sleeping);
    for ((chunk, list), (range, sleep)) in chunks.zip(ranges) {
        chunk.is_copied &= is_order_kept;
        if sleep.is_some() {
            chunk.borders = borders(list, &range);
        }
    }
}

/// Does one step of a chunk that sleeps: what its contacts did, they go on doing.
pub(crate) fn sleep_on(share: &mut Share, sleep: &Sleep) {
    share.scratch.tally.clone_from(&sleep.tally);
    if !share.scratch.is_copied {
        share.scratch.is_copied = true;
        let range = share.range.clone();
        let pellets = share.pellets;
        share
            .next_position
            .copy_from_slice(&pellets.position[range.clone()]);
        share
            .next_velocity
            .copy_from_slice(&pellets.velocity[range.clone()]);
        share.next_spin.copy_from_slice(&pellets.spin[range]);
    }
}

/// Notes which pellets have moved, and lets chunks fall asleep where none has for long.
pub(crate) fn settle(model: &Model, state: &mut State, workspace: &mut Workspace) {
    let Some(rest) = model.rest() else {
        return;
    };
    let step = state.step;
    if !step.is_multiple_of(STEPS_BETWEEN_LOOKS) && state.steps_since_search > 1 {
        return;
    }
    let count = state.pellets.len();
    let mut still = Vec::new();
    let since = step.saturating_sub(rest.steps) as f64;
    for (index, range) in chunk::ranges(count).enumerate() {
        if state.sleeping[index].is_some() {
            continue;
        }
        let farthest = rest.distance * rest.distance;
        let anchors = state.pellets.anchor[range.clone()].iter_mut();
        let mut last_moved = 0.0;
        for (anchor, position) in anchors.zip(&state.pellets.position[range.clone()]) {
            if distance_squared(anchor, position) > farthest {
                *anchor = [position[0], position[1], position[2], step as f64];
            }
            last_moved = greater(last_moved, anchor[3]);
        }
        if since > 0.0 && last_moved <= since {
            still.push((index, range));
        }
    }
    still.retain(|(index, range)| {
        let (list, touches) = (&workspace.lists[*index], &workspace.chunks[*index].touches);
        !is_beside_moving_wall(model, list) && {
            let mut others = touches
                .iter()
                .map(|touch| list.partners[touch.slot as usize] as usize)
                .filter(|other| !range.contains(other));
            others.all(|other| state.pellets.anchor[other][3] <= since)
        }
    });
    for (index, range) in still {
        fall_asleep(state, workspace, index, range);
    }
}

fn is_beside_moving_wall(model: &Model, list: &ChunkList) -> bool {
    let walls = &model.setup().walls;
    let mut near = list.near_walls.iter();
    near.any(|near| !walls[near.wall as usize].is_still())
}

fn fall_asleep(state: &mut State, workspace: &mut Workspace, index: usize, range: Range<usize>) {
    let pellets = &mut state.pellets;
    for place in range.clone() {
        let kinetic =
            stop(&mut pellets.half_step_velocity[place]) + stop(&mut pellets.half_step_spin[place]);
        state.books.energy.damped += kinetic;
        stop(&mut pellets.velocity[place]);
        stop(&mut pellets.spin[place]);
    }
    let scratch = &mut workspace.chunks[index];
    scratch.is_copied = false;
    scratch.borders = borders(&workspace.lists[index], &range);
    let mut tally = scratch.tally.clone();
    tally.be_still();
    state.sleeping[index] = Some(Sleep {
        since: state.step,
        tally,
    });
}

/// Stops a motion, and gives the energy it had, where its companion is its inertia [J].
fn stop(motion: &mut Row) -> f64 {
    let [x, y, z, inertia] = *motion;
    *motion = [0.0, 0.0, 0.0, inertia];
    0.5 * inertia * (x * x + y * y + z * z)
}
