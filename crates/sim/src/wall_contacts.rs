//! Contacts between pellets and walls.

use crate::contact_view::KeptContact;
use crate::hit;
use crate::meter::WallTouch;
use crate::pair_contacts::add_load;
use crate::share::Share;
use crate::state::{Row, vector};
use crate::tally::{DeepestContact, Partner};
use crate::workspace::NearWall;
use pelletflow_core::contact::batch::{Batch, LANES};
use pelletflow_core::contact::curvature;
use pelletflow_core::solid::MOST_TOUCHES;
use pelletflow_core::{Contact, ContactLaws, Surface, Vec3};
use std::ops::Range;

/// Least curvature of a contact over the pellet's own [-]: a pellet in a hollow of nearly its own radius would
/// otherwise be held by an infinite force.
pub(crate) const LEAST_CURVATURE_SHARE: f64 = 0.05;

/// Cosine between the normals of a contact in two steps below which it is another contact [-].
const SAME_CONTACT: f64 = 0.8;

/// Contacts waiting for their batch to be full.
#[derive(Debug, Clone)]
pub(crate) struct Waiting {
    batch: Batch,
    found: [Found; LANES],
    count: usize,
}

/// A contact with a wall.
#[derive(Debug, Clone, Copy, Default)]
struct Found {
    /// Place of the pellet in its chunk.
    local: usize,
    /// Index of the wall.
    wall: usize,
    /// Place of its memory.
    slot: usize,
    /// Contact point, in the world [m].
    point: Vec3,
    /// Velocity of the wall's surface there [m/s], and of its turning [rad/s].
    wall_velocity: Vec3,
    wall_spin: Vec3,
}

impl Waiting {
    fn new(laws: ContactLaws) -> Self {
        Self {
            batch: Batch::new(laws),
            found: [Found::default(); LANES],
            count: 0,
        }
    }
}

/// Adds the forces of all walls that the chunk lists.
pub(crate) fn add_forces(share: &mut Share) {
    let list = share.list;
    if list.near_walls.is_empty() {
        return;
    }
    let mut waiting = share
        .scratch
        .walls
        .take()
        .unwrap_or_else(|| Box::new(Waiting::new(share.model.laws())));
    let mut first = 0;
    let (mut mesh, mut first_triangle) = (0, 0);
    while first < list.near_walls.len() {
        let NearWall { pellet, wall } = list.near_walls[first];
        let places = first..first + share.model.touches_at(wall as usize);
        first = places.end;
        let mut triangles: &[u32] = &[];
        if share.model.touchable(wall as usize).is_mesh() {
            let end = list.near_triangle_ends[mesh] as usize;
            triangles = &list.near_triangles[first_triangle..end];
            (mesh, first_triangle) = (mesh + 1, end);
        }
        let (pellet, wall) = (pellet as usize, wall as usize);
        touch_wall(share, &mut waiting, pellet, wall, places, triangles);
    }
    work_out(share, &mut waiting);
    share.scratch.walls = Some(waiting);
}

/// Adds the forces of all contacts of one pellet with one wall, which remember in `places`; of a mesh, with the triangles
/// near the pellet.
fn touch_wall(
    share: &mut Share,
    waiting: &mut Waiting,
    local: usize,
    wall: usize,
    places: Range<usize>,
    triangles: &[u32],
) {
    let mut is_free = [true; MOST_TOUCHES];
    if share.walls[wall].is_present {
        let a = share.range.start + local;
        let row = &share.pellets.position[a];
        let (center, reach) = (vector(row), row[3] + share.model.holding_gap());
        let pose = &share.walls[wall].pose;
        let is_moving = share.model.setup().walls[wall].motion.is_moving();
        let seen = if is_moving {
            pose.inverse_point(center)
        } else {
            center
        };
        let touches = share.model.touchable(wall).touches(seen, reach, triangles);
        for &surface in touches.as_slice() {
            let surface = Surface {
                normal: if is_moving {
                    pose.direction(surface.normal)
                } else {
                    surface.normal
                },
                ..surface
            };
            let Some(place) = place_of(share, &surface, &places, &is_free) else {
                continue;
            };
            let slot = places.start + place;
            is_free[place] = !wait(share, waiting, local, wall, slot, &surface);
        }
    }
    for (slot, is_free) in places.zip(is_free) {
        if is_free && share.contacts.wall.is_open(slot) {
            end(share, local, wall, slot);
        }
    }
}

/// Ends the contact of a pellet of the chunk with a wall.
fn end(share: &mut Share, local: usize, wall: usize, slot: usize) {
    let ended = share.contacts.wall.end(slot);
    share.finish(share.range.start + local, Partner::Wall(wall), ended);
}

/// Which of the places remembers a contact: the one that was there in the last step, or else one without a memory.
fn place_of(
    share: &Share,
    surface: &Surface,
    places: &Range<usize>,
    is_free: &[bool],
) -> Option<usize> {
    if places.len() == 1 {
        return is_free[0].then_some(0);
    }
    let sameness = |place: usize| {
        let slot = places.start + place;
        if share.contacts.wall.rows[slot].steps > 0 {
            share.contacts.wall_normals[slot].dot(&surface.normal)
        } else {
            SAME_CONTACT
        }
    };
    (0..places.len())
        .filter(|&place| is_free[place] && sameness(place) >= SAME_CONTACT)
        .max_by(|&a, &b| sameness(a).total_cmp(&sameness(b)))
}

/// Effective radius of a pellet's contact with a wall, from its own radius [m].
pub(crate) fn effective_radius(radius: f64, surface: &Surface) -> f64 {
    let relative = surface.principal_curvatures.map(|of_wall| {
        // The true radius of a sharp edge is unknown; it counts as flat.
        let of_wall = if of_wall.is_finite() { of_wall } else { 0.0 };
        (1.0 / radius + of_wall).max(LEAST_CURVATURE_SHARE / radius)
    });
    curvature::effective_radius(relative)
}

/// Has a contact with a wall wait for its batch; tells whether there is one.
fn wait(
    share: &mut Share,
    waiting: &mut Waiting,
    local: usize,
    wall: usize,
    slot: usize,
    surface: &Surface,
) -> bool {
    let model = share.model;
    let a = share.range.start + local;
    let row = &share.pellets.position[a];
    let (center, radius) = (vector(row), row[3]);
    let normal = surface.normal;
    let overlap = radius - surface.distance;
    let is_held = share.contacts.wall.is_open(slot) && overlap > -model.holding_gap();
    if overlap <= 0.0 && !is_held {
        return false;
    }
    let arm = radius - 0.5 * overlap;
    let point = center - arm * normal;
    let moving = &model.setup().walls[wall];
    let (mut wall_velocity, mut wall_spin) = (Vec3::zeros(), Vec3::zeros());
    if !moving.is_still() {
        let time = share.time();
        wall_velocity = moving.surface_velocity_at(point, normal, time);
        wall_spin = moving.motion.spin(time);
    }
    let (velocity, spin) = (
        vector(&share.pellets.velocity[a]),
        vector(&share.pellets.spin[a]),
    );
    let inverse_mass = share.pellets.velocity[a][3];
    let contact = Contact {
        normal,
        overlap,
        relative_velocity: velocity - wall_velocity - arm * spin.cross(&normal),
        relative_spin: spin - wall_spin,
        effective_radius: effective_radius(radius, surface),
        effective_mass: 1.0 / inverse_mass,
        inverse_mass,
    };
    let pair = model.pair_with_wall(share.pellets.kind[a], wall);
    let lane = waiting.count;
    waiting.batch.set_contact(lane, &contact, radius, arm);
    waiting.batch.set_pair(lane, pair);
    share.contacts.wall.fill(slot, &mut waiting.batch, lane);
    waiting.found[lane] = Found {
        local,
        wall,
        slot,
        point,
        wall_velocity,
        wall_spin,
    };
    waiting.count += 1;
    share.contacts.wall_normals[slot] = normal;
    if waiting.count == LANES {
        work_out(share, waiting);
    }
    true
}

/// Works out the contacts that wait, and adds what they do.
fn work_out(share: &mut Share, waiting: &mut Waiting) {
    let model = share.model;
    let (laws, sampling) = (model.laws(), model.sampling());
    let Waiting {
        batch,
        found,
        count,
    } = waiting;
    laws.forces(batch, *count, sampling, model.instructions());
    for (lane, found) in found[..*count].iter().enumerate() {
        let memories = &mut share.contacts.wall;
        let was_open = memories.is_open(found.slot);
        if model.follows_hits() {
            let center = &share.pellets.position[share.range.start + found.local];
            hit::follow(model, memories, found.slot, (batch, lane), center);
        }
        let goes_on = memories.step(found.slot, batch, lane);
        if was_open && !goes_on {
            end(share, found.local, found.wall, found.slot);
        }
        let is_first = goes_on && !was_open;
        add_load(
            &mut share.scratch.loads[found.local],
            &batch.force(lane),
            &batch.torques(lane)[0],
        );
        enter(share, batch, lane, found, is_first);
        if share.keeps_contacts {
            keep(share, batch, lane, found);
        }
    }
    let tally = &mut share.scratch.tally;
    tally.totals.add(&batch.totals(*count));
    tally.open += *count as u64;
    tally.open_with_walls += *count as u64;
    *count = 0;
}

/// Keeps a contact for those who asked to see it.
#[cold]
#[inline(never)]
fn keep(share: &mut Share, batch: &Batch, lane: usize, found: &Found) {
    let pellet = share.range.start + found.local;
    share.scratch.kept.push(KeptContact {
        pellet,
        partner: Partner::Wall(found.wall),
        ends: [share.pellets.position[pellet], Row::default()],
        normal: batch.lie(lane).0,
        overlap: batch.overlap(lane),
        force: batch.force(lane),
    });
}

/// Enters what one contact does to its wall, and what meters see of it.
fn enter(share: &mut Share, batch: &Batch, lane: usize, found: &Found, is_first: bool) {
    let model = share.model;
    let a = share.range.start + found.local;
    let pair = model.pair_with_wall(share.pellets.kind[a], found.wall);
    let tally = &mut share.scratch.tally;
    let [x, y, z, normal_force] = batch.force(lane);
    tally.wall_force[found.wall] -= Vec3::new(x, y, z);
    if !model.setup().walls[found.wall].is_still() {
        let force = batch.contact_force(lane);
        tally.wall_power +=
            force.force.dot(&found.wall_velocity) + force.turning_torque.dot(&found.wall_spin);
    }
    let depth = DeepestContact {
        ratio: batch.overlap(lane) / share.pellets.position[a][3],
        pellet: a,
        partner: Partner::Wall(found.wall),
    };
    let limit = model.setup().limits.overlap_ratio;
    if normal_force > tally.noteworthy_force()
        || depth.ratio > tally.noteworthy_overlap_ratio(limit)
    {
        let last = batch.history(lane, model.laws());
        let about = (&batch.contact(lane), pair, &last);
        tally.look_at(model, depth, normal_force, about);
    }
    if model.is_watched(found.wall) {
        tally.wall_touches.push(WallTouch {
            wall: found.wall,
            is_first,
            point: found.point,
            velocity: vector(&share.pellets.velocity[a]) - found.wall_velocity,
            friction: pair.friction,
            contact: batch.contact(lane),
            force: batch.contact_force(lane),
        });
    }
}
